#include <cmath>

#include "inspect/parting/parting_parts.h"
#include "record/value_text.h"
#include "render/story/names.h"

namespace ps::parting {
namespace {

/// Which of a sphere's roots the hit took, as an index, or nullopt for other primitives.
std::optional<int> root_taken(const PixelStory& story, const Sighting& sighting) {
  const auto* hit = event_at<HitEvent>(story, sighting.seen);
  if (!hit) return std::nullopt;
  for (const Event& event : story.events) {
    const auto* test = std::get_if<SphereTestEvent>(&event.data);
    if (!test || event.parent != sighting.ray || !(test->id == hit->id) || !test->roots) continue;
    return std::abs((*test->roots)[0] - hit->t) <= std::abs((*test->roots)[1] - hit->t) ? 0 : 1;
  }
  return std::nullopt;
}

/// The surfaces on both sides count as one and the same. The triangles of a tessellated sphere share its id.
bool same_surface(const StoryPair& c, const Sighting& a, const Sighting& b) {
  if (c.two_ways() && a.id.object == b.id.object) return true;
  return a.id == b.id;
}

/// A listing and the rasterizer have the same triangle in front, but not at the same place of it.
std::optional<Parting> part_at_place(const StoryPair& c, const Sighting& a, const Sighting& b) {
  const auto depth_a = seen_depth(c.a.story, a), depth_b = seen_depth(c.b.story, b);
  if (!c.with_listing() || !c.both_fragments() || !depth_a || !depth_b || c.same(*depth_a, *depth_b))
    return std::nullopt;
  const std::string where = fmt::format("Both draw {}, A at z = {} and B at z = {}", primitive_name(c.scene, a.id),
                                        number_text(*depth_a), number_text(*depth_b));
  if (explains(c, "sample-position"))
    return Parting{PartingCause::eye_ray, where + because(c, {"sample-position"}) + ".", a.seen, b.seen};
  return Parting{PartingCause::coverage, where + ": the listing truncates vertex positions to whole pixels.", a.seen,
                 b.seen};
}

}  // namespace

std::optional<Parting> part_at_winner(const StoryPair& c, const Sighting& a, const Sighting& b) {
  if (same_surface(c, a, b)) return std::nullopt;
  if (c.both_rays()) return rays_saw_different_things(c, a, b);
  if (c.both_fragments()) return fragments_won_differently(c, a, b);
  return ray_and_fragment_differ(c, a, b);
}

std::optional<Parting> part_at_point(const StoryPair& c, const Sighting& a, const Sighting& b) {
  if (auto found = part_at_place(c, a, b)) return found;
  const auto depth_a = seen_depth(c.a.story, a), depth_b = seen_depth(c.b.story, b);
  if (!c.both_rays() || !depth_a || !depth_b || c.same(*depth_a, *depth_b)) return std::nullopt;
  const auto root_a = root_taken(c.a.story, a), root_b = root_taken(c.b.story, b);
  const std::string where = fmt::format("{}: A meets it at t = {} and B at t = {}", primitive_name(c.scene, a.id),
                                        number_text(*depth_a), number_text(*depth_b));
  if (root_a && root_b && *root_a != *root_b)
    return Parting{PartingCause::other_root,
                   fmt::format("Both hit {}; the {} takes the nearer root, the other the farther root{}.", where,
                               *root_a < *root_b ? "ray of A" : "ray of B", because(c, {"near", "sphere-test"})),
                   a.seen, b.seen};
  if (explains(c, "precision"))
    return Parting{
        PartingCause::precision,
        fmt::format("Both hit {}: only the last digits of the arithmetic differ{}.", where, because(c, {"precision"})),
        a.seen, b.seen};
  return std::nullopt;  // a shifted start moves what follows a little; the step that matters comes later
}

}  // namespace ps::parting
