#pragma once
#include <cstdint>

namespace launch {

/// Whether all files below a folder take more than `bytes` on the disk together, or are too many to count in
/// passing. Links are not followed, and other file systems are left out; a file without a name any more is not found.
bool holds_more_than(const char* folder, std::uint64_t bytes);

}  // namespace launch
