#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/event_fields.h"

namespace ps {

/// The kind of a query about the lines of a listing.
constexpr std::string_view listing_line = "listing-line";

/// One number of a pixel's story, or one that a line of a listing had in the work for the pixel, so named that other
/// pixels have it too: "hit: t", "light 1: n-dot-l", "reflection > hit: point.2", "listing-line 28 sphere red:
/// discriminant".
struct FieldQuery {
  std::vector<RayKind> path;  ///< the rays below the eye ray in which it is reported
  std::string kind;           ///< of the event: "light"; or listing_line
  std::string subject;        ///< what the event is about: "1" of light 1; empty = whatever it is. Of a line its number
                              ///< and the innermost loop around it in the pixel's work: "28 sphere red"
  int order = 0;              ///< how many such events are passed over; of a rasterizer's, within the fragment
  std::string key;            ///< of the field: "n-dot-l"
  int component = -1;         ///< of a vector; -1 = the number itself, a vector's length, an object's index
  bool operator==(const FieldQuery&) const = default;
  bool of_listing() const { return kind == listing_line; }
};

/// The query for a field of an event of a story; absent where the field holds a word or a list, or where the event is
/// not one that each pixel reports for itself.
std::optional<FieldQuery> field_query(const std::vector<Event>& events, int event, std::string_view key,
                                      int component = -1);

/// "reflection > light 1 #2: n-dot-l"; parse_field_query() reads it back, and throws InputError that says what it
/// found.
std::string field_query_text(const FieldQuery& query);
FieldQuery parse_field_query(std::string_view text);

/// For people: "n dot l of light 1, reflected ray".
std::string field_query_words(const FieldQuery& query);

/// Is this the kind of event, on the way `path`, and the subject, that is asked for?
bool matches(const FieldQuery& query, const EventData& data);

/// The number itself, a component of a vector (-1: its length), the object's index; absent for words and lists.
std::optional<double> number_in(const FieldValue& value, int component);

/// The number that the event has there; absent where it has none.
std::optional<double> field_number(const FieldQuery& query, const EventData& data);

/// The number of a story that a query asks for, as a picture of that number shows it: of a rasterizer's fragments that
/// of the one that is seen. Absent where the story has no such event or number. Queries about lines of a listing have
/// none.
std::optional<double> number_of_story(const std::vector<Event>& events, const FieldQuery& query);

/// Does the fragment reach the picture? One that does not, hides all that it reports from a query.
inline bool is_drawn(const FragmentEvent& fragment) {
  return fragment.depth != FragmentEvent::Depth::failed && fragment.pass != FragmentEvent::Pass::depth_first;
}

/// "< 0.001": marks the pixels whose number meets it.
struct FieldCondition {
  enum class Relation { below, above, equal } relation = Relation::below;
  double bound = 0;
  bool operator==(const FieldCondition&) const = default;
  /// NaN meets no condition.
  bool met_by(double value) const;
};
/// "< 0.001", "> 1" or "= 3". Throws InputError for anything else.
FieldCondition parse_field_condition(std::string_view text);
std::string field_condition_text(const FieldCondition& condition);

/// The number that a picture shows, and the pixels that it marks.
struct ShownField {
  FieldQuery query;
  std::optional<FieldCondition> condition;
  bool operator==(const ShownField&) const = default;
};

}  // namespace ps
