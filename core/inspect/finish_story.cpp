#include "inspect/finish_story.h"

#include "render/left_out.h"

namespace ps {

void finish_story(PixelStory& story, const Scene& scene, const Settings& settings) {
  story.verdict = story_verdict(story, scene) + left_out_words(scene_traits(scene), settings);
  story.ledger = story_ledger(story, scene, settings);
}

}  // namespace ps
