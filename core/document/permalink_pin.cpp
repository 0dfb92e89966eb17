// The fields of a permalink for a pinned pixel: "pin=312,204&pin.a.reflection-depth=1". Like the rest of it, only what
// differs from the defaults.
#include <fmt/format.h>

#include "base/check.h"
#include "document/number_list.h"
#include "document/permalink_field.h"
#include "options/option.h"

namespace ps::detail {
namespace {

constexpr std::string_view option_of_a = "a.", option_of_b = "b.", edit_of = "edit.";

}  // namespace

void add_pin(const Pin& pin, const AddPart& add) {
  add("pin", fmt::format("{},{}", pin.pixel.x, pin.pixel.y));
  if (pin.width > 0 || pin.height > 0) add("pin.size", fmt::format("{}x{}", pin.width, pin.height));
  if (pin.camera) add("pin.camera", camera_text(*pin.camera));
  for (const SceneEdit& edit : pin.edits) add(fmt::format("pin.{}{}", edit_of, edit.path), edit.value);
  add_options(fmt::format("pin.{}", option_of_a), pin.a, add);
  add_options(fmt::format("pin.{}", option_of_b), pin.b, add);
}

void parse_pin(std::string_view part, std::string_view value, std::optional<Pin>& pin) {
  if (part.empty()) {
    pin.emplace();
    pin->pixel = parse_pixel_text(value);
    return;
  }
  if (!pin) throw InputError(fmt::format("permalink: found pin.{}, expected pin=X,Y before it", part));
  const auto assignment = [&](std::string_view prefix) {
    return fmt::format("{}={}", part.substr(prefix.size()), value);
  };
  if (part.starts_with(option_of_a)) return parse_assignment(assignment(option_of_a), pin->a);
  if (part.starts_with(option_of_b)) return parse_assignment(assignment(option_of_b), pin->b);
  if (part.starts_with(edit_of)) {
    pin->edits.push_back({std::string(part.substr(edit_of.size())), std::string(value)});
  } else if (part == "size") {
    const Vec2i size = parse_size_text(value);
    pin->width = size.x;
    pin->height = size.y;
  } else if (part == "camera") {
    pin->camera = parse_camera_text(value);
  } else {
    throw InputError(fmt::format("permalink: unknown part 'pin.{}'", part));
  }
}

}  // namespace ps::detail
