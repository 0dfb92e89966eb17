#include "render/render.h"

#include <limits>

#include "base/check.h"
#include "base/stop.h"
#include "frame/fast_kernels.h"
#include "frame/working_scene.h"
#include "image/image.h"
#include "record/field_inputs.h"
#include "record/story_to_world.h"
#include "render/left_out.h"
#include "render/precision_channels.h"
#include "render/renderer_table.h"
#include "render/story/finish_story.h"

namespace ps {
namespace {

/// Makes counters absent, and not 0, that the renderer cannot give, or not of this picture.
void take_counts(const RendererRow& row, Counters& counters) {
  CounterSet given;
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);
    PS_ASSERT(counters.values[i] == 0 || row.counts.contains(counter), "a renderer counts what its row declares");
    if (row.counts.contains(counter) && counters.given.contains(counter)) given.insert(counter);
  }
  counters.given = given;
}

void find_field(Frame& frame, const RendererRow& row, const WorkingScene& working, const RenderRequest& request,
                Prepared& prepared, Progress& progress) {
  const View& view = working.view();
  frame.field = Image<float>(view.width, view.height, std::numeric_limits<float>::quiet_NaN());
  frame.shown_field = request.field;
  if (!request.field || !no_field_reason(row.renderer, request.field->query).empty()) return;
  const Settings& settings = working.settings();
  const FieldInputs asked{working.scene(),
                          view,
                          settings,
                          working.space,
                          request.field->query,
                          request.region.value_or(TileRect{0, 0, view.width, view.height}),
                          {settings.threads, request.priority}};
  row.find_field(asked, frame.field, prepared, progress);
}

}  // namespace

std::string_view no_field_reason(Renderer renderer, const FieldQuery& query) {
  const RendererRow& row = renderer_row(renderer);
  if (!row.find_field) return "This renderer reports its steps for one pixel at a time, so it shows no number for all.";
  if (row.finds_lines == query.of_listing()) return {};
  return row.finds_lines ? "A listing shows values of its lines, such as 'listing-line 28: discriminant'."
                         : "Only a listing has lines; this renderer shows numbers of its own story.";
}

Frame render(const Scene& scene, const View& view, const Settings& settings, const RenderRequest& request,
             Prepared& prepared, Progress& progress) {
  require_image_size(view.width, view.height, "picture");
  const StopScope stop(&progress);
  RenderRequest plain = request;
  plain.channels = request.channels;
  for (const Channel own : {Channel::precision, Channel::depth_gap, Channel::field})
    plain.channels = without(plain.channels, own);
  const RendererRow& row = renderer_row(settings.renderer);
  const WorkingScene working(scene, view, settings, prepared);
  Frame frame = row.render(working.scene(), working.view(), working.settings(), plain, prepared, progress);
  working.to_world(frame);
  take_counts(row, frame.counters);
  if (has(request.channels, Channel::field)) find_field(frame, row, working, request, prepared, progress);
  if (has(request.channels, Channel::precision))
    compare_with_double(frame, scene, view, settings, request, prepared, progress);
  if (has(request.channels, Channel::depth_gap))
    find_depth_gaps(frame, scene, view, settings, request, prepared, progress);
  return frame;
}

Frame render(const Scene& scene, const View& view, const Settings& settings) {
  Prepared prepared;
  Progress progress;
  return render(scene, view, settings, {}, prepared, progress);
}

PixelStory inspect(const Scene& scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                   Progress& progress) {
  require_image_size(view.width, view.height, "picture");
  const StopScope stop(&progress);
  PS_ASSERT(pixel.x >= 0 && pixel.y >= 0 && pixel.x < view.width && pixel.y < view.height, "pixel outside the view");
  const RendererRow& row = renderer_row(settings.renderer);
  const WorkingScene working(scene, view, settings, prepared);
  PixelStory story = row.inspect(working.scene(), working.view(), working.settings(), pixel, prepared, progress);
  story_to_world(working.space, story.events);
  take_counts(row, story.counters);
  // A listing gives its own verdict and sum, and so does a renderer that reports no steps.
  if (!story.listing && story.verdict.empty()) finish_story(story, scene, settings);
  story.verdict += left_out_words(prepared_traits(scene, prepared), settings);
  return story;
}

}  // namespace ps
