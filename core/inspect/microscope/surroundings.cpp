#include "inspect/microscope/surroundings.h"

#include <algorithm>
#include <array>
#include <span>

#include "frame/fast_kernels.h"
#include "options/renderer_kind.h"
#include "render/render.h"
#include "render/story/names.h"

namespace ps {
namespace {

// How far is looked, in pixels to each side, one after the other until an edge is near. Rays cost what their pixels
// cost; fragments begin with all triangles of the scene for every square, so that there is only one.
constexpr std::array reaches_of_rays{8, 24, 64};
constexpr std::array reach_of_fragments{64};

std::span<const int> reaches(Renderer renderer) {
  if (draws_fragments(renderer)) return reach_of_fragments;
  return reaches_of_rays;
}

/// Whether any pixel can be said to lie in a shadow.
bool has_shadows(const Settings& settings, const SceneTraits& traits) {
  if (!settings.lighting || !traits.casting_lights || settings.shadows == Shadows::none) return false;
  return sends_rays(settings.renderer) || settings.shadows != Shadows::traced;
}

/// Settings with which each pixel shows the same things in the same shadows, with one sample and as little as possible
/// of what would only colour it.
Settings bare(Settings settings, const SceneTraits& traits) {
  settings.samples_per_pixel = 1;
  settings.adaptive_sampling = false;
  settings.subsampling = 1;
  settings.multisampling = 1;
  settings.reflection_depth = 0;
  settings.environment = Environment::none;
  const bool shadowed = has_shadows(settings, traits);
  if (!shadowed) {
    settings.lighting = false;
    settings.normal_mapping = false;
    settings.parallax = Parallax::off;
  }
  // Useful shadow rays are those to where light would add to the colour. Opacity maps cut holes, but not for rays.
  if (!shadowed || (sends_rays(settings.renderer) && settings.shadow_rays == ShadowRays::all)) {
    settings.specular = false;
    settings.textures = settings.textures && traits.opacity_maps && !sends_rays(settings.renderer);
  }
  return settings;
}

struct Seen {
  PixelId id;
  std::uint32_t shadow = 0;
  bool operator==(const Seen&) const = default;
};

/// The pixels of a square around one, as the picture shows them.
class SeenSquare {
 public:
  /// Of bare() settings.
  SeenSquare(const Scene& scene, const View& view, const Settings& settings, Channel channels, Vec2i pixel, int reach,
             Prepared& prepared, Progress& progress)
      : scene_(scene), part_{std::max(pixel.x - reach, 0), std::max(pixel.y - reach, 0),
                             std::min(pixel.x + reach + 1, view.width), std::min(pixel.y + reach + 1, view.height)} {
    RenderRequest request;
    request.channels = channels;
    request.region = part_;
    request.outside = Outside::anything;
    frame_ = render(scene, view, settings, request, prepared, progress);
  }
  bool contains(Vec2i p) const { return part_.contains(p.x, p.y); }
  Seen at(Vec2i p) const { return row_of(p.y).at(p.x); }
  std::string name(Vec2i p) const {
    const PixelId id = at(p).id;
    return id.object < 0 ? "the background" : primitive_name(scene_, id);
  }

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
    std::optional<Vec2i> found;
    int least = 0;
    const auto offer = [&](Vec2i p) {
      const int distance = (p.x - from.x) * (p.x - from.x) + (p.y - from.y) * (p.y - from.y);
      const bool first = found && (p.y < found->y || (p.y == found->y && p.x < found->x));
      if (found && (distance > least || (distance == least && !first))) return;
      found = p;
      least = distance;
    };
    const auto compare = [&](Vec2i p, Vec2i next, const Seen& a, const Seen& b) {
      if (a == b) return;
      offer(p);
      offer(next);
    };
    for (int y = part_.y0; y < part_.y1; ++y) {
      const Row row = row_of(y), below = row_of(std::min(y + 1, part_.y1 - 1));
      for (int x = part_.x0; x < part_.x1; ++x) {
        const int right = std::min(x + 1, part_.x1 - 1);
        compare({x, y}, {right, y}, row.at(x), row.at(right));
        compare({x, y}, {x, y + 1}, row.at(x), below.at(x));
      }
    }
    if (!found) return {};
    return NearestEdge{*found, name(*found), name(differing_neighbour(*found))};
  }

 private:
  /// A row of the picture.
  struct Row {
    std::span<const PixelId> ids;
    std::span<const std::uint32_t> shadow;  ///< empty where there are no shadows
    Seen at(int x) const {
      const auto i = static_cast<std::size_t>(x);
      return {ids[i], shadow.empty() ? 0 : shadow[i]};
    }
  };
  Row row_of(int y) const {
    return {frame_.ids.row(y), frame_.shadow.empty() ? std::span<const std::uint32_t>() : frame_.shadow.row(y)};
  }

  /// The pixel must have one.
  Vec2i differing_neighbour(Vec2i p) const {
    for (const Vec2i beside : {Vec2i{p.x - 1, p.y}, {p.x + 1, p.y}, {p.x, p.y - 1}})
      if (contains(beside) && at(beside) != at(p)) return beside;
    return {p.x, p.y + 1};
  }

  const Scene& scene_;
  TileRect part_;
  Frame frame_;
};

}  // namespace

std::optional<PixelSurroundings> look_around(const Scene& scene, const View& view, const Settings& settings,
                                             Vec2i pixel, Prepared& prepared, Progress& progress) {
  if (picture_way(settings.renderer) == PictureWay::listing) return {};
  const SceneTraits traits = prepared_traits(scene, prepared);
  const Settings bare_settings = bare(settings, traits);
  const Channel channels = has_shadows(settings, traits) ? Channel::ids | Channel::shadow : Channel::ids;
  PixelSurroundings surroundings;
  for (const int reach : reaches(settings.renderer)) {
    const SeenSquare square(scene, view, bare_settings, channels, pixel, reach, prepared, progress);
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
