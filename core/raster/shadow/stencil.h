#pragma once
#include <memory>
#include <vector>

#include "base/counters.h"
#include "base/parallel.h"
#include "frame/prepared.h"
#include "frame/view.h"
#include "image/image.h"
#include "options/settings.h"
#include "record/shadow_events.h"
#include "scene/scene.h"

namespace ps::raster {

/// The stencil buffers of a part of a picture, one for each light (CGFS ch. 15).
struct Stencil {
  TileRect rect;                            ///< pixels that they hold
  std::vector<Image<std::int32_t>> counts;  ///< as stored, after wrapping; an empty one for light without volumes
  std::vector<StencilEvent> events;         ///< one for each casting light; only while a pixel is inspected
  Counters counters;

  /// 0, which is lit, wherever no object casts a shadow of this light.
  std::int32_t at(int light, int column, int row) const {
    const Image<std::int32_t>& of_light = counts[static_cast<std::size_t>(light)];
    return of_light.empty() ? 0 : of_light.at(column - rect.x0, row - rect.y0);
  }
};

/// Is the option on, and can it act?
bool uses_stencil(const Settings& settings, const Scene& scene);

enum class StencilNotes { none, crossings };

/// Draws the depth of the scene, and then for each light the faces of all shadow volumes, which change nothing but the
/// count of the pixels that they cover. Depth-fail counts the faces behind the surface: +1 where the line of sight
/// leaves a volume, -1 where it enters one. Depth-pass counts those before it, with the signs the other way round. The
/// buffer holds `stencil-bits` bits, and wraps. All in double precision: a lit face of a volume must lie exactly on
/// the triangle that it was made from.
Stencil make_stencil(const Scene& scene, const View& view, const Settings& settings, const TileRect& rect,
                     StencilNotes notes, Prepared& prepared, const ParallelOptions& parallel, Progress& progress);

}  // namespace ps::raster
