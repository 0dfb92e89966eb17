#pragma once
#include <cmath>
#include <limits>

#include "frame/empty_frame.h"
#include "math/has_nan.h"
#include "raytrace/clear/tracer.h"

namespace ps {

/// Does the primitive's local colour come from a texture?
template <class Real>
bool reads_texture(const TracedPixel<Real>& pixel, const TraceInputs<Real>& inputs) {
  const std::uint32_t material = pixel.surface.material;
  return inputs.settings.textures && pixel.surface.has_uv && inputs.materials[material].texture >= 0;
}

/// Stores the channels that were asked for, which are those that have a size.
template <class Real>
void store_channels(const TracedPixel<Real>& pixel, const TraceInputs<Real>& inputs, int x, int y, Frame& frame) {
  const bool hit = pixel.hit.found();
  const SurfacePoint<Real>& surface = pixel.surface;
  if (!frame.depth.empty())
    frame.depth.at(x, y) =
        hit ? static_cast<float>(pixel.hit.t * inputs.viewport.distance) : std::numeric_limits<float>::infinity();
  if (!frame.normal.empty()) frame.normal.at(x, y) = hit ? Vec3f(normalised(surface.shading_normal)) : Vec3f(0);
  if (!frame.barycentric.empty()) {
    const auto& w = pixel.hit.weights;
    frame.barycentric.at(x, y) = Vec3f(Vec3<Real>(w[0], w[1], w[2]));
  }
  if (!frame.uv.empty()) frame.uv.at(x, y) = Vec2f(surface.uv);
  if (!frame.ids.empty()) frame.ids.at(x, y) = hit ? id_of(*inputs.geometry, pixel.hit) : PixelId{};
  if (!frame.facing.empty())
    frame.facing.at(x, y) =
        hit ? static_cast<float>(-dot(normalised(pixel.ray.direction), surface.geometric_normal)) : 0.0f;
  if (!frame.overdraw.empty()) frame.overdraw.at(x, y) = hit ? 1u : 0u;
  if (!frame.mip.empty()) frame.mip.at(x, y) = hit && reads_texture(pixel, inputs) ? 0.0f : -1.0f;
  if (!frame.shadow.empty()) frame.shadow.at(x, y) = pixel.shadow_mask;
  if (!frame.direction.empty()) frame.direction.at(x, y) = Vec3f(normalised(pixel.ray.direction));
}

/// Stores a pixel with its channels and returns whether it has a NaN.
template <class Real>
bool store_pixel(const TracedPixel<Real>& pixel, const TraceInputs<Real>& inputs, int x, int y, Frame& frame) {
  const Vec3<Real>& colour = pixel.colour;
  frame.colour.at(x, y) = Vec3f(colour);
  if constexpr (std::is_same_v<Real, double>) frame.colour_double.at(x, y) = colour;
  store_channels(pixel, inputs, x, y, frame);
  return has_nan(colour);
}

/// The same for a pixel of which colour, depth and id are asked for at most.
inline bool store_hit(const Vec3f& colour, const Hit<float>& hit, const TraceInputs<float>& inputs, int x, int y,
                      Frame& frame) {
  frame.colour.at(x, y) = colour;
  if (!frame.depth.empty())
    frame.depth.at(x, y) = hit.found() ? hit.t * inputs.viewport.distance : std::numeric_limits<float>::infinity();
  if (!frame.ids.empty()) frame.ids.at(x, y) = hit.found() ? id_of(*inputs.geometry, hit) : PixelId{};
  return has_nan(colour);
}

/// How many pixels a rectangle holds, as counters take it.
inline std::uint64_t pixel_count(const TileRect& rect) {
  return static_cast<std::uint64_t>(rect.width()) * static_cast<std::uint64_t>(rect.height());
}

/// Tests of a ray against a primitive so far.
inline std::uint64_t primitive_tests(const Counters& counters) {
  return counters[Counter::sphere_tests] + counters[Counter::triangle_tests] + counters[Counter::solid_tests];
}

}  // namespace ps
