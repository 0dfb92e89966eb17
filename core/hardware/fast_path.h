#pragma once
#include "frame/machinery.h"

namespace ps::hardware {

/// What draws: the driver, by its name and with its sub-pixel bits.
FastPath hardware_path();

}  // namespace ps::hardware
