#include <array>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "options/renderer_kind.h"
#include "render/renderer_table.h"
#include "scene/scene_file.h"
#include "study/stability/support.h"

namespace ps::stability::driver_depth {
namespace {

constexpr int side = 128;
constexpr double depth = 1000, slant = 100;  // of the sheets' centre, and how much deeper their right edge is

/// Two sheets across the picture, the near one drawn last. They are slanted, so that each column has depths of its own.
std::string sheets_text(double gap) {
  std::string text = fmt::format(R"(canvas_size = {0} x {0}
viewport_size = 1 x 1
projection_plane_d = 1
background = black
)",
                                 side);
  for (const auto& [name, offset, colour] : {std::tuple{"back", gap, "blue"}, std::tuple{"front", 0.0, "yellow"}}) {
    std::string vertices;
    int number = 0;
    for (const auto& [x, y] : std::array<std::array<double, 2>, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}})
      vertices += fmt::format("{} = ({}, {}, {})\n", number++, 0.8 * depth * x, 0.8 * depth * y,
                              depth + slant * (x + 0.3 * y) + offset);
    text += fmt::format(R"(model {{
    name = {0}
    color = {1}
    vertices {{
        {2}
    }}
    triangles {{
        0 = {{ vertices = [0, 1, 2] }}
        1 = {{ vertices = [0, 2, 3] }}
    }}
}}
instance {{
    model = {0}
}}
)",
                        name, colour, vertices);
  }
  return text;
}

struct Format {
  const char* name;
  DepthFormat format;
  int bits;
  bool reversed;
};
constexpr Format bits_24{"24 bits", DepthFormat::unorm, 24, false}, bits_16{"16 bits", DepthFormat::unorm, 16, false},
    reversed_float{"reversed float", DepthFormat::unit_float, 24, true};

Settings sheet_settings(Renderer renderer, const Format& format) {
  Settings settings;
  settings.renderer = renderer;
  settings.lighting = false;
  settings.backface_culling = false;
  settings.near = 0.1;
  settings.far = 10000;
  settings.depth_format = format.format;
  settings.depth_bits = format.bits;
  settings.depth_reversed = format.reversed;
  return settings;
}

double wrong(double gap, const Settings& settings, const StabilityRun& run) {
  const Scene scene = parse_scene(sheets_text(gap), "sheets", {});
  const Frame frame = picture_of(scene, {scene.camera, side, side}, settings, Channel::ids, run);
  double back = 0;
  for (const PixelId& id : frame.ids.pixels()) back += id.object == 0 ? 1 : 0;
  return percent(back, side * side);
}

constexpr std::array gaps{0.001, 0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0};

std::vector<StabilityRow> measure_sheets(const StabilityRun& run) {
  Rows rows(run);
  const Renderer driver = driver_renderer().value(), own = renderer_for(PictureWay::fragments);
  for (const Format& format : {bits_24, bits_16})
    for (const double gap : gaps)
      for (const auto& [name, renderer] : {std::pair{"driver", driver}, std::pair{"ours", own}})
        rows.push_back(
            {gap, fmt::format("{}, {}", format.name, name), wrong(gap, sheet_settings(renderer, format), run),
             wrong(gap, sheet_settings(renderer, reversed_float), run), "% of pixels that show the sheet behind"});
  return rows;
}

StabilityPicture picture_sheets(double gap) {
  StabilityPicture picture{.scene = sheets_text(gap)};
  picture.naive = sheet_settings(driver_renderer().value(), bits_24);
  picture.robust = sheet_settings(driver_renderer().value(), reversed_float);
  return picture;
}

constexpr std::array shown_gaps{0.001, 0.01, 0.1, 0.3, 1.0};

}  // namespace

static constexpr StabilitySeries driver_depth_series[]{
    {.names = "24 bits, driver|24 bits, ours|*", .title = "pixels that show the sheet behind", .unit = "%"},
};

extern const StabilityExperiment driver_depth{
    .key = "driver-depth",
    .place = {Subject::depth, 55},
    .title = "Depth formats of a graphics driver",
    .keywords = "z-buffer, zbuffer, depth buffer, z-fighting, hardware, OpenGL, reversed z, GL_DEPTH_COMPONENT",
    .knob = "gap between the two sheets (world units)",
    .naive = "depth in 24 or 16 bits",
    .robust = "reversed float",
    .explanation =
        "Two sheets lie 1,000 units away, with the near plane at 0.1. Below the width of a depth code, the rasterizer "
        "gives both the same code, and the sheet that is drawn first stays. The driver's depths of the two may still "
        "differ, one way or the other from pixel to pixel, so that either sheet shows. In a reversed float buffer both "
        "renderers keep them apart.",
    .safe = "Gaps above z^2 / (near 2^bits).",
    .window = {1, everywhere},
    .series = driver_depth_series,
    .measure = measure_sheets,
    .picture = picture_sheets,
    .measures_driver = true,
    .frames = shown_gaps};

}  // namespace ps::stability::driver_depth
