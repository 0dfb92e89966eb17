// Frustum, image plane with pixel grid, picked pixel, near plane and lights.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "inspect/space_parts.h"
#include "options/renderer_kind.h"
#include "render/story/names.h"

namespace ps {
namespace {

constexpr int most_grid_lines = 24;        // along the longer side
constexpr double arrow_share = 0.2;        // length of a directional light's arrow, of the bounds' radius
constexpr double arrow_start_share = 0.8;  // how far from the middle it begins

std::vector<Vec3d> rectangle(const SpaceImage& image, const Vec2d& low, const Vec2d& high, double z) {
  return {image.at_depth(low, z), image.at_depth({high.x, low.y}, z), image.at_depth(high, z),
          image.at_depth({low.x, high.y}, z)};
}

/// Every how many pixels a line is drawn: 1, 2, 5, 10, 20, ...
int grid_step(int pixels) {
  for (int power = 1;; power *= 10)
    for (const int digit : {1, 2, 5})
      if (pixels <= digit * power * most_grid_lines) return digit * power;
}

void add_grid(const SpaceImage& image, SpaceModel& model) {
  const int step = grid_step(std::max(image.columns(), image.rows()));
  const double w = image.columns(), h = image.rows();
  const auto line = [&](const Vec2d& from, const Vec2d& to) {
    model.items.push_back({SpaceKind::pixel_grid, SpaceShape::line, {image.at(from), image.at(to)}});
  };
  for (int x = step; x < image.columns(); x += step) line({x, 0}, {x, h});
  for (int y = step; y < image.rows(); y += step) line({0, y}, {w, y});
}

/// The other planes of the clipping volume (CGFS ch. 11), where fragments are clipped: left, right, top and bottom from
/// the near plane outwards, and the far plane where it is in sight.
void add_clip_volume(const SpaceInputs& inputs, SpaceModel& model) {
  constexpr double length = 1.6;  // of the side planes, in radii of what is worth seeing
  if (!draws_fragments(inputs.settings.renderer) || inputs.settings.clipping != Clipping::full) return;
  const SpaceImage& image = inputs.image;
  const double w = image.columns(), h = image.rows();
  const double limit = length * inputs.bounds.radius;
  const double near = std::min(image.near_depth(inputs.settings.near), limit);
  const double far = image.near_depth(inputs.settings.far);
  const double end = std::min(far, limit);
  const auto side = [&](const Vec2d& a, const Vec2d& b, const char* name) {
    model.items.push_back(
        {SpaceKind::clip_plane,
         SpaceShape::outline,
         {image.at_depth(a, near), image.at_depth(b, near), image.at_depth(b, end), image.at_depth(a, end)}});
    model.items.back().label = name;
  };
  side({0, 0}, {0, h}, "left plane");
  side({w, 0}, {w, h}, "right plane");
  side({0, 0}, {w, 0}, "top plane");
  side({0, h}, {w, h}, "bottom plane");
  if (far > limit) return;
  model.items.push_back({SpaceKind::clip_plane, SpaceShape::outline, rectangle(image, {0, 0}, {w, h}, far)});
  model.items.back().label = "far plane";
}

}  // namespace

void add_camera(const SpaceInputs& inputs, SpaceModel& model) {
  const SpaceImage& image = inputs.image;
  const double w = image.columns(), h = image.rows();
  const double plane = inputs.view.camera.projection_plane_d;
  const std::vector<Vec3d> corners = rectangle(image, {0, 0}, {w, h}, plane);
  const std::vector<Vec3d> behind = rectangle(image, {0, 0}, {w, h}, 0);
  for (std::size_t i = 0; i < 4; ++i)
    model.items.push_back({SpaceKind::frustum, SpaceShape::line, {behind[i], corners[i]}});
  model.items.back().label = "camera";
  add_grid(image, model);
  model.items.push_back({SpaceKind::image_plane, SpaceShape::outline, corners});
  const double near = image.near_depth(inputs.settings.near);
  const bool cuts = sends_rays(inputs.settings.renderer) || inputs.settings.clipping != Clipping::none;
  if (cuts && near > 0 && near < 10 * inputs.bounds.radius) {
    model.items.push_back({SpaceKind::clip_plane, SpaceShape::outline, rectangle(image, {0, 0}, {w, h}, near)});
    model.items.back().label = near == plane ? "near plane = image plane" : "near plane";
  }
  add_clip_volume(inputs, model);
  if (!inputs.story) return;
  const Vec2d pixel(inputs.story->pixel);
  model.items.push_back({SpaceKind::pixel_cell, SpaceShape::area, rectangle(image, pixel, pixel + Vec2d(1, 1), plane)});
}

void add_lights(const SpaceInputs& inputs, SpaceModel& model) {
  int index = -1;
  for (const Light& light : *inputs.scene.lights) {
    ++index;
    SpaceItem item{SpaceKind::light, SpaceShape::point, {light.position}};
    item.label = light_name(inputs.scene, index);
    switch (light.kind) {
    case LightKind::ambient:
      continue;
    case LightKind::point:
      break;
    case LightKind::directional: {
      const double length = glm::length(light.direction);
      if (!(length > 0)) continue;
      const double r = inputs.bounds.radius;
      const Vec3d from = inputs.bounds.centre + light.direction / length * (r * arrow_start_share);
      item.shape = SpaceShape::arrow;
      item.points = {from, from - light.direction / length * (r * arrow_share)};
      break;
    }
    }
    model.items.push_back(std::move(item));
  }
}

}  // namespace ps
