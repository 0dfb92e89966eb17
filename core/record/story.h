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

/// Which term of the sum a line is.
enum class LedgerTerm {
  background,
  colour,          ///< that a write brought: it replaces, is added, is multiplied or is blended
  what_was_there,  ///< below a blended colour
  local,           ///< colour of a surface that reflects or lets light through
  reflected,
  transmitted,
  light,  ///< all of a light's
  ambient,
  diffuse,
  specular,
  point,        ///< light at a vertex or at the centre of a triangle
  all_light,    ///< of a surface, where its lights' terms do not add up
  extra_light,  ///< light with a colour of its own, beside that
  left_end,     ///< of a row of a polygon
  right_end,
  edge,
  sample,
  listing,
  rounding,
  exposure,  ///< these and those below say what the display does, and have no value
  clamped_red,
  clamped_green,
  clamped_blue,
  gamma,
  stored
};

/// One line of the sum that makes the pixel's colour. `level` indents; a line's value is the sum of the lines one level
/// deeper that follow it, where there are any. Lines of level 0 add up to the pixel.
struct LedgerLine {
  int level = 0;
  LedgerTerm kind{};
  std::string term;      ///< "light 1 diffuse: 0.6 x 0.49 x red"
  Vec3d value{0, 0, 0};  ///< what it adds to the pixel, linear
  int event = -1;        ///< index of the event it comes from
  std::string light{};   ///< of a light's term: "light 1 (point)"
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
