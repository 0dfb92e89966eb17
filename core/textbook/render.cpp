#include <fmt/format.h>

#include <set>

#include "base/timer.h"
#include "frame/display_frame.h"
#include "frame/empty_frame.h"
#include "frame/region.h"
#include "image/display.h"
#include "math/has_nan.h"
#include "textbook/book_canvas.h"
#include "textbook/book_scene.h"
#include "textbook/listing_events.h"
#include "textbook/renderer.h"
#include "textbook/trace_listing.h"

namespace ps {
namespace {

/// Copies a finished canvas into the frame and counts colours that are NaN.
std::uint64_t store(const BookCanvas& canvas, Frame& frame) {
  std::uint64_t nan = 0;
  const TileRect& part = canvas.part();
  for (int y = part.y0; y < part.y1; ++y)
    for (int x = part.x0; x < part.x1; ++x) {
      const Vec3d colour = canvas.at(x, y) / 255.0;
      frame.colour_double.at(x, y) = colour;
      frame.colour.at(x, y) = Vec3f(colour);
      nan += has_nan(colour) ? 1 : 0;
    }
  return nan;
}

}  // namespace

std::vector<TileRect> listing_tiles(const Listing& listing, const View& view, const TileRect& region) {
  constexpr int tile_size = 64;
  if (is_empty(region)) return {};
  if (listing.order != ListingOrder::pixel_by_pixel) return {region};
  std::vector<TileRect> tiles;
  for (const TileRect& tile : make_tiles(view.width, view.height, tile_size))
    if (const TileRect part = common_part(tile, region); !is_empty(part)) tiles.push_back(part);
  return tiles;
}

Frame render_textbook(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared&, Progress& progress) {
  const Timer timer;
  const BookScene book = book_scene(scene, view, settings);
  const Listing& listing = *running_listing(settings, scene_traits(scene)).listing;
  const TileRect region = asked_region(request, view.width, view.height);
  Frame frame = empty_frame<double>(view, request);
  clear_outside({}, frame);  // a listing makes colours alone
  const std::vector<TileRect> tiles = listing_tiles(listing, view, region);
  std::vector<std::uint64_t> nan(tiles.size());
  parallel_for(static_cast<int>(tiles.size()), {settings.threads, request.priority}, progress, [&](int index, int) {
    const TileRect& tile = tiles[static_cast<std::size_t>(index)];
    BookCanvas canvas(view.width, view.height, tile, book.background, &progress);
    listing.draw(book, canvas);
    nan[static_cast<std::size_t>(index)] = store(canvas, frame);
    finish_tile(request, settings, frame, tile);
  });
  for (const std::uint64_t count : nan) frame.counters[Counter::nan_pixels] += count;
  frame.times.push_back({"listing", timer.milliseconds()});
  return frame;
}

PixelStory inspect_textbook(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared&,
                            Progress& progress) {
  auto trace = std::make_shared<ListingTrace>(trace_listing(scene, view, settings, pixel, &progress));
  PixelStory story;
  story.pixel = pixel;
  story.renderer = Renderer::textbook;
  story.linear = trace->linear;
  story.counters[Counter::nan_pixels] = has_nan(story.linear) ? 1 : 0;
  const Rgb8 display = display_pixel(story.linear, display_transform(settings));
  story.display = {display.r, display.g, display.b};
  std::set<int> lines;
  for (const Watch& watch : trace->watches) lines.insert(watch.line);
  const Listing& listing = *trace->listing.listing;
  story.verdict = lines.empty() ? fmt::format("no line of the listing of {} reached this pixel", listing.source)
                                : fmt::format("the listing of {} computed this pixel's colour: {} values on {} lines",
                                              listing.source, trace->watches.size(), lines.size());
  story.events = listing_events(book_scene(scene, view, settings), *trace);
  story.events.push_back({-1, EventData(PixelEvent{story.linear, story.display})});
  story.ledger.push_back({0, LedgerTerm::listing, fmt::format("as the listing of {} computes it", listing.source),
                          story.linear, static_cast<int>(story.events.size()) - 1});
  story.listing = std::move(trace);
  return story;
}

}  // namespace ps
