#include "agreement/hardware/agreement_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "frame/display_frame.h"
#include "hardware/gl_thread.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"

namespace ps::test {
namespace {

Settings settings_of(const Scene& scene, const std::vector<std::string>& assignments) {
  Settings settings = settings_for(scene);
  for (const std::string& assignment : assignments) parse_assignment(assignment, settings);
  return settings;
}

std::string joined(const std::string& scene, const std::vector<std::string>& assignments) {
  return assignments.empty() ? scene : fmt::format("{} {}", scene, fmt::join(assignments, " "));
}

}  // namespace

std::string MatrixRow::name() const { return joined(scene, assignments); }

std::vector<MatrixRow> matrix_rows() {
  std::vector<MatrixRow> rows;
  for (const char* scene :
       {"cgfs/shading", "cgfs/reflections", "cgfs/crates", "cgfs/cubes", "cgfs/primitives", "cgfs/brick-wall",
        "cgfs/fence", "cgfs/relief", "cgfs/depth", "cgfs/behind", "cgfs/near-light", "cgfs/camera", "cgpp/teapot", "cgpp/triangle",
        "cgpp/ground", "octree/attenuation", "octree/headline", "lab/far-origin", "lab/depth-complexity",
        "lab/flattened", "lab/hierarchy", "lab/inside-shadow", "lab/cornell", "lab/mirror-room", "lab/z-fighting", "models/dice"})
    rows.push_back({scene, {"shadows=none"}});
  const auto add = [&](const char* scene, std::vector<std::string> assignments) {
    rows.push_back({scene, std::move(assignments)});
    rows.back().side = 300;
  };
  for (const char* option : {"shading=gouraud", "shading=flat", "projection=orthographic", "deferred-shading=on", "light-passes=many", "interpolation=affine", "near=3.2", "depth-value=distance", "depth-format=unorm"})
    for (const char* scene : {"cgfs/shading", "cgfs/crates"}) add(scene, {"shadows=none", option});
  for (const char* option : {"texture-filter=nearest", "texture-filter=bilinear", "texture-filter=mipmap", "anisotropy=16", "mip-bias=-2", "hardware-texturing=driver", "multisampling=4"})
    for (const char* scene : {"cgfs/crates", "cgfs/fence"}) add(scene, {"shadows=none", option});
  for (const char* scene : {"cgfs/shadows", "octree/attenuation", "lab/inside-shadow"})
    for (const char* option : {"shadows=stencil-depth-fail", "shadows=stencil-depth-pass"}) add(scene, {option});
  add("octree/attenuation", {"shadows=stencil-depth-fail", "shading=flat"});
  for (const char* scene : {"cgfs/shadows", "octree/attenuation", "lab/cornell"}) {
    add(scene, {"shadows=map"});
    add(scene, {"shadows=map", "shadow-bias=0.01", "shadow-slope-bias=2"});
  }
  for (const char* scene : {"cgfs/reflections", "lab/mirror-room", "cgfs/mirrors"}) add(scene, {"shadows=none", "environment=cube-map"});
  return rows;
}

std::vector<RayRow> ray_rows() {
  return {{"cgfs/shading", {"shadows=none", "reflection-depth=0"}, ""},
          {"cgfs/spheres", {"shadows=none", "reflection-depth=0"}, ""},
          {"cgfs/cubes", {"shadows=none", "reflection-depth=0"}, ""},
          {"cgpp/teapot", {"shadows=none", "reflection-depth=0"}, ""},
          {"cgfs/crates", {"shadows=none", "reflection-depth=0"}, ""},
          {"cgfs/shadows", {"shadows=traced", "reflection-depth=0"}, ""},
          {"cgfs/shadows", {"shadows=map", "reflection-depth=0"}, ""},
          {"cgfs/reflections", {"shadows=none", "reflection-depth=3"}, ""},
          {"lab/cornell", {"shadows=none", "reflection-depth=0"}, ""}};
}

MeasuredRow measure(const MatrixRow& row, Renderer hardware, const std::string& snapping) {
  const Scene scene = load_scene(row.scene);
  StageRequest request;
  request.scene = scene;
  request.view = {scene.camera, row.side, row.side};
  request.other = settings_of(scene, {"reflection-depth=0", "environment=none", "vertex-snapping=" + snapping});
  for (const std::string& assignment : row.assignments) parse_assignment(assignment, request.other);
  request.ours = request.other;
  request.other.renderer = hardware;
  request.ours.renderer = renderer_for(PictureWay::fragments);
  request.ours.subpixel_bits = hardware::availability().driver->subpixel_bits;
  request.other.subpixel_bits = request.ours.subpixel_bits;
  StudyControl control;
  MeasuredRow measured;
  measured.pixels = long{row.side} * row.side;
  measured.split = split_by_stage(request, control);
  return measured;
}

RayDifference against_rays(const RayRow& row, Renderer renderer) {
  const Scene scene = load_scene(row.scene);
  Settings settings = settings_of(scene, row.assignments);
  const View view{scene.camera, 300, 300};
  RenderRequest request;
  request.channels = Channel::ids;
  Prepared prepared;
  Progress progress;
  settings.renderer = renderer_for(PictureWay::rays);
  const Frame rays = render(scene, view, settings, request, prepared, progress);
  const Image<Rgb8> a = display_frame(rays, settings);
  settings.renderer = renderer;
  const Frame drawn = render(scene, view, settings, request, prepared, progress);
  const Image<Rgb8> b = display_frame(drawn, settings);
  RayDifference difference;
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgb8 p = a.pixels()[i], q = b.pixels()[i];
    ++difference.pixels;
    difference.ids += rays.ids.pixels()[i] != drawn.ids.pixels()[i];
    int largest = 0;
    for (const int d : {p.r - q.r, p.g - q.g, p.b - q.b}) {
      largest = std::max(largest, std::abs(d));
      squares += double{static_cast<double>(d)} * d;
    }
    difference.colours += largest > 1;
  }
  difference.rms = std::sqrt(squares / (3.0 * static_cast<double>(difference.pixels)));
  return difference;
}

}  // namespace ps::test
