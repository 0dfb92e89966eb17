#include "gui/theme/shade.h"

#include <array>

#include "image/svg.h"

namespace ps::gui {
namespace {

/// Colours by Role. Those after them are the same everywhere.
constexpr std::array shades{&Palette::text,       &Palette::text_quiet, &Palette::line_strong, &Palette::line,
                            &Palette::field,      &Palette::a,          &Palette::b,           &Palette::right_mark,
                            &Palette::wrong_mark, &Palette::attention};
static_assert(shades.size() == static_cast<std::size_t>(Role::light));

}  // namespace

ImVec4 shade(const Palette& palette, Role role) {
  if (role < Role::light) return palette.*shades[static_cast<std::size_t>(role)];
  const Rgb8 same = paper_shade(role);
  return {static_cast<float>(same.r) / 255, static_cast<float>(same.g) / 255, static_cast<float>(same.b) / 255, 1};
}

}  // namespace ps::gui
