#include "gui/panels/space/space_paint.h"

#include <algorithm>
#include <cmath>

#include "gui/theme/theme.h"

namespace ps::gui {
namespace {

constexpr double pointer_reach = 7;     // how near the pointer must be, pixels at scale 1
constexpr double point_nearness = 0.6;  // points win over the lines that end in them
constexpr int image_patches = 10;       // along each side; a patch is drawn without perspective

double distance_to(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return glm::length(p - a - t * along);
}

/// In patches small enough to look right in perspective.
void draw_patches(ImDrawList& list, const Area& area, const std::vector<Vec3d>& plane,
                  const SpaceProjection& projection, const Texture& texture) {
  const auto at = [&](int x, int y) -> std::optional<ImVec2> {
    const double u = static_cast<double>(x) / image_patches, v = static_cast<double>(y) / image_patches;
    const auto place =
        projection.point((plane[0] * (1 - u) + plane[1] * u) * (1 - v) + (plane[3] * (1 - u) + plane[2] * u) * v);
    if (!place) return {};
    return ImVec2{area.min.x + static_cast<float>(place->at.x), area.min.y + static_cast<float>(place->at.y)};
  };
  constexpr float step = 1.f / image_patches;
  for (int y = 0; y < image_patches; ++y)
    for (int x = 0; x < image_patches; ++x) {
      const auto a = at(x, y), b = at(x + 1, y), c = at(x + 1, y + 1), d = at(x, y + 1);
      if (!a || !b || !c || !d) continue;
      const float u = static_cast<float>(x) * step, v = static_cast<float>(y) * step;
      list.AddImageQuad(texture.id(), *a, *b, *c, *d, {u, v}, {u + step, v}, {u + step, v + step}, {u, v + step},
                        IM_COL32(255, 255, 255, 205));
    }
}

}  // namespace

void draw_on_image_plane(ImDrawList& list, const Area& area, const SpaceModel& model, const SpaceProjection& projection,
                         const SpaceLook& look, const Texture& texture) {
  if (texture.empty()) return;
  for (const SpaceItem& item : model.items)
    if (item.kind == SpaceKind::image_plane && is_shown(item, look))
      draw_patches(list, area, item.points, projection, texture);
}

int event_under(ImVec2 pointer, const Area& area, const SpaceModel& model, const SpaceProjection& projection,
                const SpaceLook& look) {
  const Vec2d at(pointer.x - area.min.x, pointer.y - area.min.y);
  int found = -1;
  double nearest = px(pointer_reach);
  for_each_shown(model, look, [&](const SpaceItem& item) {
    if (item.event < 0) return;
    const auto offer = [&](double distance) {
      if (distance >= nearest) return;
      nearest = distance;
      found = item.event;
    };
    for_each_line(item, [&](const Vec3d& from, const Vec3d& to) {
      if (const auto seen = projection.line(from, to)) offer(distance_to(at, seen->from.at, seen->to.at));
    });
    if (item.shape != SpaceShape::point) return;
    if (const auto place = projection.point(item.points[0])) offer(point_nearness * glm::length(at - place->at));
  });
  return found;
}

}  // namespace ps::gui
