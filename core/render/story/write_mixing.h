#pragma once
#include "record/events.h"

namespace ps {

/// How the colour of a write met what the pixel had before.
enum class Mixing { replaces, adds, filters, blends };

/// Without an opacity derived from its numbers: the kernels mix in their own precision, so equal means equal but for
/// that.
Mixing mixing_of(const WriteEvent& write);

}  // namespace ps
