#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "document/document.h"
#include "gui/base/record.h"
#include "gui/theme/theme.h"
#include "options/option.h"
#include "options/waking.h"

/// Controls of the window. Each has a name (a stable path, prefixed by the NameScopes around it) under which scripts
/// find it, records what it shows, and fills the width given to it. None keeps state of the document.

namespace ps::gui {

class Actions;

/// What most controls share.
struct ControlStyle {
  std::string_view tooltip = {};   ///< what it does; wrapped
  std::string_view disabled = {};  ///< not empty: greyed, and this reason is shown in the tooltip
  float width = 0;                 ///< 0 = as wide as its text (buttons) or the space that is left (others)
  /// Why a choice cannot act now, or nothing, by its place. Of a list that is closed only the chosen one is asked.
  std::function<std::string(std::size_t)> idle = {};
  std::string_view shown = {};  ///< not empty: written in place of the value
};

// --- text.cpp ---
struct TextForm {
  std::optional<Face> face = {};  ///< none: the present one
  bool quiet = false;             ///< in the colour of what explains
};
/// Texts look so in its scope.
class TextScope {
 public:
  explicit TextScope(const TextForm& form);
  ~TextScope();
  TextScope(const TextScope&) = delete;
  TextScope& operator=(const TextScope&) = delete;

