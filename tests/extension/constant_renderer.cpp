#include "constant_renderer.h"

#include "frame/display_frame.h"
#include "frame/empty_frame.h"
#include "image/display.h"
#include "options/option.h"

namespace ps::test {
namespace {

Vec3d half_of(const Scene& scene) { return scene.background * 0.5; }

Frame render_constant(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
                      Prepared&, Progress&) {
  Frame frame = empty_frame<float>(view, request);
  for (Vec3f& colour : frame.colour.pixels()) colour = Vec3f(half_of(scene));
  for (PixelId& id : frame.ids.pixels()) id = {};
  frame.counters[Counter::pixels_written] += frame.colour.pixels().size();
  finish_tile(request, settings, frame, {0, 0, view.width, view.height});
  return frame;
}

PixelStory inspect_constant(const Scene& scene, const View&, const Settings& settings, Vec2i pixel, Prepared&,
                            Progress&) {
  PixelStory story;
  story.pixel = pixel;
  story.renderer = settings.renderer;
  story.linear = half_of(scene);
  const Rgb8 display = display_pixel(Vec3d(Vec3f(story.linear)), display_transform(settings));
  story.display = {display.r, display.g, display.b};
  story.events.push_back({-1, EventData(PixelEvent{story.linear, story.display})});
  story.counters[Counter::pixels_written] = 1;
  return story;
}

std::optional<bool> uses(const Option& option, const Settings&, const SceneTraits&) {
  if (option.effect == OptionEffect::picture && option.key != "renderer") return false;
  return {};
}

}  // namespace

AddedRenderer constant_renderer() {
  return {.kind = {.key = "constant",
                   .label = "constant colour",
                   .help = "Shows the background in half its brightness.",
                   .way = PictureWay::fragments,
                   .reads = uses,
                   .unread = "one colour needs no such thing"},
          .row = {.render = render_constant,
                  .inspect = inspect_constant,
                  .counts = {Counter::pixels_written},
                  .fast_path =
                      [](const Settings&, const SceneTraits&, Channel) {
                        return FastPath{Machinery::clear, SurfaceShading::single, "there is nothing to hurry"};
                      },
                  .left_out =
                      [](const SceneTraits&, const Settings&) {
                        return std::vector<LeftOut>{{LeftOutKind::objects,
                                                     {BriefVerb::leaves_out, "everything"},
                                                     "A constant colour leaves out everything but the background.",
                                                     "Nothing but the background.",
                                                     {}}};
                      },
                  .shows_objects = [](const SceneTraits&, const Settings&) { return false; },
                  .subject = [](const SceneTraits&, const Settings&) { return std::string("the constant renderer"); }}};
}

}  // namespace ps::test
