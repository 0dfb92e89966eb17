#pragma once
#include <cstdint>

namespace launch {

/// What the started program may use; the arguments of this program in their order.
struct Limits {
  std::uint64_t processor_milliseconds = 0;  ///< of each process; whole seconds count
  std::uint64_t milliseconds = 0;            ///< by the clock
  std::uint64_t memory = 0;                  ///< bytes: addresses of each process, resident pages of all together
  std::uint64_t processes = 0;               ///< at once
  std::uint64_t file_bytes = 0;              ///< of each file that is written, and of all in its folder together
  std::uint64_t user = 0;                    ///< whose rights root gives up for; 0 = keeps its own
};

/// Limits this process and what it starts, for good; it gains no rights by what it starts either. Answers whether the
/// system agreed to all of it.
bool limit_this_process(const Limits& limits);

}  // namespace launch
