#include "inspect/microscope/microscope.h"

#include <algorithm>
#include <cmath>

#include "base/timer.h"
#include "frame/display_frame.h"
#include "frame/viewport.h"
#include "image/mip_chain.h"
#include "inspect/microscope/enlarge.h"
#include "inspect/microscope/fragments.h"
#include "inspect/microscope/texels.h"
#include "inspect/vertex_chain.h"
#include "options/renderer_kind.h"
#include "raster/clear/canvas_items.h"
#include "render/render.h"
#include "render/renderer_table.h"
#include "render/story/names.h"
#include "render/story/story_tree.h"

namespace ps {
namespace {

constexpr int enlarged_pixels = 96;  // of the pixel and its margin, a side
constexpr int coarse_pixels = 24;    // of the picture that is shown first
// The whole picture has sixteen times as many pixels. Where it will take less than this it comes at once, so that
// nothing changes before one's eyes.
constexpr double at_once = 20;             // milliseconds
constexpr double ray_window = 1.0 / 1024;  // size of the one-pixel picture that a single ray makes
constexpr const char* nothing_seen = "the background";

/// What ray `ray` met, in words.
std::string met_by(const std::vector<Event>& events, int ray, const Scene& scene) {
  const auto hits = events_of_ray<HitEvent>(events, ray);
  return hits.empty() ? nothing_seen : primitive_name(scene, event_as<HitEvent>(events, hits.back()).id);
}

}  // namespace

Microscope::~Microscope() = default;

Microscope::Microscope(Scene scene, const View& view, const Settings& settings, Vec2i pixel, Prepared& prepared,
                       Progress& progress, MicroDetail detail)
    : scene_(std::move(scene)), view_(view), settings_(settings), pixel_(pixel) {
  if (!draws_fragments(settings.renderer)) scene_.canvas_items = {};  // they are drawn nowhere else
  if (detail == MicroDetail::first) {
    const Timer timer;
    draw_enlarged(coarse_pixels, prepared, progress);
    constexpr double more = double(enlarged_pixels * enlarged_pixels) / (coarse_pixels * coarse_pixels);
    detail_ = timer.milliseconds() * more < at_once ? MicroDetail::whole : MicroDetail::first;
  }
  if (detail_ == MicroDetail::whole) draw_enlarged(enlarged_pixels, prepared, progress);
  switch (picture_way(settings.renderer)) {
  case PictureWay::fragments:
    if (renderer_row(settings.renderer).by_driver) {
      find_driver_sample(prepared, progress);
      break;
    }
    fragments_ = make_micro_fragments(scene_, view, settings, pixel, prepared, progress);
    samples_ = fragments_->samples();
    find_line(prepared, progress);
    break;
  case PictureWay::rays:
    find_ray_samples(prepared, progress);
    break;
  case PictureWay::listing:  // a listing has neither samples nor fragments of its own
    break;
  }
  if (detail_ == MicroDetail::whole && !has_edge())
    surroundings_ = look_around(scene_, view, settings, pixel, prepared, progress);
}

/// Whether the enlarged picture shows more than one thing. It does not distinguish triangles on the canvas: near them
/// there is enough to see.
bool Microscope::has_edge() const {
  const PixelId first = enlarged_ids_.pixels().front();
  const bool one = std::all_of(enlarged_ids_.pixels().begin(), enlarged_ids_.pixels().end(),
                               [&](const PixelId& id) { return id == first; });
  return !one || (fragments_ && fragments_->near_canvas());
}

void Microscope::draw_enlarged(int pixels, Prepared& prepared, Progress& progress) {
  const EnlargedView wide = enlarge(view_, settings_, Vec2d(pixel_) - micro_margin, 1 + 2 * micro_margin, pixels);
  RenderRequest request;
  request.channels = Channel::ids;
  Scene wide_scene = scene_;
  // A new part would have all that is kept for the scene made anew.
  if (!scene_.canvas_items->empty())
    wide_scene.canvas_items = Part<std::vector<CanvasItem>>(
        enlarged_canvas(*scene_.canvas_items, view_, Vec2d(pixel_) - micro_margin, 1 + 2 * micro_margin, pixels));
  const Frame frame = render(wide_scene, wide.view, wide.settings, request, prepared, progress);
  enlarged_ = display_frame(frame, settings_);
  enlarged_ids_ = frame.ids;
}

std::string Microscope::seen_at(const Vec2d& point) const {
  const int side = enlarged_ids_.width();
  const Vec2d at = (point + micro_margin) / (1 + 2 * micro_margin) * static_cast<double>(side);
  const int x = std::clamp(static_cast<int>(at.x), 0, side - 1);
  const int y = std::clamp(static_cast<int>(at.y), 0, side - 1);
  const PixelId id = enlarged_ids_.at(x, y);
  return id.object < 0 ? nothing_seen : primitive_name(scene_, id);
}

/// The pixel's samples with what their rays met. The story leaves out most rays of a pixel with very many; the enlarged
/// picture then gives what lies there.
void Microscope::find_ray_samples(Prepared& prepared, Progress& progress) {
  const PixelStory story = inspect(scene_, view_, settings_, pixel_, prepared, progress);
  const auto samples = events_of_ray<SampleEvent>(story.events, -1);
  if (samples.empty()) {
    const int eye = eye_ray(story.events);
    const std::string seen = eye < 0 ? nothing_seen : met_by(story.events, eye, scene_);
    samples_.push_back({make_viewport<double>(view_, settings_).sample, seen != nothing_seen, seen, eye});
    return;
  }
  for (const int index : samples) {
    const Vec2d place = event_as<SampleEvent>(story.events, index).position;
    const auto rays = events_below<RayEvent>(story.events, index);
    const std::string seen = rays.empty() ? seen_at(place) : met_by(story.events, rays.front(), scene_);
    samples_.push_back({place, seen != nothing_seen, seen, index});
  }
}

/// The pixel's sample with the triangle that it shows. Where a driver has the samples of a pixel with several, the
/// story does not have.
void Microscope::find_driver_sample(Prepared& prepared, Progress& progress) {
  const PixelStory story = inspect(scene_, view_, settings_, pixel_, prepared, progress);
  for (const auto* fragment : events_of<FragmentEvent>(story.events))
    if (fragment->samples > 1) return;
  const PixelId seen = shown_triangle(story);
  samples_.push_back({make_viewport<double>(view_, settings_).sample, seen.object >= 0,
                      seen.object < 0 ? nothing_seen : primitive_name(scene_, seen), event_of_shown(story)});
}

/// A line paints whole pixels, so that no point of the pixel shows what lies below it.
void Microscope::find_line(Prepared& prepared, Progress& progress) {
  if (settings_.draw == Draw::filled && raster::count_canvas_lines(scene_) == 0) return;
  const LineEvent* line = nullptr;
  const PixelStory story = inspect(scene_, view_, settings_, pixel_, prepared, progress);
  for (const Event& event : story.events) {
    if (std::holds_alternative<WriteEvent>(event.data)) line = nullptr;
    if (const auto* drawn = std::get_if<LineEvent>(&event.data)) line = drawn;
  }
  if (!line) return;
  line_ = line_name(scene_, *line);
  for (MicroSample& sample : samples_) sample = {sample.position, true, line_, -1};
}

MicroReading Microscope::read(const Vec2d& point, Prepared& prepared, Progress& progress) const {
  MicroReading reading;
  if (fragments_) {
    reading = fragments_->read(point);
    const Vec2d at = reading.point;
    if (line_.empty() || std::min(at.x, at.y) < 0 || std::max(at.x, at.y) > 1)
      return reading;  // the sample may be a corner
    reading.seen = line_;
    reading.front = -1;
    reading.texture.reset();
    return reading;
  }
  reading.point = point;
  const EnlargedView narrow = enlarge(view_, settings_, Vec2d(pixel_) + point - ray_window / 2, ray_window, 1);
  reading.ray = inspect(scene_, narrow.view, narrow.settings, {0, 0}, prepared, progress);
  const auto& events = reading.ray->events;
  if (const int event = event_of_shown(*reading.ray); event >= 0)
    reading.face = face_point(events[static_cast<std::size_t>(event)].data, scene_);
  if (draws_fragments(settings_.renderer)) {
    const PixelId seen = shown_triangle(*reading.ray);
    reading.seen = seen.object < 0 ? nothing_seen : primitive_name(scene_, seen);
    return reading;
  }
  const int eye = eye_ray(events);
  reading.seen = eye < 0 ? nothing_seen : met_by(events, eye, scene_);
  const auto lookups = eye < 0 ? std::vector<int>{} : events_of_ray<TextureEvent>(events, eye);
  if (lookups.empty()) return reading;
  const auto& lookup = event_as<TextureEvent>(events, lookups.front());
  const auto index = static_cast<std::size_t>(lookup.texture);
  if (index >= scene_.textures->size()) return reading;
  const MipChain chain = make_mip_chain((*scene_.textures)[index].texels, MipLevels::finest_only);
  reading.texture = micro_texture(lookup, chain, settings_.texture_wrap, {});
  return reading;
}

}  // namespace ps
