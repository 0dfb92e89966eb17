#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "options/renderer_kind.h"
#include "render/renderer_table.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::driver_edges {
namespace {

constexpr int side = 200, texels = 128;

/// A tilted plane of bricks, seen without lights. All of it is magnified or nearly so: away from jumps both read level
/// 0 or 1.
std::string bricks_text(double depth) {
  return fmt::format(R"(canvas_size = {0} x {0}
viewport_size = 1 x 1
projection_plane_d = 1
background = black
texture {{ name = picture  generator = bricks  size = {1} }}
texture {{ name = heights  generator = brick-heights  size = {1} }}
material {{ name = paved  color = white  texture = picture  height_map = heights  relief_depth = {2} }}
model {{
    name = plane
    materials = [paved]
    vertices {{
        0 = (-0.9, -0.45, 2)
        1 = ( 0.9, -0.45, 2)
        2 = ( 0.9, 0.75, 3.6)
        3 = (-0.9, 0.75, 3.6)
    }}
    triangles {{
        0 = {{ vertices = [0, 3, 2]  uvs = [(0, 0.6), (0, 0), (0.6, 0)] }}
        1 = {{ vertices = [0, 2, 1]  uvs = [(0, 0.6), (0.6, 0), (0.6, 0.6)] }}
    }}
}}
instance {{ model = plane }}
)",
                     side, texels, depth);
}

Settings brick_settings(Renderer renderer, HardwareTexturing texturing) {
  Settings settings;
  settings.renderer = renderer;
  settings.hardware_texturing = texturing;
  settings.lighting = false;
  settings.backface_culling = false;
  settings.near = 0.01;
  settings.texture_filter = TextureFilter::mipmap;
  settings.parallax = Parallax::occlusion;
  return settings;
}

/// Where a block of 2 x 2 pixels lies.
enum class BlockKind { outside, inside, jump, outline };

BlockKind kind_of(const Frame& frame, int left, int top) {
  constexpr double jump = 2.5;  // texels from one pixel to the next; without a relief two at most
  int seen = 0;
  for (int k = 0; k < 4; ++k) seen += frame.ids.at(left + k % 2, top + k / 2).object >= 0 ? 1 : 0;
  if (seen == 0) return BlockKind::outside;
  if (seen < 4) return BlockKind::outline;
  const auto step = [&](int x, int y, int dx, int dy) {
    const Vec2f off = frame.uv.at(left + x + dx, top + y + dy) - frame.uv.at(left + x, top + y);
    return texels * static_cast<double>(glm::length(off));
  };
  const double largest = std::max({step(0, 0, 1, 0), step(0, 1, 1, 0), step(0, 0, 0, 1), step(1, 0, 0, 1)});
  return largest > jump ? BlockKind::jump : BlockKind::inside;
}

/// RMSE in levels of 255 against the rasterizer, over the blocks of one kind; nothing if there are none. Pixels count
/// whose texture coordinates are the rasterizer's within a quarter of a texel: the level alone makes the difference.
std::optional<double> colour_error(const Frame& drawn, const Frame& ours, BlockKind kind) {
  double sum = 0, pixels = 0;
  for (int top = 0; top < side; top += 2)
    for (int left = 0; left < side; left += 2) {
      if (kind_of(ours, left, top) != kind) continue;
      for (int k = 0; k < 4; ++k) {
        const int x = left + k % 2, y = top + k / 2;
        if (drawn.ids.at(x, y) != ours.ids.at(x, y) || ours.ids.at(x, y).object < 0) continue;
        if (texels * glm::length(drawn.uv.at(x, y) - ours.uv.at(x, y)) > 0.25f) continue;
        const Vec3f off = 255.0f * (drawn.colour.at(x, y) - ours.colour.at(x, y));
        sum += static_cast<double>(dot(off, off)) / 3;
        ++pixels;
      }
    }
  if (pixels == 0) return {};
  return std::sqrt(sum / pixels);
}

constexpr std::array depths{0.0, 0.02, 0.05, 0.1, 0.15, 0.2};
constexpr std::array frames{0.02, 0.05, 0.1, 0.15, 0.2};

std::vector<StabilityRow> measure_edges(const StabilityRun& run) {
  Rows rows(run);
  for (const double depth : depths) {
    const Scene scene = parse_scene(bricks_text(depth), "bricks", {});
    const auto draw = [&](Renderer renderer, HardwareTexturing texturing) {
      return picture_of(scene, {scene.camera, side, side}, brick_settings(renderer, texturing),
                        Channel::ids | Channel::uv, run);
    };
    const Frame ours = draw(renderer_for(PictureWay::fragments), HardwareTexturing::shader);
    const Frame driver = draw(driver_renderer().value(), HardwareTexturing::driver);
    const Frame shader = draw(driver_renderer().value(), HardwareTexturing::shader);
    for (const auto& [name, kind] : {std::pair{"at jumps", BlockKind::jump},
                                     {"elsewhere", BlockKind::inside},
                                     {"at the outline", BlockKind::outline}}) {
      const auto naive = colour_error(driver, ours, kind), robust = colour_error(shader, ours, kind);
      if (naive && robust) rows.push_back({depth, name, *naive, *robust, "RMSE, levels of 255"});
    }
  }
  return rows;
}

StabilityPicture picture_of_bricks(double depth) {
  StabilityPicture picture{.scene = bricks_text(depth), .width = side, .height = side};
  picture.naive = brick_settings(driver_renderer().value(), HardwareTexturing::driver);
  picture.robust = brick_settings(driver_renderer().value(), HardwareTexturing::shader);
  return picture;
}

}  // namespace

static constexpr StabilitySeries driver_edges_series[]{
    {.names = "at jumps",
     .title = "difference from the rasterizer where texture coordinates jump (RMSE)",
     .unit = "levels of 255"},
    {.names = "elsewhere", .title = "difference from the rasterizer elsewhere (RMSE)", .unit = "levels of 255"},
    {.names = "at the outline",
     .title = "difference from the rasterizer at the outline of the triangles (RMSE)",
     .unit = "levels of 255"},
};

extern const StabilityExperiment driver_edges{
    .key = "driver-edges",
    .place = {Subject::sampling, 66},
    .title = "Derivatives of a graphics driver at edges",
    .keywords = "dFdx, dFdy, quad, helper invocation, seam, discontinuity, parallax occlusion mapping, mipmap artefact",
    .knob = "depth of the relief (widths of its texture)",
    .naive = "the driver's differences between pixels",
    .robust = "the formula's derivatives of the flat surface",
    .explanation =
        "A graphics driver takes the level of detail from differences of texture coordinates within 2 x 2 pixels. "
        "At the edge of a brick parallax mapping makes them jump, so a coarse level is read: a line of wrong colour. "
        "Without a relief nothing jumps, not even at the outline of a triangle: the driver continues it beyond.",
    .safe = "Texture coordinates that are continuous.",
    .window = {nowhere, 0},
    .series = driver_edges_series,
    .measure = measure_edges,
    .picture = picture_of_bricks,
    .measures_driver = true,
    .frames = frames};

}  // namespace ps::stability::driver_edges
