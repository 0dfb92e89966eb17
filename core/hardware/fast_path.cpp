#include "hardware/fast_path.h"

#include <fmt/format.h>

#include <string>

#include "hardware/gl_thread.h"

namespace ps::hardware {

FastPath hardware_path() {
  static const std::string words = [] {
    const Availability& available = availability();
    if (!available.driver) return available.reason;
    return fmt::format("{}, {} sub-pixel bits", available.driver->renderer, available.driver->subpixel_bits);
  }();
  return {Machinery::driver, SurfaceShading::lanes, words};
}

}  // namespace ps::hardware
