#include <algorithm>
#include <cmath>

#include "inspect/parting/fragment_fate.h"
#include "inspect/parting/parting_parts.h"
#include "options/renderer_kind.h"
#include "record/value_text.h"
#include "render/story/names.h"
#include "render/story/reason_text.h"
#include "scene/scene.h"

namespace ps::parting {
namespace {

/// Depths that are equal within the rounding of two interpolations or of the stored bits.
bool nearly_tied(const FragmentEvent& fragment) {
  if (!fragment.depth_stored || !fragment.depth_new) return false;
  const double stored = *fragment.depth_stored, own = *fragment.depth_new;
  return std::abs(stored - own) <= 1e-4 * std::max(std::abs(stored), std::abs(own));
}

bool through_an_edge(const std::optional<std::array<double, 3>>& edges) {
  return edges && std::any_of(edges->begin(), edges->end(), [](double e) { return e == 0; });
}

/// A listing reports only triangles that reach the pixel: why it lacks the triangle that won in the other story.
template <class Says>
Parting left_out_by_listing(const StoryPair& c, const Sighting& winner, const StorySide& won, const Says& says,
                            std::string_view letter) {
  const std::string name = primitive_name(c.scene, winner.id);
  const auto* fragment = event_at<FragmentEvent>(won.story, winner.seen);
  if (fragment && fragment->back_face)
    return says(PartingCause::culling, fmt::format("The listing of {} drops the back of {}", letter, name),
                {"backface-culling"});
  if (is_tessellated(c.scene, winner.id))
    return says(PartingCause::coverage,
                fmt::format("The listing of {} draws only models, so it leaves out {}", letter, name), {});
  if (explains(c, "draw"))
    return says(PartingCause::coverage, fmt::format("The listing of {} draws only the edges of {}", letter, name),
                {"draw"});
  return says(
      PartingCause::coverage,
      fmt::format(
          "The listing of {} truncates vertex positions to whole pixels, so its rows of {} do not reach this pixel",
          letter, name),
      {"subpixel-bits", "sample-position"});
}

/// Why the triangle that won on the side `won` is not what `lost` shows. `letter` names the side that lost it.
std::optional<Parting> why_lost(const StoryPair& c, const StorySide& won, const Sighting& winner, const StorySide& lost,
                                std::string_view letter) {
  const FragmentFate fate = fate_of(lost.story, winner.id);
  const std::string name = primitive_name(c.scene, winner.id);
  const Option* seen = differing_in_what_is_seen(c);
  const bool only_triangles = !seen || seen->key == "tessellation" || c.both_fragments();
  const auto says = [&](PartingCause cause, const std::string& text, std::initializer_list<std::string_view> keys) {
    std::string why = because(c, keys);
    const bool by_place = cause == PartingCause::coverage || cause == PartingCause::visibility;
    if (why.empty() && by_place) why = because(c, seen);
    Parting parting{cause, text + why + ".", winner.seen, fate.event};
    if (&won == &c.b) std::swap(parting.event_a, parting.event_b);
    return parting;
  };
  if (const auto* reject = event_at<RejectEvent>(lost.story, fate.event)) {
    const std::string text = fmt::format("{} does not draw {}: {}", letter, name, reject_reason_text(reject->reason));
    switch (reject->reason) {
    case RejectReason::back_face:
      return says(PartingCause::culling, text, {"backface-culling"});
    case RejectReason::outside_view:
    case RejectReason::clipped_near:
    case RejectReason::clipped_side:
    case RejectReason::clipped_far:
    case RejectReason::behind_camera:
      return says(PartingCause::clipping, text, {"clipping", "near", "far"});
    case RejectReason::zero_area:
      return says(PartingCause::coverage, text, {"subpixel-bits", "edge-arithmetic"});
    case RejectReason::cut_out:
      return says(PartingCause::texture, text, {"textures"});
    case RejectReason::not_covered:
      break;
    }
    const auto* fragment = event_at<FragmentEvent>(won.story, winner.seen);
    const bool on_an_edge = (fragment && through_an_edge(fragment->edges)) || through_an_edge(reject->edges);
    if (is_tessellated(c.scene, winner.id) && !c.two_rasterizers() && only_triangles &&
        !(on_an_edge && explains(c, "fill-rule")))
      return says(
          PartingCause::tessellation,
          fmt::format("{} is drawn as triangles, and the triangles in {} do not reach this pixel", name, letter),
          {"tessellation"});
    if (on_an_edge)
      return says(PartingCause::fill_rule,
                  fmt::format("An edge of {} passes exactly through the sample, and the fill rule of {} gives the "
                              "sample to the neighbour",
                              name, letter),
                  {"fill-rule"});
    return says(PartingCause::coverage, text,
                {"subpixel-bits", "coverage", "edge-arithmetic", "sample-position", "fill-rule", "renderer"});
  }
  if (fate.event < 0) {
    if (lost.story.listing) return left_out_by_listing(c, winner, won, says, letter);
    if (explains(c, "clipping") || explains(c, "near") || explains(c, "far"))
      return says(PartingCause::clipping, fmt::format("{} clips away the part of {} at this pixel", letter, name),
                  {"clipping", "near", "far"});
    return std::nullopt;
  }
  const auto* fragment = event_at<FragmentEvent>(lost.story, fate.event);
  if (!fragment) return std::nullopt;
  if (fragment->depth == FragmentEvent::Depth::failed || fate.painted_over) {
    const std::string text =
        fragment->depth == FragmentEvent::Depth::failed
            ? fmt::format("{} fails the depth test in {}{}", name, letter, depth_against_text(*fragment))
            : fmt::format("{} is drawn in {} too, but painted over later", name, letter);
    const bool by_order = !because(c, {"visibility", "depth-value"}).empty();
    const bool other_triangles = explains(c, "tessellation") || c.two_ways();
    if (!by_order && other_triangles && only_triangles &&
        (is_tessellated(c.scene, winner.id) || is_tessellated(c.scene, fate.winner)))
      return says(PartingCause::tessellation, text + "; curved surfaces are drawn there as triangles",
                  {"tessellation"});
    if (!by_order && fragment->depth == FragmentEvent::Depth::failed && nearly_tied(*fragment))
      return says(PartingCause::depth_tie, text + "; the two depths are too close for the depth buffer",
                  {"depth-bits", "depth-format", "depth-value", "depth-reversed", "precision"});
    if (!by_order && fate.tied_with_winner)
      return says(PartingCause::depth_tie, text + " by a triangle of nearly the same depth",
                  {"depth-bits", "depth-format", "depth-value", "depth-reversed", "precision"});
    return says(PartingCause::visibility, text,
                {"visibility", "depth-value", "depth-bits", "depth-format", "backface-culling"});
  }
  return std::nullopt;
}

/// Order of the rasterizer's steps. If A's winner failed the depth test in B only because B's winner was culled in A,
/// the culling, which comes first, is the cause.
int earlier_step(PartingCause cause) {
  constexpr std::array order{PartingCause::tessellation, PartingCause::clipping, PartingCause::culling,
                             PartingCause::fill_rule,    PartingCause::coverage, PartingCause::depth_tie,
                             PartingCause::visibility};
  return static_cast<int>(std::find(order.begin(), order.end(), cause) - order.begin());
}

}  // namespace

bool is_tessellated(const Scene& scene, const PixelId& id) {
  const auto& objects = scene.geometry->objects;
  return id.object >= 0 && static_cast<std::size_t>(id.object) < objects.size() &&
         !std::holds_alternative<Instance>(objects[static_cast<std::size_t>(id.object)].shape);
}

FragmentFate fate_of(const PixelStory& story, const PixelId& id) {
  FragmentFate fate;
  const FragmentEvent* own = nullptr;
  for (int i = 0; i < static_cast<int>(story.events.size()); ++i) {
    if (const auto* fragment = event_at<FragmentEvent>(story, i)) {
      if (fragment->id == id)
        fate = {i, {}, false, false}, own = fragment;
      else if (own && fragment->depth != FragmentEvent::Depth::failed) {
        fate.painted_over = true;
        const double size = std::max(std::abs(own->z), std::abs(fragment->z));
        fate.tied_with_winner = std::abs(own->z - fragment->z) <= 1e-4 * size;
      }
    } else if (const auto* reject = event_at<RejectEvent>(story, i)) {
      // A sphere is many triangles with one id: what matters is one that was drawn, then one that came nearest.
      if (reject->id == id && !own && (fate.event < 0 || reject->reason == RejectReason::not_covered)) fate.event = i;
    }
  }
  fate.winner = sight_of_fragments(story).id;
  return fate;
}

Parting fragments_won_differently(const StoryPair& c, const Sighting& a, const Sighting& b) {
  std::optional<Parting> best;
  const auto consider = [&](std::optional<Parting> found) {
    if (found && (!best || earlier_step(found->cause) < earlier_step(best->cause))) best = std::move(found);
  };
  if (a.id.object >= 0) consider(why_lost(c, c.a, a, c.b, "B"));
  if (b.id.object >= 0) consider(why_lost(c, c.b, b, c.a, "A"));
  if (best) return *best;
  return {
      PartingCause::unexplained,
      fmt::format("Unexplained: A shows {} and B {}.", primitive_name(c.scene, a.id), primitive_name(c.scene, b.id)),
      a.seen, b.seen};
}

namespace {

bool is_csg(const Scene& scene, const PixelId& id) {
  const auto& objects = scene.geometry->objects;
  return id.object >= 0 && static_cast<std::size_t>(id.object) < objects.size() &&
         std::holds_alternative<Csg>(objects[static_cast<std::size_t>(id.object)].shape);
}

/// The cause where an option decides what a ray or a fragment shows.
PartingCause cause_of_option(const Option& option) {
  if (option.key == "near" || option.key == "far" || option.key == "clipping") return PartingCause::clipping;
  if (option.group == "Camera" || option.group == "Sampling") return PartingCause::eye_ray;
  return option.group == "Visibility" ? PartingCause::visibility : PartingCause::coverage;
}

}  // namespace

Parting ray_and_fragment_differ(const StoryPair& c, const Sighting& a, const Sighting& b) {
  const bool ray_is_a = sends_rays(c.a.story.renderer);
  const Sighting& ray = ray_is_a ? a : b;
  const Sighting& drawn = ray_is_a ? b : a;
  const StorySide& raster = ray_is_a ? c.b : c.a;
  const std::string_view letter = ray_is_a ? "B" : "A";
  if (ray.id.object >= 0) {
    const StorySide& traced = ray_is_a ? c.a : c.b;
    const auto found = why_lost(c, traced, ray, raster, letter);
    const bool by_rule = found && found->cause == PartingCause::fill_rule && explains(c, "fill-rule");
    if (by_rule || (found && found->cause != PartingCause::coverage && found->cause != PartingCause::fill_rule))
      return *found;
  }
  const auto says = [&](PartingCause cause, const std::string& text) { return Parting{cause, text, a.seen, b.seen}; };
  const std::string saw = fmt::format("The ray of {} hits {}, and {} shows {}", ray_is_a ? "A" : "B",
                                      primitive_name(c.scene, ray.id), letter, primitive_name(c.scene, drawn.id));
  if (is_csg(c.scene, ray.id))
    return says(PartingCause::tessellation,
                saw + ": renderers of triangles leave out CSG objects, whose surfaces are only computed per ray.");
  // Which of an option and the outline of a surface it was cannot be seen in the events.
  if (const Option* option = differing_in_what_is_seen(c); option && option->key != "tessellation")
    return says(cause_of_option(*option), saw + because(c, option) + ", unless an outline passes within this pixel.");
  if (is_tessellated(c.scene, ray.id) || is_tessellated(c.scene, drawn.id))
    return says(
        PartingCause::tessellation,
        saw + ": the ray meets the exact curved surface; flat triangles with vertices on it are drawn in its place.");
  return says(PartingCause::silhouette,
              saw + ": an outline passes within a pixel, and rays round differently from snapped vertices.");
}

}  // namespace ps::parting
