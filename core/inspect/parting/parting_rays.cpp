#include <cmath>

#include "inspect/parting/parting_parts.h"
#include "math/unit.h"
#include "record/value_text.h"
#include "render/story/names.h"
#include "render/story/reason_text.h"
#include "scene/scene.h"

namespace ps::parting {
namespace {

/// How ray `ray` fared with the primitive: the outcome of its test, or nothing if the ray never tested it.
struct Tested {
  int event = -1;
  std::optional<TestOutcome> outcome;
};

Tested test_of(const PixelStory& story, int ray, const PixelId& id) {
  Tested tested;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i) {
    const Event& event = story.events[static_cast<std::size_t>(i)];
    if (event.parent != ray) continue;
    const auto take = [&](const auto& test) {
      if (test.id.object == id.object && (test.id == id || id.triangle < 0)) tested = {i, test.outcome};
    };
    if (const auto* sphere = std::get_if<SphereTestEvent>(&event.data)) take(*sphere);
    if (const auto* triangle = std::get_if<TriangleTestEvent>(&event.data)) take(*triangle);
    if (const auto* solid = std::get_if<SolidTestEvent>(&event.data)) take(*solid);
  }
  return tested;
}

double t_of(const PixelStory& story, const Sighting& sighting) {
  const auto* hit = event_at<HitEvent>(story, sighting.seen);
  return hit ? hit->t : INFINITY;
}

/// Whether the test found the intersection at `t` and yet went on with the sphere's other root.
bool turned_down_root(const PixelStory& story, int test, double t) {
  const auto* sphere = event_at<SphereTestEvent>(story, test);
  return sphere && sphere->roots && std::abs((*sphere->roots)[0] - t) <= 1e-4 * std::max(1.0, std::abs(t)) &&
         (*sphere->roots)[1] > t;
}

/// A secondary ray that meets something so near its start that it can only be where it starts from.
bool starts_on(const PixelStory& story, const Sighting& sighting) {
  const auto* ray = event_at<RayEvent>(story, sighting.ray);
  if (!ray || ray->kind == RayKind::eye) return false;
  const double step = t_of(story, sighting) * length_of(ray->direction);
  const double scale = std::max({1.0, std::abs(ray->origin.x), std::abs(ray->origin.y), std::abs(ray->origin.z)});
  return step < 1e-2 * scale;
}

bool is_no_sphere(const Scene& scene, const PixelId& id) {
  const auto& objects = scene.geometry->objects;
  return id.object >= 0 && static_cast<std::size_t>(id.object) < objects.size() &&
         !std::holds_alternative<Sphere>(objects[static_cast<std::size_t>(id.object)].shape);
}

/// Embree tests triangles with arithmetic of its own.
bool uses_embree(const StorySide& side) { return side.settings.accelerator == Accelerator::embree; }

constexpr std::string_view epsilon_keys[] = {"self-hit", "shadow-epsilon", "reflection-epsilon", "epsilon-unit"};

}  // namespace

Parting rays_saw_different_things(const StoryPair& c, const Sighting& a, const Sighting& b) {
  const auto says = [&](PartingCause cause, std::string text, std::initializer_list<std::string_view> keys) {
    return Parting{cause, std::move(text) + because(c, keys) + ".", a.seen, b.seen};
  };
  const std::string saw =
      fmt::format("A sees {} and B {}", primitive_name(c.scene, a.id), primitive_name(c.scene, b.id));
  const bool own_a = starts_on(c.a.story, a), own_b = starts_on(c.b.story, b);
  if (own_a != own_b)
    for (const std::string_view key : epsilon_keys)
      if (explains(c, key))
        return says(PartingCause::epsilon,
                    fmt::format("The ray of {} hits the surface that it starts from, at t = {}", own_a ? "A" : "B",
                                number_text(own_a ? t_of(c.a.story, a) : t_of(c.b.story, b))),
                    {key});
  // The nearer of the two hits is the one that the other side must have turned down.
  const bool nearer_a = t_of(c.a.story, a) <= t_of(c.b.story, b);
  const Sighting& winner = nearer_a ? a : b;
  const StorySide& other = nearer_a ? c.b : c.a;
  const Tested tested = test_of(other.story, nearer_a ? b.ray : a.ray, winner.id);
  const std::string_view loser = nearer_a ? "B" : "A";
  if (!tested.outcome && other.story.listing && is_no_sphere(c.scene, winner.id))
    return says(PartingCause::visibility, fmt::format("{}: the listing of {} supports only spheres", saw, loser), {});
  if (!tested.outcome)
    return says(explains(c, "accelerator") || explains(c, "slab-test") ? PartingCause::precision
                                                                       : PartingCause::unexplained,
                fmt::format("{}: {} never tested {}", saw, loser, primitive_name(c.scene, winner.id)),
                {"slab-test", "accelerator"});
  switch (*tested.outcome) {
  case TestOutcome::before_range:
    for (const std::string_view key : epsilon_keys)
      if (explains(c, key))
        return says(PartingCause::epsilon,
                    fmt::format("{}: the hit at t = {} is below t min of the ray of {}", saw,
                                number_text(nearer_a ? t_of(c.a.story, a) : t_of(c.b.story, b)), loser),
                    {key});
    return says(PartingCause::clipping, fmt::format("{}: for {} the hit is nearer than the near limit", saw, loser),
                {"near"});
  case TestOutcome::beyond_range:
    return says(PartingCause::clipping, fmt::format("{}: for {} the hit is beyond the far limit", saw, loser), {"far"});
  case TestOutcome::back_side:
    return says(PartingCause::culling,
                fmt::format("{}: {} culls the back of {}", saw, loser, primitive_name(c.scene, winner.id)),
                {"backface-culling"});
  case TestOutcome::accepted:
  case TestOutcome::farther:
    if (turned_down_root(other.story, tested.event, t_of(nearer_a ? c.a.story : c.b.story, winner)))
      return says(PartingCause::other_root,
                  fmt::format("{}: {} rejects the nearer intersection with {} and takes the farther one", saw, loser,
                              primitive_name(c.scene, winner.id)),
                  {"near", "sphere-test", "self-hit"});
    break;
  case TestOutcome::missed:
  case TestOutcome::parallel:
  case TestOutcome::degenerate:
  case TestOutcome::tie_lost:
    break;
  case TestOutcome::excluded:
    return says(PartingCause::epsilon,
                fmt::format("{}: the ray of {} starts on {}, which it then does not test", saw, loser,
                            primitive_name(c.scene, winner.id)),
                {"self-hit"});
  }
  const bool arithmetic = explains(c, "precision") || uses_embree(c.a) != uses_embree(c.b) ||
                          explains(c, "sphere-test") || explains(c, "triangle-test") || explains(c, "triangle-epsilon");
  return says(arithmetic ? PartingCause::precision : PartingCause::unexplained,
              fmt::format("{}: the test of {} reports \"{}\" in {}", saw, primitive_name(c.scene, winner.id),
                          outcome_text(*tested.outcome), loser),
              {"precision", "sphere-test", "triangle-test", "triangle-epsilon", "accelerator"});
}

}  // namespace ps::parting
