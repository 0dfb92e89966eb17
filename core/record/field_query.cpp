#include "record/field_query.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"
#include "base/enumerators.h"
#include "base/number_text.h"
#include "base/word_search.h"

namespace ps {
namespace {

/// Events that a pixel has once, whatever they are about: their subjects say what was found, not what was asked.
constexpr std::array<std::string_view, 3> outcomes{"hit", "fragment", "write"};
/// Events that are about the pixel's place among others, or that kernels report for one pixel alone.
constexpr std::array<std::string_view, 8> unshared{"reject", "pixel",   "compare", "reuse",
                                                   "sample", "polygon", "line",    "stencil"};

template <std::size_t N>
bool is_among(const std::array<std::string_view, N>& kinds, std::string_view kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

/// The subject of an event without its kind: "1" of light 1.
std::string subject_of(const EventData& data) {
  if (is_among(outcomes, event_kind(data))) return {};
  const std::string text = event_subject(data);
  const auto space = text.find(' ');
  return space == std::string::npos ? std::string() : text.substr(space + 1);
}

/// The rays around an event, the eye ray left out, and the fragment that it belongs to (-1: none).
struct Place {
  std::vector<RayKind> path;
  int fragment = -1;
  bool operator==(const Place&) const = default;
};
Place place_of(const std::vector<Event>& events, int event) {
  Place place;
  for (int at = events[static_cast<std::size_t>(event)].parent; at >= 0;
       at = events[static_cast<std::size_t>(at)].parent) {
    const EventData& data = events[static_cast<std::size_t>(at)].data;
    if (const auto* ray = std::get_if<RayEvent>(&data); ray && ray->kind != RayKind::eye)
      place.path.insert(place.path.begin(), ray->kind);
    if (std::holds_alternative<FragmentEvent>(data)) place.fragment = at;
  }
  return place;
}

struct Number {
  int component;
  std::optional<double> operator()(bool v) const { return v ? 1 : 0; }
  std::optional<double> operator()(std::int64_t v) const { return static_cast<double>(v); }
  std::optional<double> operator()(double v) const { return v; }
  std::optional<double> operator()(const PixelId& v) const { return v.object; }
  std::optional<double> operator()(const std::vector<double>& v) const {
    if (component >= 0)
      return static_cast<std::size_t>(component) < v.size() ? std::optional(v[static_cast<std::size_t>(component)])
                                                            : std::nullopt;
    double sum = 0;
    for (const double part : v) sum += part * part;
    return std::sqrt(sum);
  }
  template <class Other>
  std::optional<double> operator()(const Other&) const {
    return {};
  }
};

RayKind parse_ray(std::string_view text) {
  if (const auto kind = enumerator_named<RayKind>(text); kind && *kind != RayKind::eye) return *kind;
  throw InputError(fmt::format("field: found the ray '{}', expected shadow, reflection or refraction", text));
}

}  // namespace

std::optional<double> number_in(const FieldValue& value, int component) { return std::visit(Number{component}, value); }

bool matches(const FieldQuery& query, const EventData& data) {
  return event_kind(data) == query.kind && (query.subject.empty() || subject_of(data) == query.subject);
}

std::optional<double> field_number(const FieldQuery& query, const EventData& data) {
  const auto value = event_field(data, query.key);
  return value ? number_in(*value, query.component) : std::nullopt;
}

std::optional<FieldQuery> field_query(const std::vector<Event>& events, int event, std::string_view key,
                                      int component) {
  const EventData& data = events[static_cast<std::size_t>(event)].data;
  FieldQuery query;
  query.kind = event_kind(data);
  query.subject = subject_of(data);
  query.key = key;
  query.component = component;
  if (is_among(unshared, query.kind) || !field_number(query, data)) return {};
  const Place place = place_of(events, event);
  query.path = place.path;
  for (int i = 0; i < event; ++i)
    if (matches(query, events[static_cast<std::size_t>(i)].data) && place_of(events, i) == place) ++query.order;
  if (query.kind == "fragment") query.order = 0;  // the one that is seen, whichever of the story's it is
  return query;
}

std::optional<double> number_of_story(const std::vector<Event>& events, const FieldQuery& query) {
  int seen = -1;
  for (int i = 0; i < static_cast<int>(events.size()); ++i)
    if (const auto* fragment = std::get_if<FragmentEvent>(&events[static_cast<std::size_t>(i)].data))
      if (is_drawn(*fragment)) seen = i;
  int passed = 0;
  for (int i = 0; i < static_cast<int>(events.size()); ++i) {
    const EventData& data = events[static_cast<std::size_t>(i)].data;
    if (!matches(query, data)) continue;
    const Place place = place_of(events, i);
    const int fragment = std::holds_alternative<FragmentEvent>(data) ? i : place.fragment;
    if (place.path != query.path || (fragment >= 0 && fragment != seen)) continue;
    if (passed++ == query.order) return field_number(query, data);
  }
  return {};
}

std::string field_query_text(const FieldQuery& query) {
  std::string text;
  for (const RayKind ray : query.path) text += fmt::format("{} > ", enumerator_key(ray));
  text += query.kind;
  if (!query.subject.empty()) text += " " + query.subject;
  if (query.order > 0) text += fmt::format(" #{}", query.order);
  text += ": " + query.key;
  if (query.component >= 0) text += fmt::format(".{}", query.component);
  return text;
}

FieldQuery parse_field_query(std::string_view text) {
  FieldQuery query;
  const std::string whole(text);
  const auto colon = text.rfind(':');
  if (colon == std::string_view::npos)
    throw InputError(
        fmt::format("field: found '{}', expected an event and one of its numbers, such as 'hit: t'", whole));
  std::string_view field = trimmed(text.substr(colon + 1)), event = text.substr(0, colon);
  for (auto arrow = event.find('>'); arrow != std::string_view::npos; arrow = event.find('>')) {
    query.path.push_back(parse_ray(trimmed(event.substr(0, arrow))));
    event.remove_prefix(arrow + 1);
  }
  if (const auto hash = event.rfind('#'); hash != std::string_view::npos) {
    const auto order = parse_integer<int>(trimmed(event.substr(hash + 1)));
    if (!order || *order < 0) throw InputError(fmt::format("field: '{}' has no whole number after its #", whole));
    query.order = *order;
    event = event.substr(0, hash);
  }
  event = trimmed(event);
  const auto space = event.find(' ');
  query.kind = event.substr(0, space);
  if (space != std::string_view::npos) query.subject = trimmed(event.substr(space));
  if (const auto dot = field.rfind('.'); dot != std::string_view::npos) {
    const auto component = parse_integer<int>(field.substr(dot + 1));
    const bool found = component && *component >= 0 && *component <= 2;
    // The name of a listing's value may have a point: "N . L".
    if (!found && !query.of_listing())
      throw InputError(fmt::format("field: '{}' has no 0, 1 or 2 after its last point", whole));
    if (found) query.component = *component;
    if (found) field = field.substr(0, dot);
  }
  query.key = field;
  if (query.of_listing()) {
    std::string_view line = query.subject;
    if (!take_integer<int>(line) || !query.path.empty() || query.key.empty())
      throw InputError(fmt::format(
          "field: found '{}', expected a line of a listing and a value, such as 'listing-line 28: discriminant'",
          whole));
    return query;
  }
  const auto keys = field_keys(query.kind);
  if (keys.empty() || is_among(unshared, query.kind))
    throw InputError(
        fmt::format("field: found the event '{}', expected one of: {}", query.kind, fmt::join(event_kinds(), " ")));
  if (std::find(keys.begin(), keys.end(), query.key) == keys.end())
    throw InputError(fmt::format("field: '{}' has no '{}'; it has: {}", query.kind, query.key, fmt::join(keys, " ")));
  return query;
}

std::string field_query_words(const FieldQuery& query) {
  std::string key = query.key;
  std::replace(key.begin(), key.end(), '-', ' ');
  if (query.component >= 0) key += fmt::format(" {}", "xyz"[std::min(query.component, 2)]);
  if (query.of_listing()) {
    const auto space = query.subject.find(' ');
    const std::string within = space == std::string::npos ? "" : ", " + query.subject.substr(space + 1);
    const std::string again = query.order > 0 ? fmt::format(", time {}", query.order + 1) : "";
    return fmt::format("{} in the listing{}{}", key, within, again);
  }
  std::string words = fmt::format("{} of {}{}{}", key, query.kind, query.subject.empty() ? "" : " ", query.subject);
  for (const RayKind ray : query.path) words += fmt::format(", {} ray", enumerator_key(ray));
  if (query.order > 0) words += fmt::format(", number {}", query.order + 1);
  return words;
}

bool FieldCondition::met_by(double value) const {
  switch (relation) {
  case Relation::below:
    return value < bound;
  case Relation::above:
    return value > bound;
  case Relation::equal:
    return value == bound;
  }
  return false;
}

FieldCondition parse_field_condition(std::string_view text) {
  constexpr std::string_view signs = "<>=";
  const std::string_view given = trimmed(text);
  const auto sign = given.empty() ? std::string_view::npos : signs.find(given[0]);
  const auto bound = given.empty() ? std::nullopt : parse_number(trimmed(given.substr(1)));
  if (sign == std::string_view::npos || !bound)
    throw InputError(fmt::format("condition: found '{}', expected <, > or = and a number, such as '< 0.001'", text));
  return {static_cast<FieldCondition::Relation>(sign), *bound};
}

std::string field_condition_text(const FieldCondition& condition) {
  return fmt::format("{} {}", "<>="[static_cast<std::size_t>(condition.relation)], condition.bound);
}

}  // namespace ps
