#include <fmt/format.h>

#include <map>
#include <utility>

#include "record/value_text.h"
#include "render/story/finish_story.h"
#include "render/story/names.h"
#include "render/story/reason_text.h"
#include "render/story/story_tree.h"
#include "render/story/write_mixing.h"

namespace ps {
namespace {

std::string plural(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

/// The part of a light that reaches a point where it is blocked, wholly or in part.
std::string shadow_remark(int light, double visible) {
  return visible > 0 ? fmt::format("{} % of light {} reaches it", number_text(100 * visible), light)
                     : fmt::format("it lies in the shadow of light {}", light);
}

/// The effect of each light at the hit of ray `ray`, where it is worth a word.
void add_light_remarks(const PixelStory& story, const Scene& scene, int ray, const PixelId& hit,
                       std::vector<std::string>& parts) {
  for (const int index : events_of_ray<LightEvent>(story.events, ray)) {
    const auto& light = event_as<LightEvent>(story.events, index);
    if (light.below_horizon)  // reported first: such a surface always blocks its own light
      parts.push_back(fmt::format("it faces away from light {}", light.light));
    else if (light.blocker && *light.blocker == hit)
      parts.push_back(fmt::format("light {} is blocked by the surface itself", light.light));
    else if (light.blocker)
      parts.push_back(fmt::format("light {} is blocked by {}", light.light, primitive_name(scene, *light.blocker)));
    else if (light.visible < 1)
      parts.push_back(shadow_remark(light.light, light.visible));
  }
}

/// "mean of 16 samples: 9 of sphere 1 (red), 7 of background", for those samples whose rays are recorded.
std::string samples_verdict(const PixelStory& story, const Scene& scene, const std::vector<int>& samples) {
  const auto& events = story.events;
  std::map<int, std::size_t> seen;  // by object; -1 = background
  for (const int index : samples)
    for (const int ray : events_below<RayEvent>(events, index)) {
      if (event_as<RayEvent>(events, ray).kind != RayKind::eye) continue;
      const auto hits = events_of_ray<HitEvent>(events, ray);
      ++seen[hits.empty() ? -1 : event_as<HitEvent>(events, hits.back()).id.object];
    }
  std::size_t shown = 0;
  std::string text;
  for (const auto& [object, count] : seen) {
    shown += count;
    text += fmt::format("{}{} of {}", text.empty() ? "" : ", ", count,
                        object < 0 ? "background" : object_name(scene, object));
  }
  const std::string which = shown < samples.size() ? fmt::format(", of which the first {} are shown", shown) : "";
  const bool subdivided = !events_of_ray<CompareEvent>(events, -1).empty();
  return fmt::format("mean of {}{}: {}{}", plural(samples.size(), "sample", "samples"), which, text,
                     subdivided ? "; subdivided, since a neighbour differs" : "");
}

std::string ray_verdict(const PixelStory& story, const Scene& scene, int eye) {
  const auto& events = story.events;
  const auto hits = events_of_ray<HitEvent>(events, eye);
  if (hits.empty()) {
    const std::size_t tests = events_of_ray<SphereTestEvent>(events, eye).size() +
                              events_of_ray<TriangleTestEvent>(events, eye).size() +
                              events_of_ray<SolidTestEvent>(events, eye).size();
    if (tests == 0) return "the eye ray hits nothing: background";
    return fmt::format("the eye ray hits nothing ({}): background",
                       plural(tests, "primitive was tested", "primitives were tested"));
  }
  const auto& hit = event_as<HitEvent>(events, hits.back());
  std::vector<std::string> parts{fmt::format("{} won at t = {}", primitive_name(scene, hit.id), number_text(hit.t))};
  if (hit.back_face) parts.push_back("seen from behind");
  add_light_remarks(story, scene, eye, hit.id, parts);
  std::size_t bounces = 0, refractions = 0;
  for (const auto* ray : events_of<RayEvent>(events)) {
    if (ray->kind == RayKind::reflection) ++bounces;
    if (ray->kind == RayKind::refraction) ++refractions;
  }
  if (bounces > 0) parts.push_back(plural(bounces, "bounce", "bounces"));
  if (refractions > 0) parts.push_back(plural(refractions, "refraction", "refractions"));
  return joined(parts);
}

/// How often each reason kept a triangle from the pixel, as "2 back faces culled".
void add_rejections(const PixelStory& story, bool with_uncovered, std::vector<std::string>& parts) {
  for (const RejectReason reason : all_reject_reasons) {
    if (reason == RejectReason::not_covered && !with_uncovered) continue;
    std::size_t count = 0;
    for (const auto* reject : events_of<RejectEvent>(story.events))
      if (reject->reason == reason) ++count;
    if (count > 0) parts.push_back(reject_count_text(reason, count));
  }
}

/// How what wrote the pixel, one after the other, makes up its colour. An opaque surface of the scene always takes the
/// place of what was there.
void add_paint_remarks(const PixelStory& story, std::vector<std::string>& parts) {
  std::size_t covered = 0, seen = 0;
  Mixing last = Mixing::replaces;
  for (const Event& event : story.events) {
    const auto* write = std::get_if<WriteEvent>(&event.data);
    if (!write && !std::holds_alternative<LineEvent>(event.data)) continue;
    last = write && (write->id.object < 0 || write->opacity < 1) ? mixing_of(*write) : Mixing::replaces;
    if (last == Mixing::replaces) covered += std::exchange(seen, 0);
    ++seen;
  }
  const std::string below = seen > 1 ? plural(seen - 1, "earlier colour", "earlier colours") : "the background";
  if (last == Mixing::adds) parts.push_back("its colour is added to " + below);
  if (last == Mixing::filters) parts.push_back("it filters " + below);
  if (last == Mixing::blends) parts.push_back("it is blended with " + below);
  if (covered > 0) parts.push_back(plural(covered, "earlier colour was", "earlier colours were") + " painted over");
}

void add_fragment_remarks(const PixelStory& story, std::size_t writes, std::vector<std::string>& parts) {
  std::size_t failed = 0;
  bool depth_off = false;
  bool shaded_later = false;
  for (const auto* fragment : events_of<FragmentEvent>(story.events)) {
    if (fragment->pass == FragmentEvent::Pass::shading) {
      shaded_later = true;
      continue;
    }
    if (fragment->depth == FragmentEvent::Depth::failed) ++failed;
    if (fragment->depth == FragmentEvent::Depth::off) depth_off = true;
  }
  if (shaded_later)
    parts.push_back("shaded after the depth pass" + (writes > 1 ? fmt::format(", in {} passes", writes) : ""));
  else
    add_paint_remarks(story, parts);
  if (failed > 0) parts.push_back(plural(failed, "fragment", "fragments") + " failed the depth test");
  if (depth_off) parts.push_back("the depth test is off");
}

/// Which lights are blocked at the visible surface, wholly or in part.
void add_shadow_remarks(const PixelStory& story, std::vector<std::string>& parts) {
  std::map<int, double> current, seen;  // share by light
  PixelId written;
  bool further_pass = false;  // over what is written: a light that is blocked there adds no light
  for (const Event& event : story.events) {
    if (const auto* fragment = std::get_if<FragmentEvent>(&event.data)) {
      current.clear();
      further_pass = fragment->pass == FragmentEvent::Pass::shading && fragment->id == written;
    }
    const auto* light = std::get_if<LightEvent>(&event.data);
    if (light && light->visible < 1 && !light->below_horizon)
      (further_pass ? seen : current)[light->light] = light->visible;
    const auto* write = std::get_if<WriteEvent>(&event.data);
    if (!write) continue;
    if (!further_pass) seen = current;
    written = write->id;
  }
  for (const auto& [light, share] : seen) parts.push_back(shadow_remark(light, share));
}

/// The sentence about the fragment that wrote last.
std::string winner_behind_camera(const PixelStory& story) {
  const FragmentEvent* fragment = nullptr;
  std::string text;
  for (const Event& event : story.events) {
    if (const auto* f = std::get_if<FragmentEvent>(&event.data)) fragment = f;
    if (std::holds_alternative<WriteEvent>(event.data)) text = fragment ? behind_camera_text(*fragment) : "";
  }
  return text;
}

/// The shape on the canvas that wrote last.
std::string shape_that_won(const PixelStory& story) {
  const PolygonEvent* polygon = nullptr;
  for (const Event& event : story.events) {
    if (!std::holds_alternative<WriteEvent>(event.data)) continue;
    const auto parent = static_cast<std::size_t>(event.parent);
    polygon = event.parent < 0 ? nullptr : std::get_if<PolygonEvent>(&story.events[parent].data);
  }
  if (!polygon) return "a shape on the canvas won";
  const std::string_view shape = polygon->vertices.size() == 3 ? "triangle" : "polygon";
  std::string text = fmt::format("{} {} on the canvas won", shape, polygon->item);
  if (polygon->row)
    text += fmt::format(", row {} from x = {} to {}", story.pixel.y, polygon->row->left, polygon->row->right);
  return text;
}

std::string fragment_verdict(const PixelStory& story, const Scene& scene) {
  const WriteEvent* write = nullptr;
  const LineEvent* line = nullptr;
  for (const Event& event : story.events) {
    if (const auto* w = std::get_if<WriteEvent>(&event.data)) write = w, line = nullptr;
    if (const auto* l = std::get_if<LineEvent>(&event.data)) line = l;
  }
  std::vector<std::string> parts;
  if (!write && !line) {
    add_rejections(story, true, parts);
    if (parts.empty() && story.triangles_elsewhere > 0) parts.push_back("no triangle lies close to the pixel");
    if (parts.empty()) parts.push_back("no triangle lies close to the pixel");
    return fmt::format("nothing is drawn here: background ({})", joined(parts));
  }
  if (line)
    parts.push_back(line_name(scene, *line) + " won");
  else if (write->id.object >= 0)
    parts.push_back(fmt::format("{} won", primitive_name(scene, write->id)));
  else
    parts.push_back(shape_that_won(story));
  if (write) add_shadow_remarks(story, parts);
  if (const std::string behind = winner_behind_camera(story); !behind.empty())
    parts.push_back("it was not clipped, " + behind);
  add_fragment_remarks(story, events_of<WriteEvent>(story.events).size() + events_of<LineEvent>(story.events).size(),
                       parts);
  add_rejections(story, false, parts);
  return joined(parts);
}

}  // namespace

std::string story_verdict(const PixelStory& story, const Scene& scene) {
  if (const auto samples = events_of_ray<SampleEvent>(story.events, -1); !samples.empty())
    return samples_verdict(story, scene, samples);
  const int eye = eye_ray(story.events);
  return eye >= 0 ? ray_verdict(story, scene, eye) : fragment_verdict(story, scene);
}

}  // namespace ps
