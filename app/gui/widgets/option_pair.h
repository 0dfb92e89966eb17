#pragma once
#include <array>

#include "gui/widgets/widgets.h"

namespace ps::gui {

struct OptionPairContext {
  Side picked = Side::a;  ///< the picture that the row follows: its cell is a field, the other one is quiet
  bool highlight = false;
  std::string_view b_has_none{};  ///< not empty: B has no options, for this reason; its cells are empty
};

/// A row of the table of both pictures' options: the label, and below it (beside it where there is room) the values of
/// A and of B in full words. Where they are equal the picture that is not picked shows "= Phong". A row whose values
/// differ is marked. A side that cannot act is grey, and a line says what it needs, with a button that sets it.
/// Controls are named a/KEY and b/KEY.
std::array<OptionRowResult, 2> option_pair(const Option& option, std::array<Settings, 2>& settings,
                                           const SceneTraits& traits, const OptionPairContext& context);

/// Where the columns of a table this wide begin, from its left edge, and how wide each is.
struct OptionColumns {
  bool beside_label = false;  ///< the values have their label's line
  float a = 0, b = 0, width = 0;
};
OptionColumns option_columns(float room);

}  // namespace ps::gui
