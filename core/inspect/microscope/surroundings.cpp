#include "inspect/microscope/surroundings.h"

#include <algorithm>
#include <array>

#include "options/renderer_kind.h"
#include "render/render.h"
#include "render/story/names.h"

namespace ps {
namespace {

constexpr std::array reaches{8, 64};  // pixels to each side, tried one after the other

struct Seen {
  PixelId id;
  std::uint32_t shadow = 0;
  bool operator==(const Seen&) const = default;
};

/// The pixels of a square around one, as the picture shows them.
class SeenSquare {
 public:
  SeenSquare(const Scene& scene, const View& view, Settings settings, Vec2i pixel, int reach, Prepared& prepared,
             Progress& progress)
      : scene_(scene), part_{std::max(pixel.x - reach, 0), std::max(pixel.y - reach, 0),
                             std::min(pixel.x + reach + 1, view.width), std::min(pixel.y + reach + 1, view.height)} {
    settings.samples_per_pixel = 1;
    settings.adaptive_sampling = false;
    settings.subsampling = 1;
    settings.multisampling = 1;
    RenderRequest request;
    request.channels = Channel::ids | Channel::shadow;
    request.region = part_;
    frame_ = render(scene, view, settings, request, prepared, progress);
  }
  bool contains(Vec2i p) const { return p.x >= part_.x0 && p.x < part_.x1 && p.y >= part_.y0 && p.y < part_.y1; }
  Seen at(Vec2i p) const { return {frame_.ids.at(p.x, p.y), frame_.shadow.at(p.x, p.y)}; }
  std::string name(Vec2i p) const {
    const PixelId id = at(p).id;
    return id.object < 0 ? "the background" : primitive_name(scene_, id);
  }
  const TileRect& part() const { return part_; }

  std::vector<SeenPixel> neighbourhood(Vec2i pixel) const {
    std::vector<SeenPixel> around;
    for (int y = pixel.y - 1; y <= pixel.y + 1; ++y)
      for (int x = pixel.x - 1; x <= pixel.x + 1; ++x) {
        if (!contains({x, y})) continue;
        SeenPixel one{{x, y}, name({x, y}), {}};
        const std::uint32_t mask = at({x, y}).shadow;
        for (int light = 0; light < 32; ++light)
          if ((mask >> light & 1U) != 0) one.blocked.push_back(light);
        around.push_back(std::move(one));
      }
    return around;
  }

  /// The nearest pixel with a neighbour that shows something else; of several, the first in reading order.
  std::optional<NearestEdge> nearest(Vec2i from) const {
    std::optional<NearestEdge> found;
    int least = 0;
    for (int y = part_.y0; y < part_.y1; ++y)
      for (int x = part_.x0; x < part_.x1; ++x) {
        const int distance = (x - from.x) * (x - from.x) + (y - from.y) * (y - from.y);
        if (found && distance >= least) continue;
        for (const Vec2i beside : {Vec2i{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
          if (!contains(beside) || at(beside) == at({x, y})) continue;
          found = NearestEdge{{x, y}, name({x, y}), name(beside)};
          least = distance;
          break;
        }
      }
    return found;
  }

 private:
  const Scene& scene_;
  TileRect part_;
  Frame frame_;
};

}  // namespace

std::optional<PixelSurroundings> look_around(const Scene& scene, const View& view, const Settings& settings,
                                             Vec2i pixel, Prepared& prepared, Progress& progress) {
  if (picture_way(settings.renderer) == PictureWay::listing) return {};
  PixelSurroundings surroundings;
  for (const int reach : reaches) {
    const SeenSquare square(scene, view, settings, pixel, reach, prepared, progress);
    if (surroundings.around.empty()) surroundings.around = square.neighbourhood(pixel);
    surroundings.searched = reach;
    surroundings.edge = square.nearest(pixel);
    // An edge in a corner of the square may be farther away than one just outside a side.
    if (surroundings.edge) {
      const Vec2i away = surroundings.edge->pixel - pixel;
      if (away.x * away.x + away.y * away.y < reach * reach) break;
    }
  }
  return surroundings;
}

}  // namespace ps
