#include "inspect/parting/parting.h"

#include <algorithm>
#include <array>

#include "inspect/parting/parting_parts.h"
#include "record/value_text.h"
#include "render/story/story_tree.h"
#include "textbook/listing_events.h"

namespace ps {
namespace {

using parting::all_differences;
using parting::because;
using parting::event_at;
using parting::ray_and_fragment_differ;
using parting::StoryPair;

Sighting top_sighting(const PixelStory& story, int eye) {
  return eye >= 0 ? sight_of_ray(story, eye) : sight_of_fragments(story);
}

std::vector<int> eye_rays(const PixelStory& story) {
  std::vector<int> rays;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i)
    if (const auto* ray = event_at<RayEvent>(story, i); ray && ray->kind == RayKind::eye) rays.push_back(i);
  return rays;
}

std::optional<Parting> part_at_eye_ray(const StoryPair& c, int ray_a, int ray_b) {
  const auto& a = event_as<RayEvent>(c.a.story.events, ray_a);
  const auto& b = event_as<RayEvent>(c.b.story.events, ray_b);
  if (c.same(a.origin, b.origin) && c.same(a.direction, b.direction)) return std::nullopt;
  return Parting{PartingCause::eye_ray,
                 fmt::format("The eye rays differ: A looks along {}, B along {}{}.", vector_text(a.direction),
                             vector_text(b.direction),
                             because(c, {"sample-position", "samples-per-pixel", "sample-pattern", "projection",
                                         "viewport-fit", "field-of-view-span"})),
                 ray_a, ray_b};
}

std::optional<Parting> part_at_sighting(const StoryPair& c, const Sighting& a, const Sighting& b, int depth);

/// The rays that go on from the surface: one of them missing, or the first difference further on.
std::optional<Parting> part_at_children(const StoryPair& c, const Sighting& a, const Sighting& b,
                                        const std::vector<int>& from_a, const std::vector<int>& from_b,
                                        std::string_view kind, int depth) {
  if (from_a.empty() != from_b.empty()) {
    const bool in_a = !from_a.empty();
    return Parting{PartingCause::missing_bounce,
                   fmt::format("{} follows the {} ray from bounce {} on, {} does not{}.", in_a ? "A" : "B", kind,
                               depth + 1, in_a ? "B" : "A",
                               because(c, {"renderer", "reflection-depth", "reflection-cutoff", "refraction"})),
                   in_a ? from_a.front() : a.seen, in_a ? b.seen : from_b.front()};
  }
  if (from_a.empty()) return std::nullopt;
  return part_at_sighting(c, sight_of_ray(c.a.story, from_a.front()), sight_of_ray(c.b.story, from_b.front()),
                          depth + 1);
}

std::optional<Parting> part_at_sighting(const StoryPair& c, const Sighting& a, const Sighting& b, int depth) {
  if (auto found = part_at_winner(c, a, b)) return found;
  if (a.id.object < 0) return std::nullopt;
  if (auto found = part_at_point(c, a, b)) return found;
  if (auto found = part_at_texture(c, a, b)) return found;
  if (auto found = part_at_light(c, a, b)) return found;
  if (auto found = part_at_children(c, a, b, a.mirrored_ray, b.mirrored_ray, "mirrored", depth)) return found;
  return part_at_children(c, a, b, a.refracted_ray, b.refracted_ray, "refracted", depth);
}

int last_event(const StorySide& side) { return static_cast<int>(side.story.events.size()) - 1; }

std::optional<Parting> part_at_display(const StoryPair& c) {
  const std::string why = because(c, {"exposure", "gamma", "colour-depth"});
  if (why.empty() || !c.same(c.a.story.linear, c.b.story.linear)) return std::nullopt;
  return Parting{PartingCause::display, "The linear colour is the same; the display settings differ" + why + ".",
                 last_event(c.a), last_event(c.b)};
}

/// A ray and a fragment that see neighbouring triangles of one model, which differ only in colour.
std::optional<Parting> part_at_inner_edge(const StoryPair& c, const std::vector<int>& rays_a,
                                          const std::vector<int>& rays_b) {
  if (!c.two_ways()) return std::nullopt;
  const Sighting a = top_sighting(c.a.story, rays_a.empty() ? -1 : rays_a.front());
  const Sighting b = top_sighting(c.b.story, rays_b.empty() ? -1 : rays_b.front());
  if (a.id == b.id || a.id.object != b.id.object) return std::nullopt;
  return ray_and_fragment_differ(c, a, b);
}

/// Lines and triangles on the canvas: what the pixel got from them.
std::optional<Parting> part_at_canvas(const StoryPair& c) {
  const auto drawn = [](const PixelStory& story) {
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(story.events.size()); ++i) {
      const auto* write = event_at<WriteEvent>(story, i);
      if (!write && !event_at<LineEvent>(story, i)) continue;
      // Light that is added pass by pass draws a surface once.
      const auto* fragment =
          write ? event_at<FragmentEvent>(story, story.events[static_cast<std::size_t>(i)].parent) : nullptr;
      const auto* before = found.empty() ? nullptr : event_at<WriteEvent>(story, found.back());
      if (fragment && fragment->pass == FragmentEvent::Pass::shading && before && before->id == write->id)
        found.back() = i;
      else
        found.push_back(i);
    }
    return found;
  };
  const auto of_a = drawn(c.a.story), of_b = drawn(c.b.story);
  if (!c.both_fragments() || of_a.size() == of_b.size()) return std::nullopt;
  const auto times = [](std::size_t count) {
    return count == 0 ? std::string("not at all") : count == 1 ? "once" : fmt::format("{} times", count);
  };
  std::string why = because(c, {"blending", "draw", "line-algorithm", "fill-rule", "canvas-fill", "backface-culling",
                                "subpixel-bits", "sample-position"});
  if (why.empty()) why = because(c, parting::differing_in_what_is_seen(c));
  return Parting{PartingCause::coverage,
                 fmt::format("A draws over this pixel {}, B {}{}.", times(of_a.size()), times(of_b.size()), why),
                 of_a.empty() ? last_event(c.a) : of_a.back(), of_b.empty() ? last_event(c.b) : of_b.back()};
}

