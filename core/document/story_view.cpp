#include "document/story_view.h"

namespace ps {

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
