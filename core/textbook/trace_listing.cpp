#include "textbook/trace_listing.h"

#include "math/conventions.h"
#include "textbook/book_canvas.h"
#include "textbook/book_scene.h"
#include "textbook/near_pixel.h"

namespace ps {
namespace {

/// Leaves the scene's instances with the triangles near the pixel, which are returned and must outlive it.
std::vector<MeshPart> keep_near(BookScene& book, Vec2i pixel, const Progress* progress) {
  std::vector<MeshPart> parts;
  parts.reserve(book.instances.size());
  for (BookInstance& instance : book.instances) {
    if (progress) progress->check();
    const MeshPart& part = parts.emplace_back(part_near_pixel(book, instance, pixel));
    instance.model = &part.mesh;
    instance.numbers = &part.numbers;
  }
  return parts;
}

}  // namespace

ListingTrace trace_listing(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                           const Progress* progress, TracedTriangles triangles) {
  BookScene book = book_scene(scene, view, settings);
  const Vec2i place = book_pixel(pixel.x, pixel.y, view.width, view.height);
  const NamedListing listing = running_listing(settings, scene_traits(scene));
  std::vector<MeshPart> parts;
  // A planted bug may draw a triangle where it does not belong, rays go on to others, and shadows come from anywhere.
  const bool drawn_in_place = listing.bug.empty() && listing.listing->order == ListingOrder::object_by_object &&
                              !listing.listing->draws.shadows;
  if (triangles == TracedTriangles::near_pixel && drawn_in_place) parts = keep_near(book, place, progress);
  BookCanvas canvas(view.width, view.height, {pixel.x, pixel.y, pixel.x + 1, pixel.y + 1}, book.background, progress);
  WatchCollector collector(place);
  ListingTrace trace;
  trace.listing = listing;
  trace.listing.listing->draw(book, canvas);
  trace.pixel = pixel;
  trace.linear = canvas.at(pixel.x, pixel.y) / 255.0;
  trace.watches = collector.watches();
  trace.instances = collector.instances();
  trace.dropped = collector.dropped();
  return trace;
}

}  // namespace ps
