#pragma once
#include <memory>
#include <span>

#include "frame/frame.h"
#include "raytrace/base/trace_inputs.h"
#include "raytrace/sampling/plan.h"

namespace ps {

/// Draws a picture tile by tile in one way: by the clear path (clear/clear_tiles.h) or a fast one (fast/fast_tiles.h).
/// Several threads may call at once, each for a tile of its own.
class TileTracer {
 public:
  virtual ~TileTracer() = default;
  /// What it is.
  virtual FastPath path() const = 0;
  /// Draws the pixels `part` of a tile; with adaptive sampling as their first rays see them.
  virtual void trace(const TileRect& tile, const TileRect& part, Frame& frame, Counters& counters) const = 0;
  /// The second pass of adaptive sampling: draws these pixels of a tile again, with all their samples.
  virtual void subdivide(const TileRect& tile, std::span<const Vec2i> pixels, Frame& frame,
                         Counters& counters) const = 0;

 protected:
  TileTracer() = default;
  TileTracer(const TileTracer&) = default;
  TileTracer& operator=(const TileTracer&) = default;
};

/// `plan` for the second pass of adaptive sampling.
inline SamplingPlan with_all_samples(SamplingPlan plan) {
  plan.mode = SamplingMode::many;
  return plan;
}

}  // namespace ps
