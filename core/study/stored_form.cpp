#include "study/stored_form.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "frame/display_frame.h"
#include "math/power.h"

namespace ps {
namespace {

double srgb_curve(double v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * power(v, 1 / 2.4) - 0.055; }

/// One channel after exposure and gamma, in the way of `rounding`; NaN gives 0.
std::uint8_t stored_level(double value, StoredRounding rounding) {
  if (std::isnan(value)) return 0;
  const double clamped = std::clamp(value, 0.0, 1.0);
  switch (rounding) {
  case StoredRounding::nearest:
    return static_cast<std::uint8_t>(std::nearbyint(255 * clamped));
  case StoredRounding::truncated:
    return static_cast<std::uint8_t>(255 * clamped);
  case StoredRounding::half_up:
    return static_cast<std::uint8_t>(std::floor(255 * clamped + 0.5));
  case StoredRounding::of_256:
    return static_cast<std::uint8_t>(std::min(255.0, 256 * clamped));
  case StoredRounding::wrapped:
    return static_cast<std::uint8_t>(std::fmod(std::clamp(255 * value, 0.0, 1e9), 256.0));
  case StoredRounding::srgb_curve:
    return static_cast<std::uint8_t>(std::nearbyint(255 * srgb_curve(clamped)));
  }
  return 0;
}

Image<Rgb8> levels_by(const Frame& frame, const Settings& settings, StoredRounding rounding) {
  if (rounding == StoredRounding::nearest) return display_frame(frame, settings);
  Image<Rgb8> levels(frame.width(), frame.height());
  const auto level = [&](double linear) {
    const double exposed = linear * settings.exposure;
    return stored_level(settings.gamma == 1 ? exposed : power(std::max(exposed, 0.0), 1 / settings.gamma), rounding);
  };
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < frame.width(); ++x) {
      const Vec3d linear = linear_at(frame, {x, y});
      levels.at(x, y) = {level(linear.r), level(linear.g), level(linear.b)};
    }
  return levels;
}

}  // namespace

Image<Rgb8> stored_levels(const Frame& frame, const Settings& settings, const StoredForm& form) {
  Image<Rgb8> levels = levels_by(frame, settings, form.rounding);
  if (form == StoredForm{.rounding = form.rounding}) return levels;
  const int width = levels.width(), height = levels.height();
  Image<Rgb8> placed(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Vec2i from{x - form.shift.x, y - form.shift.y};
      if (!levels.contains(from.x, from.y)) continue;
      Rgb8 level =
          levels.at(form.mirrored ? width - 1 - from.x : from.x, form.upside_down ? height - 1 - from.y : from.y);
      if (form.red_as_blue) std::swap(level.r, level.b);
      placed.at(x, y) = level;
    }
  return placed;
}

}  // namespace ps
