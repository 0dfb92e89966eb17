#pragma once
#include <optional>

#include "raytrace/clear/many_rays.h"
#include "raytrace/clear/subsample.h"

namespace ps {

/// The pixels of one tile one after the other, as a sampling plan asks; an adaptive one gets its first rays. Pixels
/// must be asked for in reading order, since the shadow cache remembers what came before. Renderer and inspector share
/// it.
template <class Real, class Recorder>
class TileRays {
 public:
  TileRays(const Tracer<Real, Recorder>& tracer, const SamplingPlan& plan, const TileRect& tile)
      : tracer_(tracer), plan_(plan) {
    if (plan.mode == SamplingMode::subsampling) between_.emplace(tracer, tile, plan.step);
  }

  TracedPixel<Real> pixel(int column, int row) const {
    switch (plan_.mode) {
    case SamplingMode::one:
    case SamplingMode::adaptive:
      return tracer_.trace_pixel(column, row);
    case SamplingMode::many:
      return trace_many(tracer_, plan_, {column, row});
    case SamplingMode::subsampling:
      // An inspected pixel shows its search, which a picture has done before.
      if (tracer_.recorder().collects() && between_->is_searched(column, row)) return tracer_.trace_pixel(column, row);
      return between_->pixel(column, row);
    }
    return {};
  }

 private:
  const Tracer<Real, Recorder>& tracer_;
  const SamplingPlan& plan_;
  std::optional<SubsampledTile<Real, Recorder>> between_;
};

}  // namespace ps
