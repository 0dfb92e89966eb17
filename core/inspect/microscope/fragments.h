#pragma once
#include <memory>

#include "base/progress.h"
#include "inspect/microscope/microscope.h"

namespace ps {

class Microscope::Fragments {
 public:
  virtual ~Fragments() = default;
  virtual MicroReading read(const Vec2d& point) const = 0;
  virtual std::vector<MicroSample> samples() const = 0;
  /// Whether a filled shape of the canvas comes near the pixel.
  virtual bool near_canvas() const = 0;
};

/// Takes the triangles near the pixel from the rasterizer's own vertex stage and assembly. `scene` must live as long.
std::unique_ptr<Microscope::Fragments> make_micro_fragments(const Scene& scene, const View& view,
                                                            const Settings& settings, Vec2i pixel, Prepared& prepared,
                                                            Progress& progress);

}  // namespace ps
