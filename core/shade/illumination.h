#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "math/power.h"
#include "math/unit.h"
#include "options/settings.h"
#include "record/events.h"
#include "record/recorder.h"
#include "shade/shading_inputs.h"

namespace ps {

/// A point to be lit. All vectors are in one space, the shading space, of which only lengths and angles matter.
template <class Real>
struct LitPoint {
  Vec3<Real> position{0, 0, 0};
  Vec3<Real> normal{0, 0, 1};  ///< any length
  Vec3<Real> to_eye{0, 0, 1};  ///< towards the viewer, any length
};

/// The light at a point: its colour is surface colour * light + extra, channel by channel.
template <class Real>
struct Lighting {
  Vec3<Real> light{0, 0, 0};
  Vec3<Real> extra{0, 0, 0};  ///< only from materials with an ambient or specular colour of their own
};

struct IlluminationOptions {
  bool specular = true;
  Highlight highlight = Highlight::phong;
  Illumination illumination = Illumination::book;
  bool attenuation = true;
  bool diffuse = true;
};

inline IlluminationOptions illumination_options(const Settings& settings) {
  return {settings.specular, settings.highlight, settings.illumination, settings.attenuation, settings.diffuse};
}

/// More does not arrive, however near a light is: the brightest that a scene can ask for. Infinity would make NaN of
/// every channel in which the surface is black.
template <class Real>
inline constexpr Real brightest_arrival = Real(1e12);
template <class Real>
inline Real spread(Real intensity, Real divisor) {
  return std::min(intensity / std::max(divisor, std::numeric_limits<Real>::min()), brightest_arrival<Real>);
}

/// The intensity of a casting light that arrives at a point, before the angle counts. Book: the intensity, of point
/// lights divided by c + l r + q r^2 (OCT). Radiometric: a point light's intensity is its power, which spreads over a
/// sphere (CGPP 15.4.5); a directional light's is the irradiance on a surface that faces it.
template <class Real>
inline Real arriving(const ShadingLight<Real>& light, const Vec3<Real>& to_light, const IlluminationOptions& options) {
  if (light.kind != LightKind::point) return light.intensity;
  using Limits = std::numeric_limits<Real>;
  const Real square = dot(to_light, to_light);
  const bool exact = has_exact_square(square);
  const Real distance = exact ? std::sqrt(square) : std::clamp(length_of(to_light), Limits::min(), Limits::max());
  switch (options.illumination) {
  case Illumination::book: {
    if (!options.attenuation || !light.attenuates) return light.intensity;
    const Vec3<Real>& a = light.attenuation;
    return spread(light.intensity, a.x + a.y * distance + (exact ? a.z * square : a.z * distance * distance));
  }
  case Illumination::radiometric:
    if (!exact) return spread(light.intensity / (4 * std::numbers::pi_v<Real>) / distance, distance);
    return spread(light.intensity, 4 * std::numbers::pi_v<Real> * square);
  }
  return light.intensity;
}

/// The factor of a term of the illumination equation besides its angle. Radiometric: 1 / pi of Lambert's law, and
/// for a highlight the normalised Blinn-Phong density (s + 8) / 8 pi times N.L (CGPP 15.4.6 and 7).
template <class Real>
inline Real diffuse_factor(const IlluminationOptions& options) {
  return options.illumination == Illumination::radiometric ? 1 / std::numbers::pi_v<Real> : Real(1);
}
template <class Real>
inline Real specular_factor(const IlluminationOptions& options, Real exponent, Real cosine) {
  if (options.illumination == Illumination::book) return 1;
  return cosine > 0 ? (exponent + 8) / (8 * std::numbers::pi_v<Real>)*cosine : Real(0);
}

/// The `incoming` direction (away from the surface) mirrored about `normal`, whose length must be 1; `cosine` is their
/// dot product.
template <class Real>
inline Vec3<Real> mirror(const Vec3<Real>& incoming, const Vec3<Real>& normal, Real cosine) {
  return normal * (Real(2) * cosine) - incoming;
}
template <class Real>
inline Vec3<Real> mirror(const Vec3<Real>& incoming, const Vec3<Real>& normal) {
  return mirror(incoming, normal, dot(normal, incoming));
}

/// The two directions whose angle decides how bright a highlight is: R and V (Phong), or N and H (Blinn-Phong).
template <class Real>
struct HighlightAngle {
  Vec3<Real> a, b;
  Real dot_product = 0;
  Real cosine() const { return dot_product / (length_of(a) * length_of(b)); }
};

template <class Real>
inline HighlightAngle<Real> highlight_angle(const LitPoint<Real>& point, const Vec3<Real>& to_light,
                                            Highlight highlight) {
  HighlightAngle<Real> angle;
  switch (highlight) {
  case Highlight::phong:
    angle.a = mirror(to_light, point.normal);
    angle.b = point.to_eye;
    break;
  case Highlight::blinn_phong:
    angle.a = point.normal;
    angle.b = unit_of(to_light) + unit_of(point.to_eye);
    break;
  }
  angle.dot_product = dot(angle.a, angle.b);
  return angle;
}

/// Whether a casting light that is not blocked adds anything to the point: only then it matters what is between.
template <class Real>
inline bool adds_light(const LitPoint<Real>& point, const ShadingMaterial<Real>& material, const Vec3<Real>& to_light,
                       const IlluminationOptions& options) {
  const bool faces = dot(point.normal, to_light) > 0;
  if (options.diffuse && faces) return true;
  if (!options.specular || !material.specular) return false;
  if (options.illumination == Illumination::radiometric && !faces) return false;
  return highlight_angle(point, to_light, options.highlight).dot_product > 0;
}

/// What is between a point and a light. A blocked light gives 0; where a shadow map's taps disagree, a share.
template <class Real>
struct Blocking {
  std::optional<PixelId> by;
  Real visible = 1;
  Blocking(std::optional<PixelId> blocker) : by(blocker), visible(blocker ? Real(0) : Real(1)) {}
  static Blocking partly(Real visible_share) {
    Blocking blocking{std::nullopt};
    blocking.visible = visible_share;
    return blocking;
  }
};

/// The illumination equation of CGFS ch. 3 and 4, in the book's order of operations; shared by rays and fragments.
/// The highlight does not depend on N.L > 0, as in the book. Vectors need not have length 1.
/// `blocked(light_index, to_light, t_max) -> Blocking<Real>` returns what blocks the light between the point and a
/// casting light; the light lies at position + t_max * to_light (infinity for a directional one). It is asked once for
/// each casting light. Reports a LightEvent for each light; the first one's index is `first_light`.
template <class Real, class Recorder, class Blocked>
Lighting<Real> illuminate(const LitPoint<Real>& point, const ShadingMaterial<Real>& material,
                          std::span<const ShadingLight<Real>> lights, const IlluminationOptions& options,
                          Blocked&& blocked, Recorder& recorder, int first_light = 0) {
  Lighting<Real> sum;
  const auto add = [](Vec3<Real>& target, const Vec3<Real>& colour, Real amount) {
    target.x += colour.x * amount;
    target.y += colour.y * amount;
    target.z += colour.z * amount;
  };
  const auto add_ambient = [&](const Vec3<Real>& colour, Real amount) {
    if (material.ambient_colour)
      add(sum.extra, *material.ambient_colour * colour, amount);
    else
      add(sum.light, colour, amount);
  };
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const ShadingLight<Real>& light = lights[i];
    const int index = first_light + static_cast<int>(i);
    recorder.count(Counter::light_samples);
    if (light.kind == LightKind::ambient) {
      add_ambient(light.colour, light.intensity);
      recorder.event([&] {
        LightEvent event;
        event.light = index;
        event.diffuse = static_cast<double>(light.intensity);
        return event;
      });
      continue;
    }
    const bool is_point = light.kind == LightKind::point;
    const Vec3<Real> to_light = is_point ? light.vector - point.position : light.vector;
    const Blocking<Real> blocking =
        blocked(index, to_light, is_point ? Real(1) : std::numeric_limits<Real>::infinity());
    const bool dark = !(blocking.visible > 0);
    const Real n_dot_l = dot(point.normal, to_light);
    const Real unblocked = arriving(light, to_light, options);
    const Real intensity = unblocked * blocking.visible;
    if (light.adds_ambient) add_ambient(light.ambient_colour, unblocked);
    const bool radiometric = options.illumination == Illumination::radiometric;
    Real diffuse = 0;
    Real specular = 0;
    if (!dark && options.diffuse && n_dot_l > 0) {
      diffuse = intensity * n_dot_l / (length_of(point.normal) * length_of(to_light));
      if (radiometric) diffuse *= diffuse_factor<Real>(options);
      add(sum.light, light.colour, diffuse);
    }
    if (!dark && options.specular && material.specular) {
      const HighlightAngle<Real> angle = highlight_angle(point, to_light, options.highlight);
      if (angle.dot_product > 0) {
        specular = intensity * power(angle.cosine(), *material.specular);
        if (radiometric)
          specular *=
              specular_factor(options, *material.specular, n_dot_l / (length_of(point.normal) * length_of(to_light)));
        if (material.specular_colour)
          add(sum.extra, *material.specular_colour * light.specular_colour, specular);
        else
          add(sum.light, light.specular_colour, specular);
      }
    }
    recorder.event([&] {
      LightEvent event;
      event.light = index;
      event.kind = light.kind;
      event.to_light = Vec3d(to_light);
      event.n_dot_l = static_cast<double>(n_dot_l / (length_of(point.normal) * length_of(to_light)));
      event.r_dot_v = static_cast<double>(highlight_angle(point, to_light, options.highlight).cosine());
      event.diffuse = static_cast<double>(diffuse);
      event.specular = static_cast<double>(specular);
      if (light.adds_ambient) event.ambient = static_cast<double>(unblocked);
      event.blocker = blocking.by;
      event.visible = static_cast<double>(blocking.visible);
      event.below_horizon = !(n_dot_l > 0);
      return event;
    });
  }
  return sum;
}

}  // namespace ps
