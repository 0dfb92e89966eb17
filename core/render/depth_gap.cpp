#include <bit>
#include <cmath>
#include <limits>

#include "image/heat_colour.h"
#include "math/portable.h"
#include "options/renderer_kind.h"
#include "options/robust_rays.h"
#include "raster/setup/depth_format.h"
#include "raytrace/base/eye_ray.h"
#include "raytrace/clear/intersector.h"
#include "raytrace/clear/surface_point.h"
#include "render/precision_channels.h"

namespace ps {
namespace {

constexpr float no_second_surface = std::numeric_limits<float>::infinity();

/// Floats in the order of their values as whole numbers one apart.
std::int64_t place_of(float value) {
  const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(value));
  return bits < 0x80000000 ? bits : 0x80000000 - bits;
}

/// Units in the last place between two stored depth values.
double units_between(const raster::DepthCode& code, double z_first, double z_second) {
  const auto stored = [&](double z) {
    return code.encode(static_cast<float>(code.value == DepthValue::inverse_z ? 1 / z : z));
  };
  const float a = stored(z_first), b = stored(z_second);
  if (code.format == DepthFormat::unorm) return std::abs(static_cast<double>(a) - static_cast<double>(b));
  return static_cast<double>(std::abs(place_of(a) - place_of(b)));
}

/// Finds the second surface behind each pixel's first one with rays in double.
class GapFinder {
 public:
  GapFinder(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared)
      : code_(raster::make_depth_code(settings, view.camera.projection_plane_d)), culls_(settings.backface_culling),
        inputs_(make_trace_inputs<double>(scene, view, as_rays(settings), prepared)) {}

  float gap_at(int column, int row) const {
    Silent silent;
    const Intersector<double, Silent> intersector(inputs_, silent);
    Ray<double> ray = eye_ray(inputs_, column, row, inputs_.viewport.sample);
    const std::optional<Hit<double>> first = next(intersector, ray);
    if (!first) return no_second_surface;
    const PrimitiveKind kind = primitive_of(*inputs_.geometry, first->primitive).kind;
    if (kind == PrimitiveKind::triangle) {  // another one may lie in the very same place
      ray.start = first->primitive;
      ray.t_min = first->t * (1 - 1e-12);
    } else {
      ray.t_min = first->t;
    }
    const std::optional<Hit<double>> second = next(intersector, ray);
    if (!second) return no_second_surface;
    return static_cast<float>(units_between(code_, depth(ray, first->t), depth(ray, second->t)));
  }

 private:
  static Settings as_rays(const Settings& settings) {
    Settings rays = robust_rays(settings);
    rays.renderer = renderer_for(PictureWay::rays);
    return rays;
  }

  /// The next surface along the ray that is drawn at all.
  std::optional<Hit<double>> next(const Intersector<double, Silent>& intersector, Ray<double>& ray) const {
    constexpr int most_culled = 16;
    for (int i = 0; i < most_culled; ++i) {
      const Hit<double> hit = intersector.nearest(ray);
      if (!hit.found()) return {};
      const SurfacePoint<double> surface = surface_of(ray, hit, inputs_);
      const bool closed = primitive_of(*inputs_.geometry, hit.primitive).kind != PrimitiveKind::solid;
      if (!culls_ || !closed || !surface.back_face) return hit;
      ray.t_min = hit.t;
    }
    return {};
  }

  /// Depth along the camera's forward axis, in world units.
  double depth(const Ray<double>& ray, double t) const {
    const Vec3d& f = inputs_.forward;
    return dot(ray.origin + ray.direction * t - inputs_.eye, f) / std::sqrt(dot(f, f));
  }

  raster::DepthCode code_;
  bool culls_;
  TraceInputs<double> inputs_;
};

}  // namespace

void find_depth_gaps(Frame& frame, const Scene& scene, const View& view, const Settings& settings,
                     const RenderRequest& request, Prepared& prepared, Progress& progress) {
  frame.depth_gap = Image<float>(view.width, view.height, no_second_surface);
  const GapFinder finder(scene, view, settings, prepared);
  const TileRect wanted = request.region.value_or(TileRect{0, 0, view.width, view.height});
  parallel_for(wanted.height(), {settings.threads, request.priority}, progress, [&](int row, int) {
    for (int x = wanted.x0; x < wanted.x1; ++x)
      frame.depth_gap.at(x, wanted.y0 + row) = finder.gap_at(x, wanted.y0 + row);
  });
}

Rgb8 depth_gap_colour(float gap) {
  constexpr Rgb8 white{255, 255, 255}, red{220, 30, 30};
  if (gap == no_second_surface) return white;
  if (gap < 1) return red;
  return heat_colour(portable::log2(static_cast<double>(gap)) / portable::log2(most_depth_gap));
}

}  // namespace ps
