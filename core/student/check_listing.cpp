#include "student/check_listing.h"

#include <fmt/format.h>

#include "frame/display_frame.h"

#include "image/display.h"
#include "image/file.h"
#include "options/renderer_kind.h"
#include "record/value_text.h"
#include "textbook/book_canvas.h"

namespace ps {
namespace {

constexpr double white_level = 255;

template <class Colour>
Image<Colour> unit_picture(const Image<Vec3d>& picture) {
  Image<Colour> units(picture.width(), picture.height(), Unfilled{});
  for (std::size_t i = 0; i < units.pixels().size(); ++i) units.pixels()[i] = Colour(picture.pixels()[i] / white_level);
  return units;
}

}  // namespace

Settings settings_of_listing(const NamedListing& listing, const Settings& settings) {
  Settings own = settings;
  own.renderer = renderer_for(PictureWay::listing);
  own.listing_bug = 0;
  const auto all = listings();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].folder == listing.folder) own.listing = static_cast<int>(i) + 1;
  return own;
}

Image<Vec3d> right_picture(const NamedListing& listing, const Scene& scene, const View& view, const Settings& settings,
                           Progress& progress) {
  const Settings own = settings_of_listing(listing, settings);
  const BookScene book = book_scene(scene, view, own);
  Image<Vec3d> picture(view.width, view.height, Unfilled{});
  std::vector<TileRect> tiles{{0, 0, view.width, view.height}};
  constexpr int tile_size = 64;
  if (listing.listing->order == ListingOrder::pixel_by_pixel) tiles = make_tiles(view.width, view.height, tile_size);
  parallel_for(static_cast<int>(tiles.size()), {own.threads, WorkerPriority::background}, progress,
               [&](int index, int) {
                 const TileRect& tile = tiles[static_cast<std::size_t>(index)];
                 BookCanvas canvas(view.width, view.height, tile, book.background, &progress);
                 listing.listing->draw(book, canvas);
                 for (int y = tile.y0; y < tile.y1; ++y)
                   for (int x = tile.x0; x < tile.x1; ++x) picture.at(x, y) = canvas.at(x, y);
               });
  return picture;
}

CheckedListing check_listing(const ListingProgram& program, const NamedListing& listing, const Scene& scene,
                             const View& view, const Settings& settings, const std::optional<Vec2i>& pixel,
                             Progress& progress, const RunOptions& options) {
  CheckedListing checked;
  const Settings own = settings_of_listing(listing, settings);
  checked.run =
      run_listing(program, book_scene(scene, view, own), {.picture = true, .traced = pixel}, options, &progress);
  if (!checked.run.failure.empty()) return checked;
  checked.right = right_picture(listing, scene, view, settings, progress);
  checked.wrong = wrong_pixels(checked.run.result.picture, checked.right);
  return checked;
}

ListingTrace listing_trace(const OwnTrace& trace, const NamedListing& listing, Vec2i pixel) {
  return {.listing = listing,
          .pixel = pixel,
          .linear = trace.colour / white_level,
          .watches = trace.watches,
          .instances = trace.instances,
          .dropped = static_cast<std::size_t>(trace.dropped)};
}

std::string verdict_text(const WrongPixels& wrong, int width, int height) {
  if (wrong.count == 0) return "Your picture is that of the listing, to the bit.";
  return fmt::format(
      "{} of {} pixels differ from the listing's picture. Row by row from the top, the first of them is in "
      "column {} and row {}: yours is {}, the listing's {}.",
      wrong.count, static_cast<std::int64_t>(width) * height, wrong.first.x, wrong.first.y, vector_text(wrong.own),
      vector_text(wrong.right));
}

void save_own_picture(const std::filesystem::path& path, const Image<Vec3d>& picture, const Settings& settings) {
  if (path.extension() == ".pfm")
    save_pfm(path, unit_picture<Vec3f>(picture));
  else
    save_image(path, display_image(unit_picture<Vec3d>(picture), display_transform(settings)));
}

}  // namespace ps
