#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "math/vec.h"
#include "record/events.h"

namespace ps {

/// What the first ray of a pixel found, as adaptive sampling compares it.
struct FirstRay {
  PixelId id;
  Vec3d colour{0, 0, 0};  ///< linear
};

/// Adaptive sampling (CGFS ch. 5): two adjacent pixels are subdivided if their rays met different objects, or if their
/// colours, clamped to [0, 1], differ by more than the threshold in a channel.
inline CompareEvent compare_rays(const FirstRay& own, const FirstRay& other, Vec2i neighbour, double threshold) {
  CompareEvent event{neighbour, own.id, other.id, 0, threshold, false};
  for (int k = 0; k < 3; ++k) {
    const double difference = std::abs(std::clamp(own.colour[k], 0.0, 1.0) - std::clamp(other.colour[k], 0.0, 1.0));
    if (difference > event.difference) event.difference = difference;
  }
  event.subdivides = own.id.object != other.id.object || event.difference > threshold;
  return event;
}

/// The pixels with which a pixel is compared, as far as they lie in the picture.
inline constexpr std::array<Vec2i, 4> neighbour_steps{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

}  // namespace ps
