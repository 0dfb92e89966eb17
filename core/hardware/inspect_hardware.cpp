#include "frame/display_frame.h"
#include "hardware/picture_drawer.h"
#include "hardware/render_hardware.h"
#include "image/display.h"

namespace ps::hardware {

// The colour is that of the picture itself, drawn again where the pixel lies. What a driver does on the way to it, such
// as its edge values, cannot be asked for and is absent.
PixelStory inspect_hardware(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                            Prepared& prepared, Progress& progress) {
  RenderRequest request;
  request.region = TileRect{pixel.x, pixel.y, pixel.x + 1, pixel.y + 1};
  const Frame frame = render_hardware(scene, view, settings, request, prepared, progress);
  PixelStory story;
  story.pixel = pixel;
  story.renderer = settings.renderer;
  story.linear = Vec3d(frame.colour.at(pixel.x, pixel.y));
  const Rgb8 levels = display_pixel(story.linear, display_transform(settings));
  story.display = {levels.r, levels.g, levels.b};
  story.counters = frame.counters;
  story.events.push_back({-1, EventData(PixelEvent{story.linear, story.display})});
  return story;
}

}  // namespace ps::hardware