/// How often the triangle that is seen writes the pixel: once for each pass that adds light.
int count_writes(const PixelStory& story) {
  int count = 0;
  PixelId last;
  for (const auto* write : events_of<WriteEvent>(story.events)) {
    count = write->id == last ? count + 1 : 1;
    last = write->id;
  }
  return count;
}

std::string passes_text(int count) { return count == 1 ? "one pass" : fmt::format("{} passes", count); }

/// How two colours came to differ in their last digits.
std::string rounding_text(const StoryPair& c) {
  if (!c.both_rays() && !c.both_fragments())
    return fmt::format(
        "A ends with {} and B with {}: a ray and a fragment meet the surface at slightly different points",
        vector_text(c.a.story.linear), vector_text(c.b.story.linear));
  const int writes_a = count_writes(c.a.story), writes_b = count_writes(c.b.story);
  if (writes_a == writes_b) return "Both take the same steps; only the last digits differ";
  return fmt::format("A adds up this pixel's colour in {}, B in {}; only the last digits of the sums differ",
                     passes_text(writes_a), passes_text(writes_b));
}

/// Nothing but rounding: small at every step, and yet enough to end on another level.
std::optional<Parting> part_at_last_digits(const StoryPair& c) {
  const std::string why = because(c, {"renderer", "precision", "sphere-test", "triangle-test", "self-hit",
                                      "shadow-epsilon", "reflection-epsilon", "epsilon-unit"});
  if (why.empty() || !c.same(c.a.story.linear, c.b.story.linear)) return std::nullopt;
  return Parting{PartingCause::precision, rounding_text(c) + why + ".", last_event(c.a), last_event(c.b)};
}

}  // namespace

