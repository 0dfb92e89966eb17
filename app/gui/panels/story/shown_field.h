#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gui/session/session.h"
#include "record/field_query.h"

namespace ps::gui {

/// Shows a number of the story for every pixel, in both pictures, so that they can be compared.
void show_field(Session& session, const FieldQuery& query);

/// The last item is a number that show_field() would show: it says so under the pointer, with its `exact` text, which
/// may be empty. Answers whether it was clicked.
bool number_to_show(std::string_view exact);

/// State of shown_field_bar().
struct ShownFieldState {
  std::string typed;                           ///< the condition
  std::shared_ptr<const RenderResult> result;  ///< the picture in which `count` pixels meet `condition`
  std::optional<FieldCondition> condition;
  std::size_t count = 0;
};

/// While a side shows such a number: what it is, a field for a condition that marks pixels, how many meet it, a way to
/// the next of them, and back to the colours.
void shown_field_bar(Session& session, Side side, ShownFieldState& state);

}  // namespace ps::gui
