#pragma once
#include <optional>

#include "raytrace/sampling/many_rays.h"
#include "raytrace/sampling/subsample.h"

namespace ps {

/// The pixels of one tile by the clear path, as a sampling plan asks; an adaptive one gets its first rays. Pixels must
/// be asked for in reading order, since the shadow cache remembers what came before. Renderer and inspector share it.
template <class Real, class Recorder>
class TileRays {
 public:
  TileRays(const TraceInputs<Real>& inputs, const SamplingPlan& plan, const TileRect& tile, Recorder& recorder)
      : inputs_(inputs), plan_(plan), recorder_(recorder), tracer_(inputs, recorder) {
    if (plan.mode == SamplingMode::subsampling) between_.emplace(tracer_, inputs, tile, plan.step, recorder);
  }

  TracedPixel<Real> pixel(int column, int row) const {
    switch (plan_.mode) {
    case SamplingMode::one:
    case SamplingMode::adaptive:
      return tracer_.trace_pixel(column, row);
    case SamplingMode::many:
      return trace_many(tracer_, inputs_.viewport, plan_, {column, row}, recorder_);
    case SamplingMode::subsampling:
      // An inspected pixel shows its search, which a picture has done before.
      if (recorder_.collects() && between_->is_searched(column, row)) return tracer_.trace_pixel(column, row);
      return between_->pixel(column, row);
    }
    return {};
  }

 private:
  const TraceInputs<Real>& inputs_;
  const SamplingPlan& plan_;
  Recorder& recorder_;
  Tracer<Real, Recorder> tracer_;
  std::optional<SubsampledTile<Real, Recorder>> between_;
};

}  // namespace ps
