#pragma once
#include <string>
#include <vector>

#include "record/story.h"
#include "scene/scene.h"

namespace ps::gui {

/// For each event the index after its last descendant. Parents are before their children.
std::vector<int> subtree_ends(const std::vector<Event>& events);

/// A row of the story: one event with all below it, or a run of siblings in one row because each by itself says little.
struct StoryRow {
  int first = 0, last = 0;  ///< events, half-open
  bool run = false;
};

/// More consecutive misses than this share a row. Boxes are from the second on.
inline constexpr int most_single_misses = 6;

/// The siblings in [first, last), half-open, as rows.
std::vector<StoryRow> story_rows(const std::vector<Event>& events, const std::vector<int>& ends, int first, int last);

/// "17 boxes visited, 12 entered; 9 primitives missed" for a run.
std::string run_text(const std::vector<Event>& events, const StoryRow& run);

/// An event as a short line. For rays it is their outcome, since their numbers are in the table below the row.
std::string row_text(const std::vector<Event>& events, const std::vector<int>& ends, const Scene& scene, int index);

/// The description of an event without the lines of row_details().
std::string short_description(const Event& event, const Scene& scene);

/// The details of an event below its row, line by line: the faces of shadow volumes that a stencil counted. Mostly
/// empty.
std::vector<std::string> row_details(const Event& event, const Scene& scene);

/// How much of the eye an event deserves.
enum class EventWeight { quiet, plain, strong };
EventWeight event_weight(const Event& event);

}  // namespace ps::gui
