// The page that shows which options the hardware renderer honours is what the program's tables say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/atomic_file.h"
#include "base/read_file.h"
#include "base/resources.h"
#include "hardware/lacks.h"
#include "hardware/picture_plan.h"
#include "hardware/renderer.h"
#include "options/option.h"
#include "options/scene_settings.h"

namespace ps::option_page_test {
namespace {

constexpr std::string_view head = R"(# What the hardware renderer honours

Made from the program's own tables by `assets/gallery/make --hardware-options`, and checked by a test. What is honoured is
compared with the rasterizer by `tests/agreement/hardware`. "By gl_FragDepth" means that the fragment shader writes a
depth that no driver interpolates. Depths of 1 / z are interpolated by the driver where it has `ARB_clip_control`, and
otherwise written by the shader, too.

| option | choice | honoured | reason |
|---|---|---|---|
)";

constexpr std::string_view agreement = R"(
## How far its pictures agree

At most 20 of 360,000 pixels show another triangle than the rasterizer's with as many sub-pixel bits, and at most as many
a colour more than one level of 255 away. `tests/agreement/hardware` holds this for 24 scenes and each value above, with
Mesa's llvmpipe. More pixels differ where the last bit decides:

| where | why |
|---|---|
| nearest texels | A sample on the border of two texels gets one of them by the last bit of its coordinates. |
| `hardware-texturing = driver` | The driver's filter has levels and weights of its own. |
| anisotropy | The number of lookups is rounded up. Where the sides of a footprint have a whole ratio, its last bit decides. |
| shadow maps | A point on the border of two texels of the map is lit or not by the last bit. |
| stencil shadows | The driver rounds the vertices of shadow volumes, too, so outlines move within a sub-pixel. |
| surfaces within a step of the depth buffer | Their depths are rounded to different steps, so another one is seen. |
| triangles that leave the picture | Some drivers cut them at its border and round the new vertices, so edges turn a little. |
)";

/// Does the fragment shader write the depth under these settings, whatever the driver offers?
bool writes_depth(const Settings& settings) {
  hardware::PicturePlan plan;
  plan.settings = settings;
  plan.depth = raster::make_depth_code(settings, 1);
  return !driver_keeps_depth(plan, true);
}

std::string row(const Option& option, std::string_view choice, std::string_view honoured, std::string_view reason) {
  return fmt::format("| `{}` | {} | {} | {} |\n", option.key, choice, honoured, reason);
}

/// What one value is honoured by, if it is.
std::string honoured_row(const Option& option, const Settings& settings, const std::string& text) {
  if (option.key == "shadows" && settings.shadows == Shadows::traced)
    return row(option, text, "no", "traced shadows need rays, and no renderer of triangles has them");
  if (const auto reason = hardware::lacks_value(option, option.get(settings), settings))
    return row(option, text, "no", reason->text());
  if (writes_depth(settings) && !writes_depth({})) return row(option, text, "by gl_FragDepth", "");
  const bool near_only = option.key == "clipping" && settings.clipping == Clipping::near_only;
  return row(option, text, "yes", near_only ? "where a driver cuts at the sides as well, no pixel shows it" : "");
}

/// The values of a number, in runs that are lacked for the same reason or not at all.
std::string rows_of_integer(const Option& option) {
  std::string rows;
  Settings settings;
  const auto reason_of = [&](int value) {
    option.set(settings, value);
    return text_of(hardware::lacks_value(option, value, settings));
  };
  const int last = static_cast<int>(option.maximum);
  for (int from = static_cast<int>(option.minimum); from <= last;) {
    const std::string reason = reason_of(from);
    int to = from;
    while (to < last && reason_of(to + 1) == reason) ++to;
    rows += row(option, from == to ? fmt::format("{}", from) : fmt::format("{} to {}", from, to),
                reason.empty() ? "yes" : "no", reason);
    from = to + 1;
  }
  return rows;
}

std::string rows_of(const Option& option) {
  if (const auto reason = hardware::lacks_option(option, {})) return row(option, "all", "no", reason->text());
  if (option.key == "multisampling") return row(option, "all", "yes", "as many samples as the driver offers");
  if (option.key == "anisotropy")
    return row(
        option, "all", "yes",
        "with hardware-texturing = driver by the extension EXT_texture_filter_anisotropic, where the driver has it");
  if (option.key == "depth-bits")
    return row(option, "all", "yes",
               "24, and 16 with a single pass, in a buffer of that format; others by gl_FragDepth");
  switch (option.kind) {
  case OptionKind::real:
    return row(option, "all", "yes", "");
  case OptionKind::integer:
    return rows_of_integer(option);
  case OptionKind::boolean:
  case OptionKind::choice:
    break;
  }
  std::string rows;
  const std::size_t count = option.kind == OptionKind::boolean ? 2 : option.choices.size();
  for (std::size_t i = 0; i < count; ++i) {
    Settings settings;
    option.set(settings, static_cast<double>(i));
    rows += honoured_row(option, settings, "`" + option_text(option, settings) + "`");
  }
  return rows;
}

/// Each choice of each option that renderers of fragments use, and whether this one honours it, by a depth that the
/// fragment shader writes (gl_FragDepth), by an extension, or not, with the reason. The same on every machine: what
/// depends on the driver is named so.
std::string option_page() {
  const RendererKind kind = hardware_renderer_kind();
  std::string page(head);
  for (const Option& option : option_table()) {
    const bool own = kind.reads(option, {}, {}).value_or(false);
    if (option.key == "renderer" || !(own || acts_for(option.acts_for, PictureWay::fragments))) continue;
    if (option.effect == OptionEffect::picture) page += rows_of(option);
  }
  page +=
      "\nSome choices are honoured together with others only: shadow maps with light computed at vertices need a depth "
      "buffer, and deferred shading with light computed at vertices has no shadows. Where a material has a picture of "
      "its "
      "surroundings, its surfaces are shaded as they are drawn, also with deferred shading.\n";
  page += agreement;
  return page;
}

/// With PIXELSCOPE_HARDWARE_OPTIONS=FILE writes the page, for assets/gallery/make.
TEST(HardwareOptionPage, IsWhatTheTablesSay) {
  const std::string page = option_page();
  if (const char* file = std::getenv("PIXELSCOPE_HARDWARE_OPTIONS")) return write_file_atomically(file, page);
  EXPECT_EQ(read_whole_file(asset_dir() / "gallery/hardware-options.md"), page)
      << "assets/gallery/make --hardware-options writes it again";
  for (const char* row : {"| `shadows` | `stencil-depth-fail` | yes |", "| `depth-value` | `z` | by gl_FragDepth |",
                          "| `stencil-bits` | 9 to 16 | no |", "| `deferred-shading` | `on` | yes |"})
    EXPECT_NE(page.find(row), std::string::npos) << row;
}

}  // namespace
}  // namespace ps::option_page_test
