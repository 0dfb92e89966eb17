#pragma once
#include <string>

#include "frame/view.h"
#include "record/story.h"
#include "render/provenance.h"
#include "scene/scene.h"

namespace ps {

/// A story as a page of Markdown: what was asked, the verdict, the events as a nested list of sentences, the colour as
/// a table, and the provenance. All fields of the events are a list that is folded away, as it is several times as
/// long.
std::string story_markdown(const PixelStory& story, const Scene& scene, const View& view, const Provenance& provenance);

/// A story as a table of comma-separated values (base/csv.h), one line for each number or word that is known:
/// part,index,parent,kind,name,value. `part` is pixel, event, ledger, counter or provenance; lists have their place in
/// the name
/// ("point[2]"). Numbers have all their digits.
std::string story_csv(const PixelStory& story, const Scene& scene, const Provenance& provenance);

}  // namespace ps
