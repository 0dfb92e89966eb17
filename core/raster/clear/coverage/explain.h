#pragma once
#include "raster/clear/coverage/walk.h"
#include "record/events.h"

namespace ps::raster {

/// How the strategy decided about one sample, in a sentence and with its numbers. The decision itself comes from the
/// strategy's own walk over that pixel.
template <class Real>
CoverageEvent explain_coverage(const CoverageChoice& choice, const CoverageInput& input, int column, int row);

}  // namespace ps::raster
