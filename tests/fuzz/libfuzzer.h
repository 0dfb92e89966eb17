#pragma once
#include <cstddef>
#include <cstdint>

#include "fuzz/targets.h"

/// The entry that libFuzzer calls, for one of the targets. Programs run from the source folder.
#define PS_FUZZ(name)                                                                                                  \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {                                  \
    static const ps::fuzz::Target& target = ps::fuzz::target(name);                                                    \
    target.run({reinterpret_cast<const char*>(data), size});                                                           \
    return 0;                                                                                                          \
  }