 private:
  FontScope font_;
};
/// Text as it is, as an item; `value_text` records it under its name for scripts.
void show_text(std::string_view text, const TextForm& form = {});
void value_text(std::string_view name, std::string_view text, const TextForm& form = {});
/// The same broken into lines where the room ends.
void show_paragraph(std::string_view text, const TextForm& form = {});
void value_paragraph(std::string_view name, std::string_view text, const TextForm& form = {});
/// A paragraph in the quiet colour, for what explains.
void quiet_text(std::string_view text);

// --- buttons.cpp ---
enum class Emphasis { plain, primary, quiet };
bool button(std::string_view name, std::string_view label, Emphasis emphasis = Emphasis::plain,
            const ControlStyle& style = {});
/// The width that a button with this label takes.
float button_width(std::string_view label);
/// Goes on in the same line if something this wide has room there; `spacing` as in ImGui::SameLine.
void same_line_if_room(float width, float spacing = -1);
/// A button that shows a state, such as a tool that is chosen.
bool button_on_off(std::string_view name, std::string_view label, bool on, const ControlStyle& style = {});
/// Ends the toolbar of a tool: shows it in the whole window, or does so no longer. Answers whether it was clicked.
bool fill_button(bool filled, std::string_view help);
/// Before it, where there is something to save so.
void svg_button(const std::function<void()>& save);
/// A box to tick with its label to the right; the value reads "on" or "off".
bool toggle(std::string_view name, std::string_view label, bool& value, const ControlStyle& style = {});
/// One of a few words side by side if they fit the width, else a drop-down. Answers whether `index` changed.
bool choice(std::string_view name, std::span<const Choice> choices, int& index, const ControlStyle& style = {});
/// choice() among the values of an enumeration, in their order.
template <class Value>
bool choice_of(std::string_view name, std::span<const Choice> choices, Value& value, const ControlStyle& style = {}) {
  int index = static_cast<int>(value);
  if (!choice(name, choices, index, style)) return false;
  value = static_cast<Value>(index);
  return true;
}
/// Tabs in a row; the open one is underlined. Value: the key of the open one. `keys` are used as names below `name`.
bool tab_row(std::string_view name, std::span<const Choice> tabs, int& index);
/// A heading that opens and closes what follows it.
bool section(std::string_view name, std::string_view label, bool& open, std::string_view note = {});
/// An item of an ImGui menu, with its key at the right.
bool menu_item(std::string_view name, std::string_view label, std::string_view keys = {}, bool checked = false,
               std::string_view disabled = {});
/// How much of the label "Gizmo: move, turn and scale the picked object" an item shows: all of it, or "Gizmo", and all
/// in a tooltip.
enum class MenuLabel { whole, name };
/// The menu item of an action, named by it; runs it when clicked.
void menu_action(const Actions& actions, std::string_view action, MenuLabel label = MenuLabel::whole);
bool begin_menu(std::string_view name, std::string_view label);  ///< if true, call end_menu()
void end_menu();

// --- number.cpp ---
struct NumberRange {
  double minimum = 0, maximum = 1;
  OptionScale scale = OptionScale::linear;
  bool integer = false;
  std::string_view unit = {};
};
/// How an edit went this frame. A drag changes the value many times and finishes once: undo takes the last.
struct Edit {
  bool changed = false;
  bool finished = false;  ///< the gesture is over; true in the same frame as `changed` for clicks and wheel steps
};
/// Scrubbed by dragging, stepped by the wheel (while hovered with Ctrl off), typed into after Ctrl-click or double
/// click.
Edit number(std::string_view name, double& value, const NumberRange& range, const ControlStyle& style = {});
/// Four significant digits ("0.001", "1234", "1.235e-06").
std::string short_number(double value);
/// Digits that read back exactly.
std::string full_number(double value);
/// Right-aligned monospaced number in the current table cell or up to `width`; the tooltip has full precision.
void number_text(double value, float width = 0);
void number_text(std::string_view digits, float width, std::string_view full);

// --- option_parts.cpp, option_pair.cpp ---
enum class OptionRequest { none, send_to_other, only_difference, sweep, wake };
struct OptionRowResult {
  Edit edit;
  OptionRequest request = OptionRequest::none;  ///< chosen from the right-click menu, or the button of a grey row
  Waking waking;                                ///< what a grey row needs
};
struct OptionRowContext {
  Side side = Side::a;
  const Settings* other = nullptr;  ///< the other side's settings, to mark differences
};

// --- section.cpp ---
/// A row of a tree, as many lines high as its text needs. If it answers `open`, draw the children and call
/// ImGui::TreePop(). Leaves never open. `icon_room` is left free in front of the text.
struct TreeRow {
  bool open = false, clicked = false;
};
enum class TreeKind { branch, leaf };
TreeRow tree_row(std::string_view name, std::string_view text, TreeKind kind, bool selected, bool default_open = true,
                 float icon_room = 0);
/// Begins a table whose rows have a text and then numbers, which end at the right ends of their columns; if it answers
/// so, fill it and call ImGui::EndTable().
struct NumberColumns {
  float text = 0;     ///< 0 = what the numbers leave
  float numbers = 0;  ///< of each
  float all = 0;      ///< of the table; 0 = what is left
};
bool begin_numbers(const char* id, int numbers, const NumberColumns& widths);
/// Begins a row of it.
void numbers_row(std::string_view text);
/// The next cell of the row; the tooltip has the full precision.
void number_cell(std::string_view digits, std::string_view full);
/// A row of a list as wide as the room that is left, or as `size` says, with a ground while it is selected or under the
/// pointer. What it shows is drawn over it by the caller, who records it as well.
bool list_row(std::string_view name, ImVec2 size, bool selected);
/// A field to type a filter into, with a clear button.
bool search_box(std::string_view name, std::string& text, std::string_view hint, const ControlStyle& style = {});

// --- feedback.cpp ---
/// Tooltip for the last item, after a short rest of the pointer, wrapped at about 40 em.
void tooltip(std::string_view text);
/// A key was pressed: the tooltip goes, until the pointer moves.
void hide_tooltip();
/// Whether one was seen in the last frame.
bool tooltip_visible();
/// Its right edge in window pixels; 0 while there is none.
double tooltip_end();
/// A tooltip that draws itself.
bool begin_tooltip();             ///< for the last item; if true, call end_tooltip()
void begin_tooltip_at_pointer();  ///< at once, for a part of a drawing; call end_tooltip()
void end_tooltip();
/// Fraction in [0, 1] with a label, or negative if unknown; returns whether Cancel was clicked (name/cancel).
bool progress_bar(std::string_view name, std::string_view label, double fraction, float width = 0);
enum class MessageKind { information, warning, error };
/// One line across the width: a mark, the text, and a button that dismisses it (name/dismiss). True = dismissed.
bool message_bar(std::string_view name, MessageKind kind, std::string_view text);
enum class SplitterAxis { left_right, up_down };
/// A draggable line of length `length` at the cursor. Adds the movement in pixels to `position`, kept in the range.
Edit splitter(std::string_view name, SplitterAxis axis, float length, float& position, float minimum, float maximum);

/// Keeps what is drawn inside it greyed and dead.
class DisabledScope {
 public:
  explicit DisabledScope(bool disabled) : disabled_(disabled) {
    if (disabled_) ImGui::BeginDisabled();
  }
  ~DisabledScope() {
    if (disabled_) ImGui::EndDisabled();
  }
  DisabledScope(const DisabledScope&) = delete;
  DisabledScope& operator=(const DisabledScope&) = delete;

 private:
  bool disabled_;
};

}  // namespace ps::gui
