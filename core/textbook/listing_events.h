#pragma once
#include <vector>

#include "record/events.h"
#include "textbook/book_scene.h"
#include "textbook/trace_listing.h"

namespace ps {

/// The steps of a listing for its pixel, as the events with which the ray tracer or the rasterizer reports the same
/// steps, from the values on its lines. Without the last event, which is the pixel's own. What a listing does not
/// compute (weights and edge values of a triangle that it fills row by row) is computed here from its vertices.
std::vector<Event> listing_events(const BookScene& book, const ListingTrace& trace);

/// The renderer whose steps a listing takes: rays for those that go pixel by pixel, else triangles and lines.
Renderer stepped_like(const NamedListing& listing);

/// The options that say what a listing does by its nature, so that its story can be held beside that of a renderer:
/// double precision, a pixel's corner as its sample, whole pixels, and what its chapter does not know yet switched off.
/// Settings that the listing reads stay as they are, and so do those without effect in the scene.
Settings settings_as_listed(const NamedListing& listing, const Scene& scene, const Settings& settings);

}  // namespace ps
