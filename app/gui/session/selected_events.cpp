#include "gui/session/selected_events.h"

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

int SelectedEvents::selected(const Document& document, Side side) const {
  const std::size_t index = index_of(side);
  return awaited_[index] || !followed_[index] ? -1 : event_of(document, side);
}

bool SelectedEvents::follow(const NewestStory& newest) {
  const auto& [document, side, inspected, now, still_coming] = newest;
  auto& before = followed_[index_of(side)];
  bool& awaited = awaited_[index_of(side)];
  int& event = event_of(document, side);
  if (awaited) {
    if (!now || still_coming) return false;
    awaited = false;
    if (event >= static_cast<int>(now->events.size())) event = -1;
  } else {
    if (now == before) return false;
    const bool same_pixel = before && now && before->pixel == now->pixel;
    event = same_pixel ? same_event(*before, *now, event, document.scene) : -1;
    if (side == inspected) document.story.until_event = false;
  }
  before = now;
  return true;
}

void SelectedEvents::settle(const Document& before, Document& document) {
  const bool same_pixel = document.pixel == before.pixel;
  for (const Side side : both_sides) {
    bool& awaited = awaited_[index_of(side)];
    int& event = event_of(document, side);
    const bool selected_now = event != event_of(before, side);
    if (awaited && !same_pixel && !selected_now) event = -1;
    if (selected_now) awaited = false;
  }
  StoryView& story = document.story;
  if (!same_pixel) {
    const StoryView kept = for_another_pixel(story);
    if (story == before.story) story = kept;
  }
  const bool same_models = document.scene.geometry.revision() == before.scene.geometry.revision();
  if (!same_models && story.vertex == before.story.vertex) story.vertex.reset();
}

}  // namespace ps::gui
