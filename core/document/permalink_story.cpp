// The fields of a permalink for the views of a pixel's story.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/check.h"
#include "base/enumerators.h"
#include "document/number_list.h"
#include "document/permalink_field.h"

namespace ps::detail {
namespace {

using Part = std::optional<std::string>;

constexpr int most_events = 10'000'000;
constexpr std::string_view camera_key = "camera";

OutsideView& outside_of(Document& document) { return document.story.outside; }

Part look_text(const Document& document) {
  const OutsideView& outside = document.story.outside;
  if (outside.through_camera) return std::string(camera_key);
  return text_unless(std::string(enumerator_key(outside.preset)), "outside");
}

void parse_look(Document& document, std::string_view text) {
  OutsideView& outside = outside_of(document);
  outside.through_camera = text == camera_key;
  if (outside.through_camera) return;
  const auto preset = enumerator_named<SpacePreset>(text);
  if (!preset)
    throw InputError(fmt::format("look: found '{}', expected one of {} {}", text,
                                 fmt::join(enumerator_keys<SpacePreset>, " "), camera_key));
  outside.preset = *preset;
}

Part orbit_text(const Document& document) {
  const auto& orbit = document.story.outside.orbit;
  if (!orbit) return {};
  return number_list_text(
      std::array{orbit->pivot.x, orbit->pivot.y, orbit->pivot.z, orbit->yaw, orbit->pitch, orbit->distance});
}

void parse_orbit(Document& document, std::string_view text) {
  const auto numbers = parse_number_list(text, 6, "orbit");
  if (!(numbers[5] > 0))
    throw InputError(fmt::format("orbit: found a distance of {}, expected more than 0", numbers[5]));
  outside_of(document).orbit = SpaceOrbit{{numbers[0], numbers[1], numbers[2]}, numbers[3], numbers[4], numbers[5]};
}

Part vertex_text(const Document& document) {
  const auto& vertex = document.story.vertex;
  return vertex ? Part(fmt::format("{},{}", vertex->object, vertex->vertex)) : Part();
}

void parse_vertex(Document& document, std::string_view text) {
  const Vec2i numbers = parse_pixel_text(text);
  document.story.vertex = VertexId{numbers.x, numbers.y};
}

Part near_text(const Document& document) {
  const auto& near = document.story.vertex_edits.near;
  return near ? Part(fmt::format("{}", *near)) : Part();
}

void parse_order(Document& document, std::string_view text) {
  if (text != "move-then-turn")
    throw InputError(fmt::format("vertex-order: found '{}', expected move-then-turn", text));
  document.story.vertex_edits.order = ModelOrder::move_then_turn;
}

const std::vector<PermalinkField>& fields() {
  static const std::vector<PermalinkField> all{
      {"look", look_text, parse_look},
      {"orbit", orbit_text, parse_orbit},
      {"groups", [](const Document& d) { return text_unless(d.story.outside.switched, ""); },
       [](Document& d, std::string_view t) { outside_of(d).switched = t; }},
      {"least", [](const Document& d) { return number_unless(d.story.outside.least_contribution, 0); },
       [](Document& d, std::string_view t) { outside_of(d).least_contribution = parse_in_range(t, 0, 1, "least"); }},
      {"boxes",
       [](const Document& d) { return number_unless(d.story.outside.deepest_level, OutsideView{}.deepest_level); },
       [](Document& d, std::string_view t) { outside_of(d).deepest_level = parse_in_range(t, 0, 1000, "boxes"); }},
      {"until", [](const Document& d) { return d.story.until_event ? Part("event") : Part(); },
       [](Document& d, std::string_view t) {
         if (t != "event") throw InputError(fmt::format("until: found '{}', expected event", t));
         d.story.until_event = true;
       }},
      {"instance",
       [](const Document& d) {
         return d.story.listing_instance < 0 ? Part() : Part(fmt::format("{}", d.story.listing_instance));
       },
       [](Document& d, std::string_view t) { d.story.listing_instance = parse_whole(t, 0, most_events, "instance"); }},
      {"sample",
       [](const Document& d) {
         const auto& sample = d.story.sample;
         return sample ? Part(number_list_text(std::array{sample->x, sample->y})) : Part();
       },
       [](Document& d, std::string_view t) {
         const auto place = parse_number_list(t, 2, "sample");
         d.story.sample = Vec2d(place[0], place[1]);
       }},
      {"micro-triangle",
       [](const Document& d) {
         return d.story.micro_triangle < 0 ? Part() : Part(fmt::format("{}", d.story.micro_triangle));
       },
       [](Document& d, std::string_view t) {
         d.story.micro_triangle = parse_whole(t, 0, most_events, "micro-triangle");
       }},
      {"vertex", vertex_text, parse_vertex},
      {"vertex-order",
       [](const Document& d) {
         return d.story.vertex_edits.order == ModelOrder::turn_then_move ? Part() : Part("move-then-turn");
       },
       parse_order},
      {"vertex-near", near_text,
       [](Document& d, std::string_view t) {
         d.story.vertex_edits.near = parse_number_list(t, 1, "vertex-near").front();
       }},
  };
  return all;
}

}  // namespace

std::span<const PermalinkField> story_fields() { return fields(); }

}  // namespace ps::detail
