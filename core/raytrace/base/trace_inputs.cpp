#include "raytrace/base/trace_inputs.h"

#include <cmath>

#include "math/unit.h"
#include "options/triangle_tests.h"
#include "raytrace/base/eye_bodies.h"
#include "raytrace/base/fast_path.h"
#include "scene/world.h"

namespace ps {
namespace {

/// Primitive tests in finite precision accept rays that pass by at a distance of some rounding errors of the
/// coordinates; boxes must not turn those away, or the picture would depend on the accelerator. The textbook quadratic
/// errs by the square root of a rounding error.
template <class Real>
Real padding(const Settings& settings) {
  constexpr Real u = std::numeric_limits<Real>::epsilon() / 2;
  constexpr Real operations = 32;
  return settings.sphere_test == SphereTest::quadratic ? std::sqrt(operations * u) : operations * u;
}

/// Boxes are seen from rays where geometry.seen says so, if the tests of primitives too begin with differences from the
/// ray's origin: those that SIMD repeats do.
template <class Real>
SlabForm slab_form(const Settings& settings, const TracedGeometry<Real>& geometry) {
  if (settings.slab_test == SlabTest::naive) return SlabForm::naive;
  const bool by_differences = row_of(settings.triangle_test).simd && settings.sphere_test == SphereTest::robust;
  return by_differences && geometry.seen.centre != Vec3<Real>(0) ? SlabForm::from_ray : SlabForm::robust;
}

/// The book's interval of t is closed (CGFS ch. 2), and the rasterizer keeps what lies right on a clipping plane. A ray
/// may meet such a surface some rounding errors before or behind it.
template <class Real>
constexpr Real limit_slack = 8 * std::numeric_limits<Real>::epsilon();

/// How far from the eye an eye ray may begin, world units.
template <class Real>
double eye_reach(const TraceInputs<Real>& inputs, const View& view) {
  const Vec3d forward(inputs.forward);
  const double across =
      length_of(view.camera.right) * inputs.viewport.width / 2 + length_of(view.camera.up) * inputs.viewport.height / 2;
  const double along = static_cast<double>(inputs.near) * length_of(forward);
  switch (inputs.viewport.projection) {
  case Projection::perspective:
    return along + static_cast<double>(inputs.near) * across;
  case Projection::orthographic:
    return along + across;
  }
  return along + across;
}

}  // namespace

template <class Real>
TraceInputs<Real> make_trace_inputs(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                                    Channel channels) {
  TraceInputs<Real> inputs;
  inputs.geometry = traced_geometry<Real>(scene, settings, prepared);
  inputs.accelerator = traced_accelerator<Real>(scene, inputs.geometry, settings, prepared);
  for (const Material& material : *scene.materials)
    inputs.any_transparent = inputs.any_transparent || material.transparency > 0 || material.opacity_map >= 0;
  inputs.path = traced_fast_path(settings, prepared_traits(scene, prepared), channels);
  const auto* bvh = accelerator_as<BvhOnDemand<Real>>(inputs.accelerator);
  if (bvh && inputs.path.machinery != Machinery::wide_triangles) bvh->tree();  // here, with all threads
  inputs.materials = shading_materials<Real>(*scene.materials);
  inputs.lights = shading_lights<Real>(*scene.lights, settings.light_shown);
  for (const Texture& texture : *scene.textures) {
    inputs.textures.push_back(texture.texels);
    inputs.wraps.push_back(texture.clamped ? TextureWrap::clamp : settings.texture_wrap);
  }
  if (settings.normal_mapping && settings.mapped_normals == MappedNormals::inverse_transpose &&
      prepared_traits(scene, prepared).normal_maps)
    for (const Object& object : scene.geometry->objects)
      inputs.placings.push_back(placing_of<Real>(linear_part(object)));
  inputs.background = Vec3<Real>(scene.background);
  inputs.settings = settings;
  inputs.viewport = make_viewport<Real>(view, settings);
  const Camera& camera = view.camera;
  inputs.eye = Vec3<Real>(camera.position);
  inputs.right = Vec3<Real>(camera.right);
  inputs.up = Vec3<Real>(camera.up);
  inputs.forward = Vec3<Real>(camera.forward) * inputs.viewport.distance;
  inputs.near = static_cast<Real>(settings.near) * (1 - limit_slack<Real>);
  inputs.far = static_cast<Real>(settings.far) * (1 + limit_slack<Real>);
  if (inputs.any_transparent && settings.refraction && settings.reflection_depth > 0)
    inputs.eye_bodies = eye_bodies(scene, *inputs.geometry, eye_reach(inputs, view), camera.position);
  inputs.triangle_epsilon = static_cast<Real>(settings.triangle_epsilon);
  inputs.shadow_epsilon = static_cast<Real>(settings.shadow_epsilon);
  inputs.reflection_epsilon = static_cast<Real>(settings.reflection_epsilon);
  inputs.reflection_cutoff = static_cast<Real>(settings.reflection_cutoff);
  inputs.box_padding = padding<Real>(settings);
  inputs.slab_form = slab_form(settings, *inputs.geometry);
  return inputs;
}

template TraceInputs<float> make_trace_inputs(const Scene&, const View&, const Settings&, Prepared&, Channel);
template TraceInputs<double> make_trace_inputs(const Scene&, const View&, const Settings&, Prepared&, Channel);

}  // namespace ps
