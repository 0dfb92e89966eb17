#pragma once
#include <optional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::test {

/// The number of the hardware renderer, or nothing where this machine has no OpenGL. `reason` then says why.
std::optional<Renderer> hardware_here(std::string& reason);

/// Mesa's drawing on the processor, which is what tests have where there is no graphics card. What tests state of its
/// rounding holds for no other driver.
bool drawn_by_llvmpipe();

/// Skips the test where there is no OpenGL; `hardware` is the renderer's number afterwards.
#define PS_NEEDS_HARDWARE(hardware)                                                                                    \
  std::string no_hardware;                                                                                             \
  const auto found_hardware = ::ps::test::hardware_here(no_hardware);                                                  \
  if (!found_hardware) GTEST_SKIP() << no_hardware;                                                                    \
  [[maybe_unused]] const ::ps::Renderer hardware = *found_hardware

/// How the pictures of two renderers differ.
struct PairDifference {
  long pixels = 0;   ///< of the picture
  long seen = 0;     ///< those that show something in both
  long ids = 0;      ///< those that show another object or triangle
  long colours = 0;  ///< of the same triangle, those more than one level of 255 apart
  int largest = 0;   ///< levels, where both show the same triangle
  std::string text() const;
};

/// Draws the scene with the hardware renderer and with the rasterizer at the driver's sub-pixel bits, and compares.
PairDifference compare_with_rasterizer(const Scene& scene, const Settings& settings, Renderer hardware, int width,
                                       int height);

/// The scene with its own settings and these assignments ("shading=flat").
struct PairCase {
  std::string scene;
  std::vector<std::string> assignments;
  std::string name() const;
};
PairDifference compare_with_rasterizer(const PairCase& one, Renderer hardware, int width, int height);

}  // namespace ps::test
