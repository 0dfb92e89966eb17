#include "raster/replaced_fragment.h"

#include <vector>

#include "raster/clear/depth_test.h"
#include "raster/clear/shade_fragment.h"
#include "record/recorder.h"

namespace ps::raster {
namespace {

/// A copy of a triangle that may be changed.
class ReplacedTriangle {
 public:
  ReplacedTriangle(const Pass<float>& pass, const TriangleSetup<float>& setup, Vec2i pixel)
      : pass_(pass), setup_(setup), triangle_(*setup.triangle), surface_(*setup.surface),
        attributes_(setup.attributes, setup.attributes + stored_count()),
        fragment_(make_fragment(pass, setup, pixel.x, pixel.y, setup.edges.at(pixel.x, pixel.y))) {
    setup_.triangle = &triangle_;
    setup_.surface = &surface_;
    setup_.attributes = attributes_.data();
  }
  ReplacedTriangle(const ReplacedTriangle&) = delete;
  ReplacedTriangle& operator=(const ReplacedTriangle&) = delete;

  const TriangleSetup<float>& setup() const { return setup_; }
  const Fragment<float>& fragment() const { return fragment_; }

  void replace(const GivenFragment& given) {
    AttributeLayout& layout = surface_.layout;
    if (given.z) {
      fragment_.z = *given.z;
      fragment_.inverse_z = 1 / *given.z;
    }
    move3(layout.position, given.position);
    set_normal(given.normal);
    move3(layout.light, given.light);
    move3(layout.extra, given.extra);
    if (layout.flat_light) set_flat(given);
    if (given.uv && layout.uv != AttributeLayout::absent) {
      move(layout.uv, given.uv->x);
      move(layout.uv + 1, given.uv->y);
    }
    ShadingMaterial<float>& material = surface_.material;
    if (given.surface) {
      material.colour = *given.surface;
      material.texture = -1;
    }
    if (given.mapped_normal) {
      set_normal(given.mapped_normal);
      layout.mapped_normal = layout.relief = false;
    }
    if (!layout.light_maps) return;
    if (given.specular) material.specular_colour = *given.specular, material.specular_map = -1;
    if (given.ambient) material.ambient_colour = *given.ambient, material.ambient_map = -1;
  }

 private:
  std::size_t stored_count() const {
    const AttributeLayout& layout = surface_.layout;
    return 3 * static_cast<std::size_t>(layout.count) + (layout.flat_light ? 6u : 0u) + (triangle_.cut ? 9u : 0u);
  }
  /// Adds the same to the attribute at all three vertices, so that it has the value at the fragment.
  void move(int slot, float value) {
    const auto stride = static_cast<std::size_t>(surface_.layout.count);
    const auto at = static_cast<std::size_t>(slot);
    const float now = fragment_.weights[0] * attributes_[at] + fragment_.weights[1] * attributes_[at + stride] +
                      fragment_.weights[2] * attributes_[at + 2 * stride];
    const bool divides = pass_.divides();
    const float share = divides ? weighted(fragment_.weights, triangle_.inverse_z) : 1.0f;
    const float change = ((divides ? value / fragment_.z : value) - now) / share;
    for (std::size_t k = 0; k < 3; ++k)
      attributes_[at + k * stride] += divides ? change * triangle_.inverse_z[k] : change;
  }
  void move3(int slot, const std::optional<Vec3f>& value) {
    if (!value || slot == AttributeLayout::absent) return;
    for (int axis = 0; axis < 3; ++axis) move(slot + axis, (*value)[axis]);
  }
  void set_normal(const std::optional<Vec3f>& normal) {
    if (!normal) return;
    if (surface_.layout.normal == AttributeLayout::absent)
      triangle_.face_normal = *normal;
    else
      move3(surface_.layout.normal, normal);
  }
  void set_flat(const GivenFragment& given) {
    const auto first = 3 * static_cast<std::size_t>(surface_.layout.count);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      if (given.light) attributes_[first + i] = (*given.light)[axis];
      if (given.extra) attributes_[first + 3 + i] = (*given.extra)[axis];
    }
  }

