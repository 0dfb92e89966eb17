#include "raster/fast/fast_frame.h"

#include <algorithm>
#include <memory>

#include "base/timer.h"
#include "raster/assembly/vertex_stage.h"
#include "raster/fast/assembly.h"
#include "raster/fast/resolve.h"
#include "raster/fast/vertices.h"

namespace ps::raster {
namespace {

/// What one worker keeps from tile to tile.
struct Worker {
  Worker(const RasterInputs<float>& inputs, const std::vector<VertexBuffer<float>>& vertices,
         const std::vector<FastSurface>& surfaces)
      : rows(inputs, vertices, surfaces) {}
  TileFragments tile;
  AttributeRows rows;
};

}  // namespace

void draw_fast_frame(const RasterInputs<float>& inputs, const PackedTextures& textures, const RenderRequest& request,
                     Frame& frame, Progress& progress) {
  const ParallelOptions parallel{inputs.settings.threads, request.priority};
  Timer timer;
  const auto done = [&](const char* stage) {
    frame.times.push_back({stage, timer.milliseconds()});
    timer = Timer();
  };
  const std::vector<bool> culled = cull_objects(inputs);
  frame.counters[Counter::objects_culled] += static_cast<std::uint64_t>(std::count(culled.begin(), culled.end(), true));
  const std::vector<VertexBuffer<float>> vertices = run_fast_vertices(inputs, culled, parallel, progress);
  done("vertices");
  const std::vector<FastPart> parts = assemble_fast(inputs, vertices, culled, parallel, progress);
  for (const FastPart& part : parts) frame.counters += part.counters;
  done("triangles, sorted into tiles");

  const std::vector<FastSurface> surfaces = fast_surfaces(inputs, textures);
  const std::vector<TileRect> tiles = make_tiles(frame.width(), frame.height(), fast_tile);
  std::vector<Counters> counters(tiles.size());
  std::vector<std::unique_ptr<Worker>> workers(static_cast<std::size_t>(resolve_threads(parallel)));
  const CoverTile cover = cover_kernel(inputs.settings.simd);
  const ResolveKernels kernels = resolve_kernels(inputs.settings.simd);
  const TileOutput output = tile_output(inputs.settings, request, frame);
  const bool keep_replaced = needs_replaced(inputs, surfaces);
  parallel_for(static_cast<int>(tiles.size()), parallel, progress, [&](int index, int number) {
    const auto i = static_cast<std::size_t>(index);
    std::size_t entries = 0;
    for (const FastPart& part : parts) entries += part.list(i).size();
    if (entries == 0) {
      resolve_empty_tile(inputs, kernels, tiles[i], output, frame, counters[i]);
    } else {
      std::unique_ptr<Worker>& worker = workers[static_cast<std::size_t>(number)];
      if (!worker) worker = std::make_unique<Worker>(inputs, vertices, surfaces);
      TileFragments& tile = worker->tile;
      tile.keep_replaced = keep_replaced;
      tile.start(entries, surfaces.size());
      for (const FastPart& part : parts)
        if (!part.list(i).empty()) cover(tiles[i], part, part.list(i), tile);
      resolve_tile(inputs, kernels, tile, tiles[i], output, worker->rows, frame, counters[i]);
    }
    if (request.on_tile) request.on_tile(frame, tiles[i]);
  });
  for (const Counters& tile : counters) frame.counters += tile;
  done("fragments");
}

}  // namespace ps::raster
