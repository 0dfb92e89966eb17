#include "document/story_view.h"

namespace ps {

StoryView for_another_pixel(StoryView before) {
  const StoryView fresh;
  before.until_event = fresh.until_event;
  before.listing_instance = fresh.listing_instance;
  before.sample = fresh.sample;
  before.micro_triangle = fresh.micro_triangle;
  return before;
}

StoryView carried_over(const StoryView& before, bool same_scene) {
  StoryView after;
  after.outside = before.outside;
  if (same_scene) {
    after.vertex = before.vertex;
    after.vertex_edits = before.vertex_edits;
    return after;
  }
  after.outside.preset = {};
  after.outside.orbit.reset();
  after.outside.through_camera = false;
  return after;
}

}  // namespace ps
