// The selected events, the picked pixel's views and the kept vertex while what they belong to changes.
#include "gui/session/session.h"
#include "inspect/parting/align_stories.h"

namespace ps::gui {
namespace {

/// Where event `selected` of one story is in another of the same pixel; -1 if it happens no more.
int same_event(const PixelStory& before, const PixelStory& after, int selected, const Scene& scene) {
  if (selected < 0) return -1;
  for (const AlignedRow& row : align_stories(before, after, scene))
    if (row.a == selected) return row.b;
  return -1;
}

}  // namespace

int Session::selected_event(Side side) const {
  const std::size_t index = index_of(side);
  return awaited_[index] || !followed_[index] ? -1 : event_of(document_, side);
}

void Session::follow_story(Side side) {
  auto& before = followed_[index_of(side)];
  bool& awaited = awaited_[index_of(side)];
  const auto now = story(side);
  int& event = event_of(document_, side);
  if (awaited) {
    if (!now || inspectors_[index_of(side)]->busy()) return;
    awaited = false;
    if (event >= static_cast<int>(now->events.size())) event = -1;
  } else {
    if (now == before) return;
    const bool same_pixel = before && now && before->pixel == now->pixel;
    event = same_pixel ? same_event(*before, *now, event, document_.scene) : -1;
    if (side == inspected_side(*this)) document_.story.until_event = false;
  }
  before = now;
  changed();
}

void Session::settle(const Document& before) {
  const bool same_pixel = document_.pixel == before.pixel;
  for (const Side side : both_sides) {
    bool& awaited = awaited_[index_of(side)];
    int& event = event_of(document_, side);
    const bool selected_now = event != event_of(before, side);
    if (awaited && !same_pixel && !selected_now) event = -1;
    if (selected_now) awaited = false;
  }
  StoryView& story = document_.story;
  if (!same_pixel) {
    const StoryView kept = for_another_pixel(story);
    if (story == before.story) story = kept;
  }
  const bool same_models = document_.scene.geometry.revision() == before.scene.geometry.revision();
  if (!same_models && story.vertex == before.story.vertex) story.vertex.reset();
}

}  // namespace ps::gui
