#pragma once
#include <vector>

#include "base/progress.h"
#include "frame/view.h"
#include "options/listing.h"
#include "options/settings.h"
#include "record/watch.h"
#include "scene/scene.h"

namespace ps {

/// The steps of a listing for one pixel.
struct ListingTrace {
  NamedListing listing;
  Vec2i pixel{0, 0};      ///< array position
  Vec3d linear{0, 0, 0};  ///< the colour that it gave, 1.0 = the book's 255
  std::vector<Watch> watches;
  std::vector<WatchInstance> instances;
  std::size_t dropped = 0;  ///< watches beyond the limit
};

/// Which triangles a traced listing is given. Those far from the pixel leave no mark in its trace, so both give the
/// same one; among a million the listing takes a hundred times as long as finding those near it. A listing with a
/// planted bug, or one that follows rays or casts shadows, is given all of them.
enum class TracedTriangles { near_pixel, all };

/// Runs the listing that the settings name for one pixel (array position) of the view, and keeps what its lines had.
/// Throws Cancelled when `progress` is asked to stop.
ListingTrace trace_listing(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                           const Progress* progress = nullptr, TracedTriangles triangles = TracedTriangles::near_pixel);

}  // namespace ps
