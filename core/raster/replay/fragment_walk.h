#pragma once
#include <span>
#include <vector>

#include "raster/clear/canvas_items.h"
#include "raster/clear/draw_primitives.h"

namespace ps::raster {

/// Goes over all that a target shows in the one order in which it is drawn: the primitives, as often as the settings
/// ask for (setup/draw_stage.h), deferred shading, the means of the samples, the shapes on the canvas. Pictures,
/// stories of a pixel, slow motion and the microscope differ in their sinks:
///   step(step, number)  draws primitives; `number` counts the walks over them from 0
///   winners()           shades what deferred shading kept
///   canvas()            draws the shapes on the canvas
template <class Real, class Sink>
void walk_fragments(const RasterInputs<Real>& inputs, Target<Real>& target, Sink&& sink) {
  struct MeansAtEnd {  // also of a target that slow motion leaves within a step
    Target<Real>& target;
    ~MeansAtEnd() { target.resolve(); }
  };
  {
    const MeansAtEnd means{target};
    const std::vector<DrawStep> steps = draw_steps(inputs.settings, inputs.lights.size());
    for (std::size_t i = 0; i < steps.size(); ++i) sink.step(steps[i], i);
    if (defers_shading(inputs.settings)) sink.winners();
  }
  sink.canvas();
}

/// A sink that draws by the clear path. It lacks step(): the sinks made of it say which primitives are drawn.
template <class Real, class Recorder>
struct ClearSink {
  const RasterInputs<Real>& inputs;
  const ScreenGeometry<Real>& geometry;
  Target<Real>& target;
  Recorder& recorder;
  void draw(std::span<const PrimitiveRef> primitives, const DrawStep& step) {
    draw_primitives(inputs, geometry, primitives, step, target, recorder);
  }
  void winners() { shade_winners(inputs, geometry, target, recorder); }
  void canvas() { draw_canvas_items(inputs, target, recorder); }
};

}  // namespace ps::raster
