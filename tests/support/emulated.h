#pragma once
#include <cstddef>
#include <cstdlib>
#include <string>

namespace ps::test {

/// What tests/emulated puts before a program to run it as another processor, such as "qemu-x86_64 -cpu Haswell"; empty
/// when the tests run on the processor itself. Programs that a test starts need it, too.
inline std::string emulator() {
  const char* command = std::getenv("PIXELSCOPE_EMULATOR");
  return command == nullptr ? "" : command;
}

inline bool is_emulated() { return !emulator().empty(); }

/// Steps between the columns and rows that a test looks at. An emulated processor takes some thirty times as long as
/// the one below it, so it looks at one pixel of 16.
inline int pixel_step() { return is_emulated() ? 4 : 1; }

/// Likewise between the settings that a test tries.
inline std::size_t trial_step() { return is_emulated() ? 7 : 1; }

}  // namespace ps::test
