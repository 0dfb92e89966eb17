#include "render/story/finish_story.h"

#include "render/left_out.h"

namespace ps {

void finish_story(PixelStory& story, const Scene& scene, const Settings& settings) {
  if (!story.listing) {
    story.verdict = story_verdict(story, scene);
    story.ledger = story_ledger(story, scene, settings);
  }
  story.verdict += left_out_words(scene_traits(scene), settings);
}

}  // namespace ps
