#include <algorithm>

#include "base/check.h"
#include "math/unit.h"
#include "raytrace/fast/packet.h"
#include "raytrace/fast/plain_material.h"
#include "raytrace/sampling/plan.h"
#include "shade/faint_highlight.h"

namespace ps {
namespace {

PacketSphere packet_sphere(const PixelId& id, const TracedSphere<float>& sphere, const ShadingMaterial<float>& material,
                           const Vec3f& eye) {
  PacketSphere result;
  result.id = id;
  result.x = sphere.centre.x;
  result.y = sphere.centre.y;
  result.z = sphere.centre.z;
  result.radius = sphere.radius;
  const Vec3d from_centre = Vec3d(eye) - Vec3d(sphere.centre);
  const double radius = static_cast<double>(sphere.radius);
  result.eye_c = static_cast<float>(dot(from_centre, from_centre) - radius * radius);
  result.colour = material.colour;
  result.reflective = material.reflective;
  result.specular = material.specular.has_value();
  result.exponent = material.specular.value_or(1.0f);
  result.faint = faint_cosine(result.exponent);
  return result;
}

}  // namespace

bool suits_packets(const TraceInputs<float>& inputs) {
  const auto suits = [](float square) { return has_exact_square(square); };
  return suits(dot(inputs.right, inputs.right)) && suits(dot(inputs.up, inputs.up)) &&
         suits(dot(inputs.forward, inputs.forward)) &&
         std::all_of(inputs.geometry->spheres.begin(), inputs.geometry->spheres.end(),
                     [&](const TracedSphere<float>& sphere) { return suits(sphere.radius * sphere.radius); });
}

PacketScene packet_scene(const TraceInputs<float>& inputs) {
  PS_ASSERT(inputs.path.machinery == Machinery::sphere_packets, "traced_fast_path() decides what packets draw");
  const TracedGeometry<float>& geometry = *inputs.geometry;
  const Settings& settings = inputs.settings;
  PacketScene scene;
  for (const Primitive& primitive : geometry.primitives) {
    const ShadingMaterial<float>& material = inputs.materials[primitive.material];
    PS_ASSERT(has_plain_light(material), "traced_fast_path() lets plain surfaces alone into packets");
    scene.spheres.push_back(packet_sphere(primitive.id, geometry.spheres[primitive.shape], material, inputs.eye));
  }
  scene.lights = inputs.lights;
  scene.viewport = inputs.viewport;
  scene.eye = inputs.eye;
  scene.right = inputs.right;
  scene.up = inputs.up;
  scene.forward = inputs.forward;
  scene.background = inputs.background;
  scene.near = inputs.near;
  scene.far = inputs.far;
  scene.depth = settings.reflection_depth;
  scene.cutoff = inputs.reflection_cutoff;
  scene.lighting = settings.lighting;
  scene.highlights = settings.specular;
  scene.shadows = settings.shadows != Shadows::none;
  scene.any_hit = settings.shadow_any_hit;
  scene.useful_only = settings.shadow_rays == ShadowRays::useful;
  const SamplingPlan plan = sampling_plan(settings);
  if (plan.mode == SamplingMode::subsampling) scene.step = plan.step;
  const auto* bvh = accelerator_as<BvhOnDemand<float>>(inputs.accelerator);
  scene.tree = bvh && !bvh->tree().nodes.empty();
  return scene;
}

}  // namespace ps
