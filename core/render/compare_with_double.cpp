#include "frame/display_frame.h"
#include "image/difference.h"
#include "options/option.h"
#include "render/precision_channels.h"

namespace ps {
namespace {

PrecisionFault fault_of(const PixelId& id, const PixelId& truth, Rgb8 level, Rgb8 true_level) {
  if (id.object >= 0 && truth.object < 0) return PrecisionFault::false_hit;
  if (id.object < 0 && truth.object >= 0) return PrecisionFault::missed_hit;
  if (!(id == truth)) return PrecisionFault::wrong_winner;
  return largest_difference(level, true_level) > 1 ? PrecisionFault::shading : PrecisionFault::none;
}

}  // namespace

void compare_with_double(Frame& frame, const Scene& scene, const View& view, const Settings& settings,
                         const RenderRequest& request, Prepared& prepared, Progress& progress) {
  Settings exact = settings;
  exact.precision = Precision::float64;
  // A renderer that has no double is compared with core's own of its way.
  if (inactive_value_reason(*find_option("precision"), exact, SceneTraits{}))
    exact.renderer = renderer_for(picture_way(settings.renderer));
  exact.depth_format = DepthFormat::plain;
  RenderRequest again;
  again.channels = Channel::ids;
  again.priority = request.priority;
  again.region = request.region;
  const Frame truth = render(scene, view, exact, again, prepared, progress);
  const Image<Rgb8> levels = display_frame(frame, settings), true_levels = display_frame(truth, exact);
  frame.precision = Image<PrecisionFault>(view.width, view.height, PrecisionFault::none);
  for (std::size_t i = 0; i < frame.precision.pixels().size(); ++i)
    frame.precision.pixels()[i] =
        fault_of(frame.ids.pixels()[i], truth.ids.pixels()[i], levels.pixels()[i], true_levels.pixels()[i]);
}

}  // namespace ps
