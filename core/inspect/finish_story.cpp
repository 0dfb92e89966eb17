#include "inspect/finish_story.h"

#include "render/left_out.h"

namespace ps {

void finish_story(PixelStory& story, const Scene& scene, const Settings& settings) {
  story.verdict = story_verdict(story, scene);
  for (const LeftOut& one : left_out(scene_traits(scene), settings)) story.verdict += "; the rasterizer " + one.brief;
  story.ledger = story_ledger(story, scene, settings);
}

}  // namespace ps
