#pragma once
#include <string_view>

#include "gui/widgets/draw.h"
#include "options/waking.h"

/// What the rows of one picture's options and of both pictures' options are made of.
namespace ps::gui {

/// The option's help, its value and why it cannot act, for the last item.
void option_tooltip(const Option& option, const Settings& settings, const OptionRowContext& context,
                    std::string_view reason);
/// The menu of a right click, if `popup` is open. Its entries are named below KEY/menu.
OptionRequest option_menu(const char* popup, const Option& option, Settings& settings, const OptionRowContext& context,
                          Edit& edit);
/// The control for an option's kind, named by its key; choices are a list that drops down. In a cell of the table, what
/// is on or off says so, and units are left to the label.
enum class ControlPlace { in_text, in_cell };
Edit option_control(const Option& option, Settings& settings, const ControlStyle& style, ControlPlace place,
                    const FieldLook& field = {});
/// Around a row that something points at.
void attention_ring(ImVec2 min, ImVec2 max);
/// A round arrow, for a row that is not at its default. Answers whether it was clicked.
bool reset_button(const Option& option, float size);
/// Lines in small print: what an option that cannot act needs, and a button for each of `sides` that sets it, named
/// KEY/wake in its side's scope. Answers the side whose button was clicked.
std::optional<Side> need_lines(const Option& option, const Waking& waking, std::span<const Side> sides,
                               std::string_view prefix, float width);
/// The height that need_lines() takes.
float need_lines_height(const Waking& waking, std::span<const Side> sides, std::string_view prefix, float width);

}  // namespace ps::gui
