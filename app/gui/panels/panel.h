#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "gui/base/file_question.h"
#include "gui/base/values.h"
#include "gui/input/actions.h"

namespace ps::gui {

/// Services of the window for its panels.
struct PanelHost {
  /// Puts text on the clipboard and shows `said`.
  std::function<void(const std::string& text, const std::string& said)> copy;
  std::function<void(FileQuestion question)> ask_file;
};

/// With what a panel is drawn.
struct Context {
  bool filled = false;  ///< the panel has the window for itself
  bool headed = false;  ///< what its `head` draws is in the line above it
};

/// The height that a tool needs: a strip below the pictures, or the height of one of them.
enum class PanelHeight { strip, tall };

/// The subject of a tool: the picked pixel, or all of the pictures, for which it may work long.
enum class PanelUse { pixel, study };

/// The tab below the pictures under which a tool is shown.
enum class ToolGroup { pixel, pixels, measure, stability };

/// Where a panel has its place.
enum class PanelPlace { left, right, below };

/// A part of the window: how it is called, what it draws, and what it has for keys, scripts and the background. All
/// functions but draw() may be empty.
struct Panel {
  std::string_view name;  ///< stable: of the document's layout, of scripts
  PanelPlace place = PanelPlace::below;
  PanelUse use = PanelUse::pixel;
  ToolGroup group = ToolGroup::pixel;
  PanelHeight height = PanelHeight::strip;
  std::string_view heading, brief;  ///< brief where there is little room
  std::string_view command;         ///< in menus and the palette
  std::string_view help;            ///< one sentence
  /// Answers whether the panel shall fill the window, or no longer.
  std::function<bool(const Context&)> draw = {};
  /// Draws the controls that have room in its title bar, where the panel needs all of the height below; answers
  /// like `draw`.
  std::function<bool()> head = {};
  std::function<void(Actions&)> actions = {};
  std::function<void(Values&)> publish = {};
  std::function<void()> update = {};         ///< once a frame, shown or not, in any order
  std::function<bool()> busy = {};           ///< work is going on, or has come and was not taken up
  std::function<std::string()> status = {};  ///< long work, for the line at the lower edge; empty if there is none
};

}  // namespace ps::gui
