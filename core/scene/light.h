#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "math/vec.h"

namespace ps {

enum class LightKind { ambient, point, directional };
inline constexpr std::array light_kinds{LightKind::ambient, LightKind::point, LightKind::directional};

/// "ambient", "point", "directional"
constexpr std::string_view light_kind_key(LightKind kind) {
  switch (kind) {
  case LightKind::ambient:
    return "ambient";
  case LightKind::point:
    return "point";
  case LightKind::directional:
    return "directional";
  }
  return "";
}

/// A light of CGFS ch. 3. Display-referred: intensities that add up to 1 cannot overexpose.
struct Light {
  LightKind kind = LightKind::ambient;
  double intensity = 1;
  Vec3d colour{1, 1, 1};     ///< white in the book
  Vec3d position{0, 0, 0};   ///< world space; point lights only
  Vec3d direction{0, 1, 0};  ///< from the scene towards the light, not normalised; directional lights only
  /// Attenuation of point lights: brightness at distance r is divided by x + y r + z r^2.
  Vec3d attenuation{1, 0, 0};
  // A light may have a colour for each term of the illumination equation (OCT). `colour` is that of diffuse light, and
  // of highlights without one of their own. Point and directional lights only.
  std::optional<Vec3d> specular_colour{};  ///< of its highlights
  Vec3d ambient_colour{0, 0, 0};           ///< of light that it adds everywhere, in shadow too
  double radius = 0;  ///< of a lamp, a ball around `position` (option shadow-samples); point lights only; world units
  bool operator==(const Light&) const = default;
};

/// The colour of its highlights.
inline Vec3d highlight_colour(const Light& light) { return light.specular_colour.value_or(light.colour); }
/// Has some term of the illumination equation a colour of its own?
inline bool has_term_colours(const Light& light) {
  return highlight_colour(light) != light.colour || light.ambient_colour != Vec3d(0);
}

}  // namespace ps
