#include "hardware/option_page.h"

#include <fmt/format.h>

#include <vector>

#include "hardware/lacks.h"
#include "hardware/picture_plan.h"
#include "hardware/renderer.h"
#include "options/option.h"
#include "options/scene_settings.h"

namespace ps::hardware {
namespace {

constexpr std::string_view head = R"(# What the hardware renderer honours

Made from the program's own tables by `assets/gallery/make --hardware-options`, and checked by a test. What is honoured is
compared with the rasterizer by `tests/agreement/hardware`. "By gl_FragDepth" means that the fragment shader writes a
depth that no driver interpolates. Depths of 1 / z are interpolated by the driver where it has `ARB_clip_control`, and
otherwise written by the shader, too.

| option | choice | honoured | reason |
|---|---|---|---|
)";

/// Does the fragment shader write the depth under these settings, whatever the driver offers?
bool writes_depth(const Settings& settings) {
  PicturePlan plan;
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
  if (const auto reason = lacks_value(option, option.get(settings), settings)) return row(option, text, "no", *reason);
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
    return lacks_value(option, value, settings);
  };
  const int last = static_cast<int>(option.maximum);
  for (int from = static_cast<int>(option.minimum); from <= last;) {
    const auto reason = reason_of(from);
    int to = from;
    while (to < last && reason_of(to + 1) == reason) ++to;
    rows += row(option, from == to ? fmt::format("{}", from) : fmt::format("{} to {}", from, to), reason ? "no" : "yes",
                reason.value_or(""));
    from = to + 1;
  }
  return rows;
}

std::string rows_of(const Option& option) {
  if (const auto reason = lacks_option(option, {})) return row(option, "all", "no", *reason);
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

}  // namespace

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
  return page;
}

}  // namespace ps::hardware
