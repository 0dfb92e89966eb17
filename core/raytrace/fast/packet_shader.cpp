#include "raytrace/fast/packet_shader.h"

#include <bit>

namespace ps {

void PacketShader::shade(std::span<const Ray<float>> rays, std::span<const Hit<float>> hits, std::span<Vec3f> colours) {
  unsigned lanes = 0;
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (hits[i].found() && put_lane(i, rays[i], hits[i])) lanes |= 1u << i;
  if (lanes != 0) {
    const auto count = static_cast<std::uint64_t>(std::popcount(lanes));
    recorder_.count(Counter::shading_calls, count);
    if (tables_.lighting) recorder_.count(Counter::light_samples, count * tables_.lights.size());
    if (tables_.lighting && inputs_.settings.shadows != Shadows::none)
      find_shadows(lanes, rays, hits);
    else
      tables_.place(tables_, packet_);
    tables_.light(tables_, blocked_, packet_);
  }
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if ((lanes >> i & 1u) != 0)
      colours[i] = {packet_.colour[0][i], packet_.colour[1][i], packet_.colour[2][i]};
    else if (hits[i].found())
      colours[i] = tracer_.trace_known(rays[i], hits[i]).colour;
    else
      colours[i] = inputs_.background;
  }
}

bool PacketShader::put_lane(std::size_t lane, const Ray<float>& ray, const Hit<float>& hit) {
  const TracedGeometry<float>& geometry = *inputs_.geometry;
  const Primitive primitive = primitive_of(geometry, hit.primitive);
  if (!is_float_triangle(primitive) || tables_.plain[primitive.material] == 0) return false;
  const bool shared = shares_meshes(geometry);
  const TracedTriangle<float>& triangle = triangle_of(geometry, primitive, own_triangles_[lane]);
  const bool smooth = triangle.attributes >= 0 && inputs_.settings.normals == Normals::vertex &&
                      attributes_of(geometry, primitive, triangle, own_attributes_[lane]).has_normals;
  const auto own = static_cast<std::int32_t>(lane);
  packet_.triangle[lane] = shared ? own : static_cast<std::int32_t>(primitive.shape);
  packet_.attributes[lane] = !smooth ? -1 : shared ? own : triangle.attributes;
  packet_.material[lane] = static_cast<std::int32_t>(primitive.material);
  packet_.sense[lane] = primitive.mirrored ? -1.0f : 1.0f;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    packet_.weights[k][lane] = hit.weights[k];
    packet_.to_eye[k][lane] = -ray.direction[axis];
  }
  return true;
}

void PacketShader::find_shadows(unsigned lanes, std::span<const Ray<float>> rays, std::span<const Hit<float>> hits) {
  std::fill(blocked_.begin(), blocked_.end(), 0u);
  for (std::size_t lane = 0; lane < hits.size(); ++lane) {
    if ((lanes >> lane & 1u) == 0) continue;
    const SurfacePoint<float> surface = surface_of(rays[lane], hits[lane], inputs_);
    for (int axis = 0; axis < 3; ++axis) {
      packet_.point[static_cast<std::size_t>(axis)][lane] = surface.point[axis];
      packet_.normal[static_cast<std::size_t>(axis)][lane] = surface.shading_normal[axis];
    }
    find_shadows_of(lane, rays[lane], surface);
  }
}

void PacketShader::find_shadows_of(std::size_t lane, const Ray<float>& ray, const SurfacePoint<float>& surface) {
  const LitPoint<float> point{surface.point, surface.shading_normal, -ray.direction};
  const ShadingMaterial<float>& material = inputs_.materials[surface.material];
  const IlluminationOptions options = illumination_options(inputs_.settings);
  const bool useful_only = inputs_.settings.shadow_rays == ShadowRays::useful;
  for (std::size_t k = 0; k < tables_.lights.size(); ++k) {
    const ShadingLight<float>& light = tables_.lights[k];
    if (light.kind == LightKind::ambient) continue;
    const bool is_point = light.kind == LightKind::point;
    const Vec3f to_light = is_point ? light.vector - surface.point : light.vector;
    const float t_max = is_point ? 1.0f : std::numeric_limits<float>::infinity();
    if (useful_only && !adds_light(point, material, to_light, options)) continue;
    if (tracer_.find_blocker(surface, static_cast<int>(k), to_light, t_max)) blocked_[k] |= 1u << lane;
  }
}

}  // namespace ps
