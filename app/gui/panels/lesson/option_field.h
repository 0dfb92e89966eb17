#pragma once
#include <string_view>
#include <vector>

#include "gui/session/session.h"
#include "options/option.h"

namespace ps::gui {

/// A live control of one side's option, as low as a line of text: the side's letter and the value, which changes as in
/// the options panel. Its name is "a/KEY" or "b/KEY". Drawn at the cursor.
void option_field(Session& session, Side side, const Option& option, float width);

/// The width that suits option_field(), window pixels.
float option_field_width(const Option& option);

}  // namespace ps::gui
