#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "record/events.h"

namespace ps {

/// The value of one field of an event, in the few shapes that all of them share. Enumerators come as their keys.
using FieldValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, PixelId,
                                std::vector<Texel>, std::vector<bool>>;

enum class FieldRole {
  value,
  subject  ///< what the event is about: the primitive, the light, the kind of ray
};

struct EventField {
  std::string_view key;    ///< for files, in kebab-case
  std::string_view label;  ///< for people, where it is not the key with spaces for dashes; else empty
  FieldValue value;
};

/// "ray", "sphere-test", "light", ...: one for each type of event.
std::string_view event_kind(const EventData& data);

/// All fields of an event in the order in which record/fields/ declares them; optional fields only where they are
/// present. Tables in the window and files are made from this list, so that both show the same.
std::vector<EventField> event_fields(const EventData& data);

/// One of them; absent where this event has none of that key.
std::optional<FieldValue> event_field(const EventData& data, std::string_view key);

/// The kinds of events, in the order of EventData's alternatives, and where one of them stands there: at their number
/// for a kind that is not among them.
std::span<const std::string_view> event_kinds();
std::size_t event_kind_place(std::string_view kind);

/// The keys of the fields that events of a kind can have; empty for a kind that is not among them.
std::vector<std::string_view> field_keys(std::string_view kind);

/// The name of a field for people: "shading normal".
std::string field_label(const EventField& field);

/// The subject of the event: events with equal texts can be partners when two stories are side by side. Never for
/// people.
std::string event_subject(const EventData& data);

}  // namespace ps
