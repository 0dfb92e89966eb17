#include "agreement/hardware/agreement_matrix.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "frame/display_frame.h"
#include "hardware/gl_thread.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "options/scene_settings.h"
#include "scene/load.h"

namespace ps::test {

StageSplit measure(const MatrixRow& row, Renderer hardware, const std::string& snapping) {
  StageRequest request;
  request.scene = load_scene(row.scene);
  request.view = {request.scene.camera, row.side, row.side};
  Settings settings = settings_for(request.scene);
  for (const char* plain : {"shadows=none", "reflection-depth=0", "environment=none"})
    parse_assignment(plain, settings);
  for (const std::string& assignment : row.assignments) parse_assignment(assignment, settings);
  parse_assignment("vertex-snapping=" + snapping, settings);
  settings.subpixel_bits = hardware::availability().driver->subpixel_bits;
  request.ours = request.other = settings;
  request.ours.renderer = renderer_for(PictureWay::fragments);
  request.other.renderer = hardware;
  StudyControl control;
  return split_by_stage(request, control);
}

RayDifference against_rays(const RayRow& row, Renderer renderer) {
  const Scene scene = load_scene(row.scene);
  Settings settings = settings_for(scene);
  for (const std::string& assignment : row.assignments) parse_assignment(assignment, settings);
  const View view{scene.camera, 300, 300};
  RenderRequest request;
  request.channels = Channel::ids;
  Prepared prepared;
  Progress progress;
  settings.renderer = renderer_for(PictureWay::rays);
  const Frame rays = render(scene, view, settings, request, prepared, progress);
  const Image<Rgb8> a = display_frame(rays, settings);
  settings.renderer = renderer;
  const Frame drawn = render(scene, view, settings, request, prepared, progress);
  const Image<Rgb8> b = display_frame(drawn, settings);
  RayDifference difference;
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgb8 p = a.pixels()[i], q = b.pixels()[i];
    int largest = 0;
    for (const int d : {p.r - q.r, p.g - q.g, p.b - q.b}) {
      largest = std::max(largest, std::abs(d));
      squares += static_cast<double>(d * d);
    }
    difference.ids += rays.ids.pixels()[i] != drawn.ids.pixels()[i];
    difference.colours += largest > 1;
  }
  difference.rms = std::sqrt(squares / (3.0 * static_cast<double>(a.pixels().size())));
  return difference;
}

}  // namespace ps::test
