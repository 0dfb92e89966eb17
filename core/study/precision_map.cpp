#include "study/precision_map.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "image/heat_colour.h"
#include "raster/depth_format.h"
#include "raytrace/tracer.h"
#include "render/display_frame.h"

namespace ps {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

PrecisionFault fault_of(const PixelId& id, const PixelId& truth, Rgb8 level, Rgb8 true_level) {
  if (id.object >= 0 && truth.object < 0) return PrecisionFault::false_hit;
  if (id.object < 0 && truth.object >= 0) return PrecisionFault::missed_hit;
  if (!(id == truth)) return PrecisionFault::wrong_winner;
  const int apart =
      std::max({std::abs(level.r - true_level.r), std::abs(level.g - true_level.g), std::abs(level.b - true_level.b)});
  return apart > 1 ? PrecisionFault::shading : PrecisionFault::none;
}

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
  GapFinder(const Scene& scene, const View& view, Settings settings, Prepared& prepared)
      : code_(raster::make_depth_code(settings, view.camera.projection_plane_d)), culls_(settings.backface_culling),
        inputs_(make_trace_inputs<double>(scene, view, as_rays(settings), prepared)) {}

  float gap_at(int column, int row) const {
    Silent nobody;
    const Tracer<double, Silent> tracer(inputs_, nobody);
    const Intersector<double, Silent> intersector(inputs_, nobody);
    Ray<double> ray = tracer.eye_ray(column, row, inputs_.viewport.sample);
    const std::optional<Hit<double>> first = next(intersector, ray);
    if (!first) return infinity;
    const PrimitiveKind kind = primitive_of(*inputs_.geometry, first->primitive).kind;
    if (kind == PrimitiveKind::triangle) {  // another one may lie in the very same place
      ray.start = first->primitive;
      ray.t_min = first->t * (1 - 1e-12);
    } else {
      ray.t_min = first->t;
    }
    const std::optional<Hit<double>> second = next(intersector, ray);
    if (!second) return infinity;
    return static_cast<float>(units_between(code_, depth(ray, first->t), depth(ray, second->t)));
  }

 private:
  static Settings as_rays(Settings settings) {
    settings.renderer = Renderer::ray_tracer;
    settings.precision = Precision::float64;
    settings.accelerator = Accelerator::bvh;
    settings.slab_test = SlabTest::robust;
    settings.triangle_test = TriangleTest::watertight;
    settings.sphere_test = SphereTest::robust;
    return settings;
  }

  /// The next surface along the ray that is drawn at all.
  std::optional<Hit<double>> next(const Intersector<double, Silent>& intersector, Ray<double>& ray) const {
    constexpr int most_culled = 16;
    for (int i = 0; i < most_culled; ++i) {
      const Hit<double> hit = intersector.nearest(ray);
      if (!hit.found()) return {};
      const Surface<double> surface = surface_of(ray, hit, inputs_);
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

std::string_view precision_fault_label(PrecisionFault fault) {
  switch (fault) {
  case PrecisionFault::none:
    return "as in double";
  case PrecisionFault::false_hit:
    return "false hit";
  case PrecisionFault::missed_hit:
    return "missed hit";
  case PrecisionFault::wrong_winner:
    return "wrong winner";
  case PrecisionFault::shading:
    return "shading differs";
  }
  return {};
}

Rgb8 precision_fault_colour(PrecisionFault fault) {
  switch (fault) {  // Okabe and Ito's colours, told apart with any colour vision
  case PrecisionFault::none:
    return {40, 40, 44};
  case PrecisionFault::false_hit:
    return {213, 94, 0};
  case PrecisionFault::missed_hit:
    return {86, 180, 233};
  case PrecisionFault::wrong_winner:
    return {240, 228, 66};
  case PrecisionFault::shading:
    return {204, 121, 167};
  }
  return {};
}

PrecisionMap precision_map(const Scene& scene, const View& view, const Settings& settings, Prepared& prepared,
                           Progress& progress, WorkerPriority priority) {
  RenderRequest request;
  request.channels = Channel::ids;
  request.priority = priority;
  Settings exact = settings;
  exact.precision = Precision::float64;
  exact.depth_format = DepthFormat::plain;
  const Frame frame = render(scene, view, settings, request, prepared, progress);
  const Frame truth = render(scene, view, exact, request, prepared, progress);
  const Image<Rgb8> levels = display_frame(frame, settings), true_levels = display_frame(truth, exact);
  PrecisionMap map;
  map.faults = Image<PrecisionFault>(view.width, view.height, PrecisionFault::none);
  for (std::size_t i = 0; i < map.faults.pixels().size(); ++i) {
    const PrecisionFault fault =
        fault_of(frame.ids.pixels()[i], truth.ids.pixels()[i], levels.pixels()[i], true_levels.pixels()[i]);
    map.faults.pixels()[i] = fault;
    ++map.counts[static_cast<std::size_t>(fault)];
  }
  map.gap = Image<float>(view.width, view.height, infinity);
  const GapFinder finder(scene, view, settings, prepared);
  parallel_for(view.height, {settings.threads, priority}, progress, [&](int row, int) {
    for (int column = 0; column < view.width; ++column) map.gap.at(column, row) = finder.gap_at(column, row);
  });
  return map;
}

Image<Rgb8> fault_picture(const PrecisionMap& map) {
  Image<Rgb8> picture(map.faults.width(), map.faults.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i)
    picture.pixels()[i] = precision_fault_colour(map.faults.pixels()[i]);
  return picture;
}

Image<Rgb8> gap_picture(const PrecisionMap& map) {
  Image<Rgb8> picture(map.gap.width(), map.gap.height());
  for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
    const float gap = map.gap.pixels()[i];
    Rgb8& p = picture.pixels()[i];
    if (gap == infinity)
      p = {255, 255, 255};
    else if (gap < 1)
      p = {220, 30, 30};
    else
      p = heat_colour(std::log2(static_cast<double>(gap)) / 24);
  }
  return picture;
}

}  // namespace ps
