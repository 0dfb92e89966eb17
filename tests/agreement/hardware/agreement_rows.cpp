// What is compared, and why more than the bound differs where it does. Each sentence was found by the split into
// causes, or by changing the option that it names.
#include <fmt/format.h>

#include "agreement/hardware/agreement_matrix.h"

namespace ps::test {
namespace {

constexpr const char* step_of_depth = "The sheets are nearer to each other than a step of the depth buffer. Another "
                                      "one is seen where the driver's depth and "
                                      "the rasterizer's are rounded to different steps.";
constexpr const char* border_of_texels =
    "Where a sample lies on the border of two texels, the last bits of its texture coordinates decide between them.";
constexpr const char* whole_ratio = "The number of lookups is rounded up, and where the sides of a footprint have a "
                                    "whole ratio, as on a wall that faces "
                                    "the camera, its last bit decides.";
constexpr const char* own_filter =
    "The driver has its own filter: its levels and weights are not those of the formula.";
constexpr const char* cut_floor = "The floor is cut at the border of the picture with vertices rounded to sub-pixels, "
                                  "so samples within 0.001 pixels of "
                                  "its diagonal show the other triangle.";
constexpr const char* edges_of_volumes = "The driver rounds the vertices of shadow volumes, too, so outlines move "
                                         "within a sub-pixel. The red sphere's centre "
                                         "lies 0.0009 above the ground, where their depths tie.";
constexpr const char* other_texels = "The driver interpolates positions from vertices that it has not rounded, and "
                                     "some fall on the next texel of the map. "
                                     "Red sphere and ground tie as above.";
constexpr const char* far_edge = "The far edge of the floor lies on y = 337.5, exactly on samples, and so does a face "
                                 "of its own shadow volume. Rounding "
                                 "decides on which side of it they are.";
constexpr const char* coarse_float = "Near 1 a depth in float, which the driver interpolates, has steps as wide as "
                                     "those of 24 bits; the rasterizer computes "
                                     "it from 1 / z in double.";

}  // namespace

std::string MatrixRow::name() const {
  return assignments.empty() ? scene : fmt::format("{} {}", scene, fmt::join(assignments, " "));
}

std::string RayRow::name() const { return MatrixRow{scene, assignments}.name(); }

std::vector<MatrixRow> scene_rows() {
  std::vector<MatrixRow> rows;
  for (const char* scene :
       {"cgfs/shading",       "cgfs/reflections",  "cgfs/crates",    "cgfs/cubes",      "cgfs/primitives",
        "cgfs/brick-wall",    "cgfs/fence",        "cgfs/relief",    "cgfs/depth",      "cgfs/behind",
        "cgfs/near-light",    "cgfs/camera",       "cgpp/teapot",    "cgpp/triangle",   "cgpp/ground",
        "octree/attenuation", "octree/headline",   "lab/far-origin", "lab/flattened",   "lab/depth-complexity",
        "lab/hierarchy",      "lab/inside-shadow", "lab/cornell",    "lab/mirror-room", "models/dice"})
    rows.push_back({scene, {}, 600});
  rows.push_back({"lab/z-fighting", {}, 600, step_of_depth});
  return rows;
}

std::vector<MatrixRow> option_rows() {
  std::vector<MatrixRow> rows;
  for (const char* option :
       {"shading=gouraud", "shading=flat", "projection=orthographic", "deferred-shading=on", "light-passes=many",
        "interpolation=affine", "near=3.2", "depth-value=distance", "depth-format=unorm"})
    for (const char* scene : {"cgfs/shading", "cgfs/crates"}) rows.push_back({scene, {option}});
  for (const char* option : {"texture-filter=bilinear", "texture-filter=mipmap", "mip-bias=-2"})
    for (const char* scene : {"cgfs/crates", "cgfs/fence"}) rows.push_back({scene, {option}});
  rows.push_back({"lab/z-fighting", {"depth-format=plain"}});
  rows.push_back({"lab/z-fighting", {"depth-bits=24"}, 300, coarse_float});
  for (const char* scene : {"cgfs/crates", "cgfs/fence"}) {
    rows.push_back({scene, {"multisampling=4"}});
    rows.push_back({scene, {"texture-filter=nearest"}, 300, border_of_texels});
    rows.push_back({scene, {"hardware-texturing=driver"}, 300, own_filter});
  }
  rows.push_back({"cgfs/crates", {"anisotropy=16"}, 300, whole_ratio});
  rows.push_back({"cgfs/fence", {"anisotropy=16"}});
  for (const char* method : {"shadows=stencil-depth-fail", "shadows=stencil-depth-pass"}) {
    rows.push_back({"cgfs/shadows", {method}, 600, edges_of_volumes, Explained::for_driver});
    rows.push_back({"octree/attenuation", {method}, 600});
  }
  rows.push_back({"lab/inside-shadow", {"shadows=stencil-depth-fail"}, 600, far_edge});
  rows.push_back({"lab/inside-shadow", {"shadows=stencil-depth-pass"}, 600});
  rows.push_back({"octree/attenuation", {"shadows=stencil-depth-fail", "shading=flat"}, 300, cut_floor});
  const std::vector<std::string> biased{"shadows=map", "shadow-bias=0.01", "shadow-slope-bias=2"};
  for (const auto& map : {std::vector<std::string>{"shadows=map"}, biased}) {
    rows.push_back({"cgfs/shadows", map, 600, other_texels, Explained::for_driver});
    for (const char* scene : {"octree/attenuation", "lab/cornell"}) rows.push_back({scene, map, 600});
  }
  for (const char* scene : {"cgfs/reflections", "lab/mirror-room", "cgfs/mirrors"})
    rows.push_back({scene, {"environment=cube-map"}, 600});
  return rows;
}

std::vector<RayRow> ray_rows() {
  const std::string round =
      "Spheres are drawn as triangles within them, up to half a pixel away (option tessellation), so their outlines "
      "differ.";
  return {{"cgfs/cubes", {"shadows=none", "reflection-depth=0"}, "Vertices are rounded to sub-pixels."},
          {"cgpp/teapot", {"shadows=none", "reflection-depth=0"}, "Vertices are rounded to sub-pixels."},
          {"cgfs/spheres", {"shadows=none", "reflection-depth=0"}, round},
          {"cgfs/spheres",
           {"shadows=none", "reflection-depth=0", "tessellation=0.1"},
           "With finer triangles less differs."},
          {"cgfs/crates",
           {"shadows=none", "reflection-depth=0"},
           "The ray tracer has no footprint of a pixel, so it reads textures without mipmaps."},
          {"cgfs/crates",
           {"shadows=none", "reflection-depth=0", "texture-filter=bilinear"},
           "Read without mipmaps by all, textures differ in the last bits of their coordinates."},
          {"cgfs/shadows",
           {"shadows=traced", "reflection-depth=0"},
           "Traced shadows need rays, and without them the renderers of triangles leave the shadows out."},
          {"cgfs/shadows",
           {"shadows=map", "reflection-depth=0"},
           "A shadow map has texels, so the borders of its shadows are not where those of rays are."},
          {"cgfs/reflections",
           {"shadows=none", "reflection-depth=3"},
           "Reflections need rays, and without an environment map the renderers of triangles leave them out."}};
}

}  // namespace ps::test
