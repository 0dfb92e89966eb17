#pragma once
#include <vector>

#include "frame/region.h"
#include "options/listing.h"
#include "record/renderer_row.h"

namespace ps {

/// The renderer that runs the listings of the lessons, line by line.
RendererRow textbook_row();

/// The functions of the row, for callers of this renderer alone.
Frame render_textbook(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared& prepared, Progress& progress);
PixelStory inspect_textbook(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                            Prepared& prepared, Progress& progress);

/// The parts of the region that the listing is run for, each by one thread: one that goes object by object draws all
/// pixels in one go.
std::vector<TileRect> listing_tiles(const Listing& listing, const View& view, const TileRect& region);

}  // namespace ps
