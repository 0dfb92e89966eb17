#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "record/events.h"

namespace ps {

/// The value of one field of an event, in the few shapes that all of them share.
using FieldValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, PixelId,
                                std::vector<Texel>, std::vector<bool>>;

struct EventField {
  std::string_view key;  ///< for files, in kebab-case; with spaces for dashes it is the label for people
  FieldValue value;
};

/// "ray", "sphere-test", "light", ...: one for each type of event.
std::string_view event_kind(const EventData& data);

/// All fields of an event in the order of its declaration; optional fields only where they are present. Tables in the
/// window and files are made from this list, so that both show the same.
std::vector<EventField> event_fields(const EventData& data);

}  // namespace ps
