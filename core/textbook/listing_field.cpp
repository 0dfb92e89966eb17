#include "textbook/listing_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "base/number_text.h"
#include "textbook/book_canvas.h"
#include "textbook/book_scene.h"
#include "textbook/renderer.h"

namespace ps {
namespace {

using Instances = std::vector<WatchInstance>;

const WatchInstance& at(const Instances& instances, int index) { return instances[static_cast<std::size_t>(index)]; }

/// The work for the pixel that an instance belongs to; -1 = it belongs to none.
int work_around(const Instances& instances, int instance) {
  while (instance >= 0 && at(instances, instance).name != "pixel") instance = at(instances, instance).parent;
  return instance;
}

/// A line and the innermost loop around it in the work for a pixel: "28 sphere red", or "28" where there is none.
std::string subject_of_watch(const Instances& instances, const Watch& watch) {
  std::string subject = fmt::format("{}", watch.line);
  if (const WatchInstance& loop = at(instances, watch.instance); loop.name != "pixel")
    subject += fmt::format(" {} {}", loop.name, watch_text(loop.value));
  return subject;
}

std::optional<double> number_of(const WatchValue& value, int component) {
  return std::visit(
      [&](const auto& v) {
        using Value = std::remove_cvref_t<decltype(v)>;
        if constexpr (std::is_same_v<Value, Vec2d>)
          return number_in(std::vector<double>{v.x, v.y}, component);
        else if constexpr (std::is_same_v<Value, Vec3d>)
          return number_in(std::vector<double>{v.x, v.y, v.z}, component);
        else
          return number_in(FieldValue(v), component);
      },
      value);
}

/// How many values the work for a pixel has outside of its loops.
std::size_t own_values(std::span<const Watch> watches, const Instances& instances) {
  return static_cast<std::size_t>(std::count_if(watches.begin(), watches.end(), [&](const Watch& watch) {
    return at(instances, watch.instance).name == "pixel";
  }));
}

/// The number that the query asks for in the work for one pixel.
std::optional<double> find_in_work(const FieldQuery& query, int line, std::span<const Watch> watches,
                                   const Instances& instances) {
  int passed = 0;
  for (const Watch& watch : watches) {
    if (watch.line != line || watch.name != query.key || subject_of_watch(instances, watch) != query.subject) continue;
    if (passed++ == query.order) return number_of(watch.value, query.component);
  }
  return {};
}

}  // namespace

std::optional<FieldQuery> listing_query(const ListingTrace& trace, std::size_t watch, int component) {
  const Watch& asked = trace.watches[watch];
  const int work = work_around(trace.instances, asked.instance);
  if (work < 0 || !number_of(asked.value, component)) return {};
  FieldQuery query;
  query.kind = listing_line;
  query.subject = subject_of_watch(trace.instances, asked);
  query.key = asked.name;
  query.component = component;
  for (std::size_t i = 0; i < watch; ++i) {
    const Watch& before = trace.watches[i];
    const bool same = before.line == asked.line && before.name == asked.name;
    if (same && work_around(trace.instances, before.instance) == work &&
        subject_of_watch(trace.instances, before) == query.subject)
      ++query.order;
  }
  return query;
}

void find_field_of_listing(const FieldInputs& asked, Image<float>& values, Prepared&, Progress& progress) {
  std::string_view subject = asked.query.subject;
  const int line = take_integer<int>(subject).value_or(0);
  const BookScene book = book_scene(asked.scene, asked.view, asked.settings);
  const Listing& listing = *running_listing(asked.settings, scene_traits(asked.scene)).listing;
  const std::vector<TileRect> tiles = listing_tiles(listing, asked.view, asked.region);
  parallel_for(static_cast<int>(tiles.size()), asked.parallel, progress, [&](int index, int) {
    const TileRect& tile = tiles[static_cast<std::size_t>(index)];
    BookCanvas canvas(asked.view.width, asked.view.height, tile, book.background, &progress);
    Image<std::size_t> most(tile.width(), tile.height(), 0);  // own values of the work that is shown
    const WatchCollector collector([&](Vec2i pixel, std::span<const Watch> watches, const Instances& instances) {
      const Vec2i place = canvas.place_of(pixel.x, pixel.y);
      const std::size_t own = own_values(watches, instances);
      if (!most.contains(place.x, place.y) || own < most.at(place.x, place.y)) return;
      most.at(place.x, place.y) = own;
      const auto found = find_in_work(asked.query, line, watches, instances);
      values.at(tile.x0 + place.x, tile.y0 + place.y) =
          found ? static_cast<float>(*found) : std::numeric_limits<float>::quiet_NaN();
    });
    listing.draw(book, canvas);
  });
}

}  // namespace ps
