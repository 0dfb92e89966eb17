#include "scene/colour_name.h"

#include <array>

namespace ps {
namespace {

struct NamedColour {
  std::string_view name;
  double r, g, b;
};

constexpr std::array<NamedColour, 13> named_colours{{{"red", 255, 0, 0},
                                                     {"green", 0, 255, 0},
                                                     {"blue", 0, 0, 255},
                                                     {"yellow", 255, 255, 0},
                                                     {"purple", 255, 0, 255},
                                                     {"magenta", 255, 0, 255},
                                                     {"cyan", 0, 255, 255},
                                                     {"white", 255, 255, 255},
                                                     {"black", 0, 0, 0},
                                                     {"grey", 128, 128, 128},
                                                     {"gray", 128, 128, 128},
                                                     {"orange", 255, 128, 0},
                                                     {"brown", 128, 64, 0}}};

Vec3d value_of(const NamedColour& colour) { return Vec3d{colour.r, colour.g, colour.b} / 255.0; }

}  // namespace

std::optional<Vec3d> named_colour(std::string_view name) {
  for (const NamedColour& colour : named_colours)
    if (colour.name == name) return value_of(colour);
  return {};
}

std::optional<std::string_view> colour_name(const Vec3d& colour) {
  for (const NamedColour& named : named_colours)
    if (value_of(named) == colour) return named.name;
  return {};
}

}  // namespace ps
