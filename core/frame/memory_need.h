#pragma once
#include <cstdint>
#include <string>

#include "frame/prepared.h"

namespace ps {

/// Memory that a part of a picture is going to take. Every part whose size a scene or an option multiplies says so
/// before it is made.
struct MemoryNeed {
  std::uint64_t bytes = 0;
  std::string what;  ///< plural, for the message: "the environment maps of 200 mirrors"
  std::string cure;  ///< what to change: "set a smaller 'environment-size'"
};

/// Throws InputError where it is more than this computer can spare. What `prepared` keeps counts as spare, since it
/// gives way to new products.
void require(const MemoryNeed& need, const Prepared& prepared);

}  // namespace ps
