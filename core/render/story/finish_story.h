#pragma once
#include "record/story.h"
#include "scene/scene.h"

namespace ps {

/// Fills in the verdict and the ledger of a story whose events, colour and counters are complete. Both come from the
/// events alone; the scene only lends names and the colours of its lights and materials.
void finish_story(PixelStory& story, const Scene& scene, const Settings& settings);

/// One sentence that says what the pixel shows and why. Never empty.
std::string story_verdict(const PixelStory& story, const Scene& scene);

/// The pixel's colour as a sum (see LedgerLine), followed by lines without value that describe what the display does
/// with it.
std::vector<LedgerLine> story_ledger(const PixelStory& story, const Scene& scene, const Settings& settings);

}  // namespace ps
