#include "textbook/slow_motion.h"

#include <algorithm>

#include "frame/empty_frame.h"
#include "frame/region.h"
#include "frame/whole_picture.h"
#include "options/listing.h"
#include "textbook/book_canvas.h"
#include "textbook/book_scene.h"

namespace ps {
namespace {

/// All that a listing puts on its canvas.
struct ListingWrites {
  std::vector<CanvasWrite> list;
  std::size_t heap_bytes() const { return list.capacity() * sizeof(CanvasWrite); }
};

}  // namespace

std::optional<std::string_view> listing_slow_motion_lacks(SlowUnit unit, const Settings&, const SceneTraits&) {
  if (unit == SlowUnit::writes) return {};
  return "not for listings: they have loops of their own (choose pixel writes)";
}

SlowFrame run_listing_slowly(const Scene& scene, const View& view, const Settings& settings, const SlowMotion& motion,
                             const RenderRequest& request, Prepared& prepared, Progress& progress) {
  const BookScene book = book_scene(scene, view, settings);
  const TileRect region = asked_region(request, view.width, view.height);
  RenderRequest plain;
  plain.channels = request.channels;
  plain.region = request.region;
  SlowFrame slow;
  slow.frame = empty_frame<double>(view, plain);
  clear_outside({}, slow.frame);
  slow.frame.counters.given = {};
  slow.state.done = {motion.unit, 0};
  if (is_empty(region)) return slow;
  const auto writes =
      prepared.get<ListingWrites>(picture_key("writes of a listing", scene, view, settings, plain), [&] {
        ListingWrites noted;
        BookCanvas canvas(view.width, view.height, region, book.background, &progress);
        canvas.note_writes(noted.list);
        running_listing(settings, scene_traits(scene)).listing->draw(book, canvas);
        return noted;
      });
  const auto store = [&](Vec2i pixel, const Vec3d& colour) {
    slow.frame.colour_double.at(pixel.x, pixel.y) = colour / 255.0;
    slow.frame.colour.at(pixel.x, pixel.y) = Vec3f(colour / 255.0);
  };
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) store({x, y}, book.background);
  const std::size_t done = static_cast<std::size_t>(std::min<std::uint64_t>(motion.at, writes->list.size()));
  for (const CanvasWrite& write : std::span(writes->list).first(done))
    store(write.place + Vec2i(region.x0, region.y0), write.colour);
  slow.state.total = writes->list.size();
  slow.state.done.at = done;
  if (done > 0) slow.state.pixel = writes->list[done - 1].place + Vec2i(region.x0, region.y0);
  return slow;
}

}  // namespace ps
