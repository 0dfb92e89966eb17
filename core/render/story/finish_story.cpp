#include "render/story/finish_story.h"

namespace ps {

void finish_story(PixelStory& story, const Scene& scene, const Settings& settings) {
  story.verdict = story_verdict(story, scene);
  story.ledger = story_ledger(story, scene, settings);
}

}  // namespace ps
