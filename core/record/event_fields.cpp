#include "record/event_fields.h"

#include <fmt/format.h>

#include <algorithm>

#include "record/fields/fragment_fields.h"
#include "record/fields/ray_fields.h"
#include "record/fields/surface_fields.h"

namespace ps {
namespace {

template <class E>
using FieldList = fields::List<std::remove_cvref_t<E>>;

/// A member that no field shows would be missing in every table and file.
template <class Variant>
constexpr bool shows_all_members = false;
template <class... Events>
constexpr bool shows_all_members<std::variant<Events...>> =
    ((fields::members_shown<Events>() == fields::member_count<Events>()) && ...);
static_assert(shows_all_members<EventData>);

template <class E>
std::optional<FieldValue> value_in(const fields::Row<E>& row, const E& event) {
  return row.present && !row.present(event) ? std::nullopt : row.read(event);
}

/// The answers of every type of event, in the order of EventData's alternatives.
template <class Variant>
struct OfAll;
template <class... Events>
struct OfAll<std::variant<Events...>> {
  static constexpr std::array kinds{FieldList<Events>::kind...};
  static std::vector<std::string_view> keys(std::string_view kind) {
    std::vector<std::string_view> all;
    const auto add = [&]<class E>(const E*) {
      if (FieldList<E>::kind == kind)
        for (const auto& row : FieldList<E>::rows) all.push_back(row.key);
    };
    (add(static_cast<const Events*>(nullptr)), ...);
    return all;
  }
};

struct SubjectText {
  std::string operator()(std::int64_t v) const { return fmt::format(" {}", v); }
  std::string operator()(const std::string& v) const { return " " + v; }
  std::string operator()(const PixelId& v) const { return fmt::format(" {}/{}", v.object, v.triangle); }
  template <class Other>
  std::string operator()(const Other&) const {
    PS_ASSERT(false, "an event is about a number, a word or a primitive");
    return {};
  }
};

}  // namespace

std::string_view event_kind(const EventData& data) {
  return std::visit([](const auto& event) { return FieldList<decltype(event)>::kind; }, data);
}

std::vector<EventField> event_fields(const EventData& data) {
  return std::visit(
      [](const auto& event) {
        std::vector<EventField> all;
        for (const auto& row : FieldList<decltype(event)>::rows)
          if (auto value = value_in(row, event)) all.push_back({row.key, row.label, std::move(*value)});
        return all;
      },
      data);
}

std::optional<FieldValue> event_field(const EventData& data, std::string_view key) {
  return std::visit(
      [&](const auto& event) -> std::optional<FieldValue> {
        for (const auto& row : FieldList<decltype(event)>::rows)
          if (row.key == key) return value_in(row, event);
        return {};
      },
      data);
}

std::span<const std::string_view> event_kinds() { return OfAll<EventData>::kinds; }

std::size_t event_kind_place(std::string_view kind) {
  const auto kinds = event_kinds();
  return static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

std::vector<std::string_view> field_keys(std::string_view kind) { return OfAll<EventData>::keys(kind); }

std::string field_label(const EventField& field) {
  std::string label(field.label.empty() ? field.key : field.label);
  std::replace(label.begin(), label.end(), '-', ' ');
  return label;
}

std::string event_subject(const EventData& data) {
  return std::visit(
      [](const auto& event) {
        std::string text(FieldList<decltype(event)>::partners);
        for (const auto& row : FieldList<decltype(event)>::rows)
          if (row.role == FieldRole::subject)
            if (const auto value = value_in(row, event)) text += std::visit(SubjectText{}, *value);
        return text;
      },
      data);
}

}  // namespace ps
