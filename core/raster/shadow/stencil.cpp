#include "raster/shadow/stencil.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "base/available_memory.h"
#include "raster/assembly/bins.h"
#include "raster/base/fragment.h"
#include "raster/setup/draw_stage.h"
#include "raster/shadow/shadow_volume.h"

namespace ps::raster {
namespace {

constexpr int tile_size = 64;

using Geometry64 = ScreenGeometry<double>;

/// Settings that only find out what covers which pixel, and how far away. The far limit holds for pixels and cuts
/// no triangle: a volume's lit face goes on behind it, and would no longer lie exactly on a triangle that ends there.
Settings depth_settings(const Settings& settings) {
  Settings plain = settings;
  plain.lighting = false;
  plain.textures = false;  // but `shadows` stays: volumes end in the very triangles of the picture
  plain.environment = Environment::none;
  plain.draw = Draw::filled;
  plain.multisampling = 1;
  plain.coverage = Coverage::edge_function;
  plain.edge_arithmetic = EdgeArithmetic::fixed;
  plain.far = Settings().far;
  return plain;
}

/// Calls covered(triangle, fragment) for each covered sample in `rect`.
template <class Covered>
void scan(const RasterInputs<double>& inputs, const ScreenTriangle<double>& triangle, const TileRect& rect,
          Covered&& covered) {
  const TileRect box{std::max(triangle.box.x0, rect.x0), std::max(triangle.box.y0, rect.y0),
                     std::min(triangle.box.x1, rect.x1), std::min(triangle.box.y1, rect.y1)};
  if (box.x0 >= box.x1 || box.y0 >= box.y1) return;
  const auto edges = make_edges(triangle.corners, inputs.grid);
  PS_ASSERT(edges.has_value(), "triangles without area are left out by the assembly");
  TriangleSetup<double> setup;
  setup.triangle = &triangle;
  setup.edges = *edges;
  setup.inverse_area = 1.0 / static_cast<double>(edges->area);
  for (int row = box.y0; row < box.y1; ++row) {
    for (int column = box.x0; column < box.x1; ++column) {
      const auto values = setup.edges.at(column, row);
      if (setup.edges.inside(values)) covered(make_fragment(inputs, setup, column, row, values));
    }
  }
}

/// The faces of all volumes of one light, as objects of inputs of their own.
RasterInputs<double> volume_inputs(const RasterInputs<double>& scene_inputs, const std::vector<ShadowVolume>& volumes) {
  RasterInputs<double> inputs = scene_inputs;
  inputs.settings.backface_culling = false;
  inputs.objects.clear();
  inputs.surfaces.clear();
  inputs.first_surface.clear();
  for (const ShadowVolume& volume : volumes) {
    inputs.first_surface.push_back(static_cast<std::uint32_t>(inputs.surfaces.size()));
    Surface<double> surface;
    surface.object = static_cast<int>(inputs.objects.size());
    surface.drawn = inputs.objects.size();
    inputs.surfaces.push_back(surface);
    DrawObject object;
    object.object = surface.object;
    object.mesh = volume.surface;
    object.bounds = bounding_sphere(*volume.surface);
    object.materials = {0};
    inputs.objects.push_back(std::move(object));
  }
  return inputs;
}

int wrapped(int count, int bits) { return count & ((1 << bits) - 1); }

/// What a face does to the count. `behind`: it is not before the surface.
int change_of(Shadows method, bool behind, bool enters) {
  switch (method) {
  case Shadows::stencil_depth_fail:
    return behind ? (enters ? -1 : 1) : 0;
  case Shadows::stencil_depth_pass:
    return behind ? 0 : (enters ? 1 : -1);
  case Shadows::traced:
  case Shadows::none:
  case Shadows::map:
    return 0;
  }
  return 0;
}

/// Whether a face of a volume does not lie before the surface. Where a lit triangle ends, the side of its volume
/// begins: right on that edge both are as far away as the surface, but for rounding, and must count as the lit triangle
/// does.
bool is_behind(double inverse_z, double surface) {
  constexpr double rounding = 1e-12;
  return !(inverse_z > surface * (1 + rounding));
}

/// A covered sample of a volume, for the story.
VolumeCrossing crossing_of(const ShadowVolume& volume, const ScreenTriangle<double>& triangle, double z, int change) {
  VolumeCrossing crossing{volume.object, !triangle.back_face, z, change};
  const auto index = static_cast<std::size_t>(triangle.triangle);
  if (index < volume.caps) {
    crossing.part = index % 2 == 0 ? VolumePart::lit_face : VolumePart::far_end;
    return crossing;
  }
  const SilhouetteEdge& edge = volume.silhouette[volume.edge_of_side[index - volume.caps]];
  crossing.edge_from = edge.from;
  crossing.edge_to = edge.to;
  return crossing;
}

/// 1 / z at the far limit: what is less lies beyond it.
double far_limit(const Settings& settings, const RasterInputs<double>& inputs) {
  const bool none = settings.clipping == Clipping::none || settings.far >= Settings().far;
  return none ? -std::numeric_limits<double>::infinity() : 1 / (settings.far * inputs.viewport.distance);
}

/// The faces of one light's volumes, ready to be drawn.
struct LightVolumes {
  RasterInputs<double> inputs;
  Geometry64 geometry;
  Bins bins;
};

}  // namespace

bool uses_stencil(const Settings& settings, const Scene& scene) {
  return keeps_stencil(settings) && settings.lighting && fills(settings.draw) && scene_traits(scene).casting_lights;
}

Stencil make_stencil(const Scene& scene, const View& view, const Settings& settings, const TileRect& rect,
                     StencilNotes notes, Prepared& prepared, const ParallelOptions& parallel, Progress& progress) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(rect.width()) * static_cast<std::uint64_t>(rect.height());
  require_memory(pixels * scene.lights->size() * sizeof(std::int32_t), available_memory(),
                 fmt::format("the stencil buffers of {} lights", scene.lights->size()),
                 "draw a smaller picture, or have fewer lights");
  Stencil stencil;
  stencil.rect = rect;
  const RasterInputs<double> inputs =
      make_raster_inputs<double>(scene, view, depth_settings(settings), Channel::none, prepared);
  const Geometry64 surfaces = make_geometry(inputs, {}, parallel, progress);
  const Bins bins = bin_primitives(inputs, surfaces, tile_size, parallel, progress);
  const double far = far_limit(settings, inputs);
  const std::vector<std::vector<ShadowVolume>> volumes = make_shadow_volumes(scene, inputs.objects, settings);
  std::vector<std::unique_ptr<LightVolumes>> lights;
  for (const auto& of_light : volumes) {
    stencil.counts.emplace_back();
    lights.emplace_back();
    if (of_light.empty()) continue;
    stencil.counts.back() = Image<std::int32_t>(rect.width(), rect.height(), 0);
    auto light = std::make_unique<LightVolumes>();
    light->inputs = volume_inputs(inputs, of_light);
    light->geometry = make_geometry(light->inputs, {}, parallel, progress);
    light->bins = bin_primitives(light->inputs, light->geometry, tile_size, parallel, progress);
    lights.back() = std::move(light);
    for (const ShadowVolume& volume : of_light) stencil.counters[Counter::silhouette_edges] += volume.silhouette.size();
  }
  const std::vector<TileRect> tiles = make_tiles(view.width, view.height, tile_size);
  std::vector<Counters> counters(tiles.size());
  std::vector<StencilEvent> events(volumes.size());
  parallel_for(static_cast<int>(tiles.size()), parallel, progress, [&](int index, int) {
    const auto tile = static_cast<std::size_t>(index);
    const TileRect part{std::max(tiles[tile].x0, rect.x0), std::max(tiles[tile].y0, rect.y0),
                        std::min(tiles[tile].x1, rect.x1), std::min(tiles[tile].y1, rect.y1)};
    if (part.x0 >= part.x1 || part.y0 >= part.y1) return;
    constexpr double nothing = -std::numeric_limits<double>::infinity();
    Image<double> depth(part.width(), part.height(), nothing);
    const auto each = [&](const Bins& list, const RasterInputs<double>& of, const Geometry64& geometry,
                          auto&& covered) {
      for (std::size_t p = 0; p < list.parts; ++p)
        for (const PrimitiveRef& ref : list.list(p, tile)) {
          const ScreenTriangle<double>& triangle = geometry.batches[ref.batch].triangles[ref.index];
          scan(of, triangle, part, [&](const Fragment<double>& f) { covered(triangle, f); });
        }
    };
    each(bins, inputs, surfaces, [&](const ScreenTriangle<double>&, const Fragment<double>& f) {
      if (f.inverse_z < far) return;
      double& stored = depth.at(f.column - part.x0, f.row - part.y0);
      stored = std::max(stored, f.inverse_z);
    });
    for (std::size_t i = 0; i < lights.size(); ++i) {
      if (!lights[i]) continue;
      const LightVolumes& light = *lights[i];
      Image<std::int32_t>& counts = stencil.counts[i];
      each(light.bins, light.inputs, light.geometry,
           [&](const ScreenTriangle<double>& triangle, const Fragment<double>& f) {
             const double surface = depth.at(f.column - part.x0, f.row - part.y0);
             if (surface == nothing || (!settings.volume_depth_clamp && f.inverse_z < far)) return;
             ++counters[tile][Counter::stencil_tests];
             const int change = change_of(settings.shadows, is_behind(f.inverse_z, surface), !triangle.back_face);
             if (change != 0) ++counters[tile][Counter::stencil_updates];
             counts.at(f.column - rect.x0, f.row - rect.y0) += change;
             if (notes == StencilNotes::none) return;
             const auto& volume = volumes[i][static_cast<std::size_t>(light.inputs.surfaces[triangle.surface].object)];
             events[i].surface_z = 1 / surface;
             events[i].crossings.push_back(crossing_of(volume, triangle, f.z, change));
           });
      for (int row = part.y0; row < part.y1; ++row)
        for (int column = part.x0; column < part.x1; ++column) {
          std::int32_t& count = counts.at(column - rect.x0, row - rect.y0);
          const std::int32_t sum = count;
          count = wrapped(count, settings.stencil_bits);
          if (notes == StencilNotes::none) continue;
          events[i].count = sum;
          events[i].stored = count;
        }
    }
  });
  for (const Counters& tile : counters) stencil.counters += tile;
  if (notes == StencilNotes::crossings)
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (!lights[i]) continue;
      events[i].light = static_cast<int>(i);
      for (const ShadowVolume& volume : volumes[i])
        events[i].silhouette_edges += static_cast<int>(volume.silhouette.size());
      std::stable_sort(events[i].crossings.begin(), events[i].crossings.end(),
                       [](const VolumeCrossing& a, const VolumeCrossing& b) { return a.z < b.z; });
      stencil.events.push_back(events[i]);
    }
  return stencil;
}

}  // namespace ps::raster
