#include "frame/display_frame.h"
#include "raster/assembly/bins.h"
#include "raster/maps.h"
#include "raster/renderer.h"
#include "raster/replay/fragment_walk.h"
#include "record/field_inputs.h"
#include "record/field_recorder.h"

namespace ps {
namespace {

using namespace raster;

/// Draws the primitives of a tile by the clear path.
template <class Real>
struct FieldSink : ClearSink<Real, FieldRecorder> {
  const Bins& bins;
  std::size_t tile;
  void step(const DrawStep& step, std::size_t) {
    for (std::size_t part = 0; part < bins.parts; ++part) this->draw(bins.list(part, tile), step);
  }
};

template <class Real>
void field_in(const FieldInputs& asked, Image<float>& values, Prepared& prepared, Progress& progress) {
  const View& view = asked.view;
  RasterInputs<Real> inputs = make_raster_inputs<Real>(asked.scene, view, asked.settings, Channel::none, prepared);
  add_maps(inputs, asked.scene, view, {0, 0, view.width, view.height}, StencilNotes::none, prepared, asked.parallel,
           progress);
  const ScreenGeometry<Real> geometry = make_geometry(inputs, {}, asked.parallel, progress);
  const Bins bins = bin_primitives(inputs, geometry, clear_tile_size, asked.parallel, progress);
  Frame frame = make_frame(asked.scene, view, asked.settings, Channel::none);
  Image<PixelId> owners(view.width, view.height);
  const std::vector<TileRect> tiles = make_tiles(view.width, view.height, clear_tile_size);
  parallel_for(static_cast<int>(tiles.size()), asked.parallel, progress, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    if (is_empty(common_part(tiles[i], asked.region))) return;
    FieldRecorder recorder(asked.query, asked.space, values, owners);
    Target<Real> target(frame, tiles[i], asked.settings, Channel::none);
    walk_fragments(inputs, target, FieldSink<Real>{{inputs, geometry, target, recorder}, bins, i});
  });
}

}  // namespace

void find_field_of_fragments(const FieldInputs& asked, Image<float>& values, Prepared& prepared, Progress& progress) {
  switch (asked.settings.precision) {
  case Precision::float32:
    return field_in<float>(asked, values, prepared, progress);
  case Precision::float64:
    return field_in<double>(asked, values, prepared, progress);
  }
}

}  // namespace ps
