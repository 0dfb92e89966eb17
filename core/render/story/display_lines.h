#pragma once
#include <vector>

#include "record/story.h"

namespace ps {

/// The steps of the finished sum on its way to the screen (exposure, clamping, gamma, rounding to the colour depth),
/// as ledger lines of level 0 whose value is zero: they explain and do not add.
std::vector<LedgerLine> display_lines(const PixelStory& story, const Settings& settings);

}  // namespace ps
