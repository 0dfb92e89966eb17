#include <cmath>

#include "base/timer.h"
#include "raytrace/packet.h"
#include "raytrace/tracer.h"
#include "render/render.h"

namespace ps {
namespace {

constexpr int tile_size = 32;

template <class Element>
void give_size(Image<Element>& image, const View& view, const RenderRequest& request, Channel channel) {
  if (has(request.channels, channel)) image = Image<Element>(view.width, view.height);
}

template <class Real>
Frame empty_frame(const View& view, const RenderRequest& request) {
  Frame frame;
  frame.colour = Image<Vec3f>(view.width, view.height);
  if constexpr (std::is_same_v<Real, double>) frame.colour_double = Image<Vec3d>(view.width, view.height);
  give_size(frame.depth, view, request, Channel::depth);
  give_size(frame.normal, view, request, Channel::normal);
  give_size(frame.barycentric, view, request, Channel::barycentric);
  give_size(frame.uv, view, request, Channel::uv);
  give_size(frame.ids, view, request, Channel::ids);
  give_size(frame.facing, view, request, Channel::facing);
  give_size(frame.overdraw, view, request, Channel::overdraw);
  give_size(frame.tests, view, request, Channel::tests);
  give_size(frame.mip, view, request, Channel::mip);
  give_size(frame.shadow, view, request, Channel::shadow);
  return frame;
}

/// Does the primitive's own colour come from a texture?
template <class Real>
bool reads_texture(const TracedPixel<Real>& pixel, const TraceInputs<Real>& inputs) {
  const std::uint32_t material = pixel.surface.material;
  return inputs.settings.textures && pixel.surface.has_uv && inputs.materials[material].texture >= 0;
}

/// Stores the channels that were asked for, which are those that have a size.
template <class Real>
void store_channels(const TracedPixel<Real>& pixel, const TraceInputs<Real>& inputs, int x, int y, Frame& frame) {
  const bool hit = pixel.hit.found();
  const Surface<Real>& surface = pixel.surface;
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
}

template <class Real>
void render_tile(const TraceInputs<Real>& inputs, const TileRect& tile, Frame& frame, Counters& counters) {
  CountingRecorder recorder;
  const Tracer<Real, CountingRecorder> tracer(inputs, recorder);
  const auto tests = [&] {
    return recorder.counters[Counter::sphere_tests] + recorder.counters[Counter::triangle_tests] +
           recorder.counters[Counter::solid_tests];
  };
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const std::uint64_t tests_before = tests();
      const TracedPixel<Real> pixel = tracer.trace_pixel(x, y);
      const Vec3<Real>& colour = pixel.colour;
      frame.colour.at(x, y) = Vec3f(colour);
      if constexpr (std::is_same_v<Real, double>) frame.colour_double.at(x, y) = colour;
      if (std::isnan(colour.x) || std::isnan(colour.y) || std::isnan(colour.z)) recorder.count(Counter::nan_pixels);
      store_channels(pixel, inputs, x, y, frame);
      if (!frame.tests.empty()) frame.tests.at(x, y) = static_cast<std::uint32_t>(tests() - tests_before);
    }
  }
  recorder.count(Counter::pixels_written,
                 static_cast<std::uint64_t>(tile.width()) * static_cast<std::uint64_t>(tile.height()));
  counters = recorder.counters;
}

/// Traces tiles the fast way where that is possible, else the clear way.
template <class Real>
class TileTracer {
 public:
  TileTracer(const TraceInputs<Real>& inputs, const RenderRequest& request) : inputs_(inputs) {
    if constexpr (std::is_same_v<Real, float>) {
      packets_ = packet_function(inputs.settings.simd);
      if (packets_) scene_ = packet_scene(inputs, request);
    }
  }
  void trace(const TileRect& tile, Frame& frame, Counters& counters) const {
    if (scene_)
      packets_(*scene_, tile, frame, counters);
    else
      render_tile(inputs_, tile, frame, counters);
  }

 private:
  const TraceInputs<Real>& inputs_;
  TracePackets packets_ = nullptr;
  std::optional<PacketScene> scene_;
};

template <class Real>
Frame render_in(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                Prepared& prepared, Progress& progress) {
  const Timer preparing;
  TraceInputs<Real> inputs = make_trace_inputs<Real>(scene, view, settings, prepared);
  if (has(request.channels, Channel::tests)) inputs.wide.reset();  // a picture of the tests that inspection lists
  Frame frame = empty_frame<Real>(view, request);
  frame.times.push_back({"prepare", preparing.milliseconds()});

  const Timer tracing;
  const std::vector<TileRect> tiles = make_tiles(view.width, view.height, tile_size);
  std::vector<Counters> counters(tiles.size());
  const TileTracer<Real> tracer(inputs, request);
  parallel_for(static_cast<int>(tiles.size()), {settings.threads, request.priority}, progress, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    tracer.trace(tiles[i], frame, counters[i]);
    if (request.on_tile) request.on_tile(frame, tiles[i]);
  });
  for (const Counters& tile : counters) frame.counters += tile;
  frame.counters[Counter::triangles_degenerate] += inputs.geometry->degenerate_triangles;
  frame.times.push_back({"trace", tracing.milliseconds()});
  return frame;
}

}  // namespace

Frame render_traced(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                    Prepared& prepared, Progress& progress) {
  switch (settings.precision) {
  case Precision::float32:
    return render_in<float>(scene, view, settings, request, prepared, progress);
  case Precision::float64:
    return render_in<double>(scene, view, settings, request, prepared, progress);
  }
  return {};
}

}  // namespace ps
