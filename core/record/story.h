#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/counters.h"
#include "options/settings.h"
#include "record/events.h"

namespace ps {

struct ListingTrace;

/// Which term of a light's a line is.
enum class LightTerm { none, whole, ambient, diffuse, specular };

/// One line of the sum that makes the pixel's colour. `level` indents; a line's value is the sum of the lines one level
/// deeper that follow it, where there are any. Lines of level 0 add up to the pixel.
struct LedgerLine {
  int level = 0;
  std::string term;      ///< "light 1 diffuse: 0.6 x 0.49 x red"
  Vec3d value{0, 0, 0};  ///< what it adds to the pixel, linear
  int event = -1;        ///< index of the event it comes from
  LightTerm light_term = LightTerm::none;
  std::string light{};  ///< of a light's term: "light 1 (point)"
};

/// All that one click reports, in the order in which it happened.
struct PixelStory {
  Vec2i pixel{0, 0};  ///< array position: column, row
  Renderer renderer{};
  std::string verdict;  ///< one sentence, never empty
  Vec3d linear{0, 0, 0};
  std::array<int, 3> display{};  ///< exactly what `render` stores at this pixel
  std::vector<Event> events;
  std::vector<LedgerLine> ledger;
  Counters counters;
  /// Triangles whose box, grown by a pixel, misses the pixel (or whose object was dropped whole): counted, not listed.
  std::uint64_t triangles_elsewhere = 0;
  /// The steps that the renderer cannot report, in one sentence; empty where it reports every step.
  std::string not_reported;
  /// For the textbook renderer: the values that its listing had for this pixel (textbook/trace_listing.h).
  std::shared_ptr<const ListingTrace> listing;
};

}  // namespace ps
