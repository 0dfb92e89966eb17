#pragma once
#include <optional>
#include <string>

#include "gui/session/session.h"
#include "record/field_query.h"

namespace ps::gui {

/// Shows a number of the story for every pixel, in both pictures, so that they can be compared.
void show_field(Session& session, const FieldQuery& query);

/// While a side shows such a number: what it is, a field for a condition that marks pixels, how many meet it, a way to
/// the next of them, and back to the colours. `condition` is what is typed.
void shown_field_bar(Session& session, Side side, std::string& condition);

}  // namespace ps::gui