  const Pass<float>& pass_;
  TriangleSetup<float> setup_;
  ScreenTriangle<float> triangle_;
  Surface<float> surface_;
  std::vector<float> attributes_;
  Fragment<float> fragment_;
};

/// Weights of the three points where the line of sight through a sample meets their plane; they add up to 1.
Vec3d weights_on_sight(const std::array<Vec3d, 3>& p, const Vec2d& sight, bool perspective) {
  if (perspective) {
    const Vec3d ray(sight, 1);
    const Vec3d w(dot(ray, cross(p[1], p[2])), dot(ray, cross(p[2], p[0])), dot(ray, cross(p[0], p[1])));
    return w / (w.x + w.y + w.z);
  }
  const auto area = [](const Vec2d& a, const Vec2d& b) { return a.x * b.y - a.y * b.x; };
  const Vec2d a(p[0]), b(p[1]), c(p[2]);
  const Vec3d w(area(b - sight, c - sight), area(c - sight, a - sight), area(a - sight, b - sight));
  return w / (w.x + w.y + w.z);
}

}  // namespace

Vec3f shade_replaced(const Pass<float>& pass, const ScreenGeometry<float>& geometry, const TriangleSetup<float>& setup,
                     Vec2i pixel, const GivenFragment& given) {
  ReplacedTriangle replaced(pass, setup, pixel);
  replaced.replace(given);
  CountingRecorder recorder;
  return shade_fragment(pass, geometry, replaced.setup(), replaced.fragment(), recorder).colour;
}

GivenFragment whole_triangle_values(const Pass<float>& pass, const ScreenGeometry<float>& geometry,
                                    const TriangleSetup<float>& setup, Vec2i pixel) {
  const CornerSource<float> source = corner_source(pass, geometry, *setup.triangle);
  const auto rounded = camera_corners(pass, geometry, *setup.triangle);
  const std::array<Vec3d, 3> corners{Vec3d(rounded[0]), Vec3d(rounded[1]), Vec3d(rounded[2])};
  Fragment<float> place;
  place.column = pixel.x;
  place.row = pixel.y;
  const Vec2d sight(on_projection_plane(pass.projection, place, pass.grid.sample));
  const Vec3d space = weights_on_sight(corners, sight, pass.perspective());
  const double z = space.x * corners[0].z + space.y * corners[1].z + space.z * corners[2].z;
  Vec3d weights = space;
  if (pass.perspective() && !pass.divides())  // affine: linear on the screen
    weights = Vec3d(space.x * corners[0].z, space.y * corners[1].z, space.z * corners[2].z) / z;
  const Surface<float>& surface = *setup.surface;
  CountingRecorder recorder;
  const auto values = corner_attributes(pass, surface, source, recorder);
  const auto at = [&](int slot) {
    const auto i = static_cast<std::size_t>(slot);
    return static_cast<float>(weights.x * static_cast<double>(values[0][i]) +
                              weights.y * static_cast<double>(values[1][i]) +
                              weights.z * static_cast<double>(values[2][i]));
  };
  const auto at3 = [&](int slot) -> std::optional<Vec3f> {
    if (slot == AttributeLayout::absent) return {};
    return Vec3f(at(slot), at(slot + 1), at(slot + 2));
  };
  const AttributeLayout& layout = surface.layout;
  GivenFragment given;
  given.z = static_cast<float>(z);
  given.position = at3(layout.position);
  given.normal = at3(layout.normal);
  given.light = at3(layout.light);
  given.extra = at3(layout.extra);
  if (layout.uv != AttributeLayout::absent) given.uv = Vec2f(at(layout.uv), at(layout.uv + 1));
  return given;
}

}  // namespace ps::raster
