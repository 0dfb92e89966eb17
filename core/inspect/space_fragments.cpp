// The events of a rasterizer's story in space.
#include <cmath>

#include "inspect/space_parts.h"
#include "render/story/names.h"
#include "render/story/story_tree.h"

namespace ps {
namespace {

constexpr double behind_share = 2.4;  // how far a line of sight goes that meets nothing

using Polygon = std::vector<Vec2d>;

/// Sutherland-Hodgman against one side: keeps where `inside` is not negative.
template <class Distance>
Polygon cut(const Polygon& polygon, Distance&& inside) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = inside(a), at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return kept;
}

/// The part of a triangle that lies on the picture.
Polygon on_picture(const std::array<Vec2d, 3>& corners, double width, double height) {
  Polygon polygon(corners.begin(), corners.end());
  polygon = cut(polygon, [](const Vec2d& p) { return p.x; });
  polygon = cut(polygon, [&](const Vec2d& p) { return width - p.x; });
  polygon = cut(polygon, [](const Vec2d& p) { return p.y; });
  return cut(polygon, [&](const Vec2d& p) { return height - p.y; });
}

class FragmentParts {
 public:
  FragmentParts(const SpaceInputs& inputs, SpaceModel& model)
      : inputs_(inputs), events_(inputs.story->events), model_(model),
        sample_(inputs.image.sample(inputs.story->pixel)) {}

  void add() {
    find_winner();
    for (int i = 0; i < static_cast<int>(events_.size()); ++i) {
      const EventData& data = events_[static_cast<std::size_t>(i)].data;
      if (const auto* fragment = std::get_if<FragmentEvent>(&data)) {
        add_fragment(i, *fragment);
      } else if (const auto* reject = std::get_if<RejectEvent>(&data)) {
        if (const auto corners = world_triangle(inputs_.scene, reject->id)) add_rejected(i, *corners);
      } else if (const auto* light = std::get_if<LightEvent>(&data)) {
        add_light(i, *light);
      }
    }
    add_sight_line();
  }

 private:
  /// The fragment that wrote last is what the pixel shows.
  void find_winner() {
    for (int i = 0; i < static_cast<int>(events_.size()); ++i) {
      const EventData& data = events_[static_cast<std::size_t>(i)].data;
      if (const auto* fragment = std::get_if<FragmentEvent>(&data))
        if (fragment->depth != FragmentEvent::Depth::failed) winner_ = i;
    }
  }

  void add_fragment(int index, const FragmentEvent& fragment) {
    std::array<Vec3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = inputs_.image.at_depth(fragment.corners[k], fragment.corner_depth[k]);
    SpaceItem item;
    item.event = index;
    item.emphasised = index == winner_;
    item.contribution = item.emphasised ? 1 : 0;
    item.label = primitive_name(inputs_.scene, fragment.id);
    add_triangle(corners, fragment.weights, item, model_);
    Polygon shown = on_picture(fragment.corners, inputs_.image.columns(), inputs_.image.rows());
    if (shown.size() >= 3) {
      SpaceItem shadow = item;
      shadow.kind = SpaceKind::triangle_on_image;
      shadow.shape = SpaceShape::area;
      shadow.label.clear();
      for (const Vec2d& p : shown) shadow.points.push_back(inputs_.image.at(p));
      model_.items.push_back(std::move(shadow));
    }
    item.kind = SpaceKind::hit_point;
    item.shape = SpaceShape::point;
    item.points = {inputs_.image.at_depth(sample_, fragment.z)};
    point_ = item.points.front();
    model_.items.push_back(item);
    if (!item.emphasised) return;
    const Vec3d across = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = std::sqrt(dot(across, across));
    if (!(length > 0)) return;
    // Vertices may be on the canvas in either order; the front is the side that the renderer says is seen.
    const bool faces_eye = dot(across, inputs_.image.eye(sample_) - point_) > 0;
    const double sense = faces_eye == fragment.back_face ? -1 : 1;
    add_normal(SpaceKind::geometric_normal, point_, across * (sense / length), item, inputs_, model_);
  }

  void add_rejected(int index, const std::array<Vec3d, 3>& corners) {
    SpaceItem item{SpaceKind::rejected_triangle, SpaceShape::outline, {corners.begin(), corners.end()}, index};
    item.contribution = 0;
    item.emphasised = false;
    model_.items.push_back(std::move(item));
  }

  /// Lights are reported after the fragment whose colour they make. The rasterizer tests no shadows.
  void add_light(int index, const LightEvent& light) {
    const double length = std::sqrt(dot(light.to_light, light.to_light));
    if (light.kind == LightKind::ambient || !(length > 0)) return;
    SpaceItem item{SpaceKind::light_direction, SpaceShape::line, {}, index};
    if (light.kind == LightKind::point) {  // lit where it says: with Gouraud shading that is a vertex
      const auto& lights = *inputs_.scene.lights;
      if (light.light < 0 || static_cast<std::size_t>(light.light) >= lights.size()) return;  // the story is older
      const Vec3d& position = lights[static_cast<std::size_t>(light.light)].position;
      item.points = {position - light.to_light, position};
    } else {
      const int parent = events_[static_cast<std::size_t>(index)].parent;
      const auto* lit_at =
          parent < 0 ? nullptr : std::get_if<VertexLightEvent>(&events_[static_cast<std::size_t>(parent)].data);
      const Vec3d from = lit_at ? lit_at->position : point_;
      item.points = {from, from + light.to_light * (sunward_share * inputs_.bounds.radius / length)};
    }
    model_.items.push_back(std::move(item));
  }

  void add_sight_line() {
    const double z = winner_ >= 0 ? event_as<FragmentEvent>(events_, winner_).z : behind_share * inputs_.bounds.radius;
    SpaceItem item{SpaceKind::sight_line, SpaceShape::line, {}, winner_};
    item.points = {inputs_.image.eye(sample_), inputs_.image.at_depth(sample_, z)};
    model_.items.push_back(std::move(item));
  }

  const SpaceInputs& inputs_;
  const std::vector<Event>& events_;
  SpaceModel& model_;
  Vec2d sample_;
  int winner_ = -1;       // index of the fragment that is seen
  Vec3d point_{0, 0, 0};  // of the newest fragment
};

}  // namespace

void add_fragments(const SpaceInputs& inputs, SpaceModel& model) { FragmentParts(inputs, model).add(); }

}  // namespace ps