namespace {

/// Both stories, in the steps of renderers.
Parting find_step(const StoryPair& c) {
  const StorySide &a = c.a, &b = c.b;
  const auto rays_a = eye_rays(a.story), rays_b = eye_rays(b.story);
  const std::size_t samples = std::min(rays_a.size(), rays_b.size());
  for (std::size_t k = 0; k < samples; ++k)
    if (auto found = part_at_eye_ray(c, rays_a[k], rays_b[k])) return *found;
  const std::size_t sightings = std::max<std::size_t>(samples, 1);
  for (std::size_t k = 0; k < sightings; ++k) {
    const Sighting sight_a = top_sighting(a.story, k < rays_a.size() ? rays_a[k] : -1);
    const Sighting sight_b = top_sighting(b.story, k < rays_b.size() ? rays_b[k] : -1);
    if (auto found = part_at_sighting(c, sight_a, sight_b, 0)) return *found;
  }
  if (rays_a.size() != rays_b.size() && samples > 0)
    return {PartingCause::eye_ray,
            fmt::format("A traces {} eye rays through the pixel and B {}{}.", rays_a.size(), rays_b.size(),
                        because(c, {"samples-per-pixel", "adaptive-sampling", "subsampling"})),
            rays_a.back(), rays_b.back()};
  if (auto found = part_at_inner_edge(c, rays_a, rays_b)) return *found;
  if (auto found = part_at_canvas(c)) return *found;
  if (auto found = part_at_display(c)) return *found;
  if (auto found = part_at_last_digits(c)) return *found;
  return {PartingCause::unexplained,
          fmt::format("Unexplained: both take the same steps, but A ends with {} and B with {}.",
                      vector_text(a.story.linear), vector_text(b.story.linear)),
          last_event(a), last_event(b)};
}

/// A listing's story as that of the renderer whose steps it takes, with the options that say what it does.
struct SteppedLike {
  PixelStory story;
  Settings settings;
};

std::optional<SteppedLike> as_stepped(const Scene& scene, const StorySide& side) {
  if (!side.story.listing) return std::nullopt;
  const NamedListing& listing = side.story.listing->listing;
  SteppedLike stepped{side.story, settings_as_listed(listing, scene, side.settings)};
  stepped.story.renderer = stepped_like(listing);
  return stepped;
}

/// Whether a cause is something that one of the two does and the other does not, and no matter of places.
bool is_plain(PartingCause cause) {
  constexpr std::array plain{PartingCause::missing_bounce, PartingCause::missing_shadow, PartingCause::light_model,
                             PartingCause::texture,        PartingCause::culling,        PartingCause::clipping,
                             PartingCause::visibility};
  return std::find(plain.begin(), plain.end(), cause) != plain.end();
}

constexpr double half_a_pixel = 0.02;  // how much numbers may differ for the place in a pixel alone

/// The first step of both stories that differs, with its cause as renderers would have it.
Parting first_step(const Scene& scene, const StorySide& a, const StorySide& b) {
  const auto stepped_a = as_stepped(scene, a), stepped_b = as_stepped(scene, b);
  const StorySide side_a = stepped_a ? StorySide{stepped_a->story, stepped_a->settings} : a;
  const StorySide side_b = stepped_b ? StorySide{stepped_b->story, stepped_b->settings} : b;
  StoryPair c{scene, side_a, side_b};
  if (c.with_listing() && explains(c, "sample-position")) {
    // A listing samples the corner, so that nearly all numbers differ a little. Large differences are reported before
    // that.
    c.slack = half_a_pixel;
    if (Parting far = find_step(c); is_plain(far.cause)) return far;
    c.slack = 0;
  }
  return find_step(c);
}

std::string planted_in(const StorySide& side) {
  return side.story.listing ? side.story.listing->listing.bug : std::string();
}

/// What can be said of a listing with a wrong line. The step is marked and not explained.
std::string planted_bug_text(const StorySide& a, const StorySide& b) {
  const std::string ends =
      fmt::format(" A ends with {} and B with {}.", vector_text(a.story.linear), vector_text(b.story.linear));
  const bool one_listing =
      a.story.listing && b.story.listing && a.story.listing->listing.folder == b.story.listing->listing.folder;
  const std::string bug_a = planted_in(a), bug_b = planted_in(b);
  if (one_listing && (bug_a.empty() || bug_b.empty()))
    return "The listings of A and B differ in one line: find it." + ends;
  if (!bug_a.empty() && !bug_b.empty()) return "The listings of A and B have a wrong line each: find both." + ends;
  return fmt::format("The listing of {} has one wrong line. Compare it first with the listing without a bug.{}",
                     bug_a.empty() ? "B" : "A", ends);
}

}  // namespace

Parting find_parting(const Scene& scene, const StorySide& a, const StorySide& b) {
  if (a.story.linear == b.story.linear && a.story.display == b.story.display)
    return {PartingCause::none, "Both stories end in exactly the same colour.", -1, -1};
  Parting parting = first_step(scene, a, b);
  if (parting.cause == PartingCause::unexplained)
    if (const std::string options = all_differences({scene, a, b}); !options.empty())
      parting.sentence += " The options that differ: " + options + ".";
  if (planted_in(a) == planted_in(b)) return parting;
  return {PartingCause::planted_bug, planted_bug_text(a, b), parting.event_a, parting.event_b};
}

}  // namespace ps
