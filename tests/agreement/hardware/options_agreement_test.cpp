// What the hardware renderer draws is what the rasterizer draws, for every value of every option that it honours. Its
// list of what it lacks (core/hardware/lacks.h) is the only way out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "agreement/hardware/hardware_pair.h"
#include "hardware/lacks.h"
#include "options/option.h"
#include "options/renderer_kind.h"

namespace ps {
namespace {

using test::PairCase;
using test::PairDifference;

constexpr int width = 600, height = 600;
constexpr long most_ids = 20;  ///< of 360,000 pixels

/// Prints what was measured, whether the test fails or not.
PairDifference measured(const PairCase& one, Renderer hardware) {
  const PairDifference difference = compare_with_rasterizer(one, hardware, width, height);
  fmt::print("{}: {}\n", one.name(), difference.text());
  return difference;
}

TEST(HardwareAgreement, Probe) {
  PS_NEEDS_HARDWARE(hardware);
  for (const char* scene :
       {"cgfs/shading", "cgfs/reflections", "cgfs/crates", "cgfs/cubes", "cgfs/primitives", "cgfs/brick-wall",
        "cgfs/relief", "cgfs/fence", "cgfs/depth", "cgfs/behind", "cgfs/near-light", "cgfs/camera", "cgpp/teapot",
        "cgpp/triangle", "cgpp/ground", "octree/attenuation", "octree/headline", "lab/depth-complexity",
        "lab/flattened", "lab/tea-party", "lab/hierarchy", "lab/far-origin", "lab/z-fighting", "lab/cornell",
        "lab/mirror-room", "models/dice"})
    for (const char* snapping : {"driver", "cpu"})
      measured({scene, {"shadows=none", "reflection-depth=0", std::string("vertex-snapping=") + snapping}}, hardware);
}

}  // namespace
}  // namespace ps
