#include <fmt/format.h>

#include "frame/display_frame.h"
#include "hardware/gl_thread.h"
#include "hardware/render_hardware.h"
#include "image/display.h"
#include "record/value_text.h"

namespace ps::hardware {
namespace {

std::string name_of(const Scene& scene, const PixelId& id, bool numbered) {
  const std::string& name = scene.geometry->objects[static_cast<std::size_t>(id.object)].name;
  const std::string object = name.empty() ? fmt::format("object {}", id.object) : name;
  return numbered ? fmt::format("triangle {} of {}", id.triangle, object) : object;
}

/// What the driver reports of the pixel: which triangle it shows, and where.
std::string verdict(const Scene& scene, const Frame& frame, Vec2i pixel) {
  const PixelId id = frame.ids.at(pixel.x, pixel.y);
  const std::string& driver = availability().driver->renderer;
  if (id.object < 0) return fmt::format("nothing is drawn here: background, as {} reports", driver);
  const bool numbered = frame.barycentric.at(pixel.x, pixel.y) != Vec3f(0);
  return fmt::format("{} is seen at z = {}, as {} reports; a driver does not report its steps",
                     name_of(scene, id, numbered), number_text(static_cast<double>(frame.depth.at(pixel.x, pixel.y))),
                     driver);
}

}  // namespace

// The picture is drawn again where the pixel lies. What a driver does on the way to it, such as its edge values, cannot
// be asked for and is absent.
PixelStory inspect_hardware(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel,
                            Prepared& prepared, Progress& progress) {
  RenderRequest request;
  request.channels = Channel::ids | Channel::depth | Channel::barycentric;
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
  story.verdict = verdict(scene, frame, pixel);
  story.ledger.push_back({0, "colour from the graphics driver", story.linear, 0});
  return story;
}

}  // namespace ps::hardware
