#pragma once
#include <string>

#include "frame/view.h"
#include "record/story.h"
#include "render/provenance.h"
#include "scene/scene.h"

namespace ps {

/// A story as JSON text: {"pixel":[x,y], "book-pixel":[x,y], "size":[w,h], "renderer", "verdict",
/// "colour":{"linear":[r,g,b], "display":[r,g,b]}, "events":[{"kind", "parent", "text", ...}],
/// "ledger":[{"level", "term", "value":[r,g,b], "event"}], "counters":{...}, "triangles-elsewhere",
/// "provenance":{...}}. `parent` and `event` are indices into "events", -1 for none. Hits and fragments on a model have
/// what its file says of the face, too (event_fields() of inspect/face_data.h). Ids are {"object","triangle","name"}
/// with -1 for none. Numbers have all their digits; infinite ones and NaN are null, since JSON has no word for them.
std::string story_json(const PixelStory& story, const Scene& scene, const View& view, const Provenance& provenance);

}  // namespace ps
