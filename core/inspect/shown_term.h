#pragma once
#include "record/story.h"

namespace ps {

/// The event whose lines in the sum show the contribution of event `selected`: itself if the sum names it; else the
/// light that a shadow ray asked about, the colour of the surface that was hit, the share of what a mirrored or
/// refracted ray found, the write that a fragment ended in. -1 if it brought nothing of its own.
int shown_term(const PixelStory& story, int selected);

}  // namespace ps
