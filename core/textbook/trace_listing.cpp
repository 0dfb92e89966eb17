#include "textbook/trace_listing.h"

#include "math/conventions.h"
#include "textbook/book_canvas.h"
#include "textbook/book_scene.h"

namespace ps {

ListingTrace trace_listing(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                           const Progress* progress) {
  const BookScene book = book_scene(scene, view, settings);
  BookCanvas canvas(view.width, view.height, {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, book.background, progress);
  WatchCollector collector(book_pixel(pixel.x, pixel.y, view.width, view.height));
  ListingTrace trace;
  trace.listing = listing_of(settings, scene_traits(scene));
  trace.listing.listing->draw(book, canvas);
  trace.pixel = pixel;
  trace.linear = canvas.at(pixel.x, pixel.y) / 255.0;
  trace.watches = collector.watches();
  trace.instances = collector.instances();
  trace.dropped = collector.dropped();
  return trace;
}

}  // namespace ps
