#pragma once
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "options/settings.h"
#include "scene/scene.h"

namespace ps::test {

/// A picture that is to be drawn in several ways, and the words by which a failure names it.
struct Subject {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<Prepared> prepared;  ///< kept from one way to the next; nullptr: each way makes all anew
  View view;
  Settings settings;
  Channel channels = Channel::none;
  std::string words;
};

/// All that a renderer stores for a pixel in the same pass, but for the number of tests.
inline constexpr Channel pixel_channels =
    static_cast<Channel>(((1u << 12) - 1) & ~static_cast<unsigned>(Channel::tests));

/// Where the same pixels of two pictures differ in a bit ("normal differs at 3,7"), or "". Any NaN equals any.
std::string picture_difference(const Frame& a, const Frame& b, const TileRect& region);

/// The subject's picture as these settings draw it.
Frame drawn(const Subject& subject, const Settings& settings, const std::optional<TileRect>& region = {});

/// Whether the models of the scene are too large for tests of each triangle with each ray.
bool is_large(const Scene& scene);

/// What drew each of the pictures that were compared.
using SeenPaths = std::vector<FastPath>;

/// On how many SIMD targets a subject is drawn: each that the processor has, or one of them.
enum class Targets { each, one };

/// Draws the subject in every way that may not change a bit: by the clear path on one thread; on each SIMD target with
/// several threads, which must count the same work; with another accelerator; in part; and one pixel by the inspector.
/// The words of the first fault, or "". Adds what drew the pictures to `seen`.
std::string differential_fault(const Subject& subject, std::mt19937& random, SeenPaths& seen,
                               Targets targets = Targets::each);

}  // namespace ps::test
