#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <variant>

#include "engine/text.h"
#include "gui/base/sides.h"
#include "options/option.h"

namespace ps::gui {

// Requests of panels to each other and to the window around them. Each is taken by whom it concerns.

/// A tool is to be shown; where the window is divided for something else, it changes its mode if that is asked for.
struct ShowTool {
  std::string_view name;
  enum class Room { as_there_is, made } room = Room::made;
};
/// The window is to be divided for this purpose.
struct SetMode {
  ScreenMode mode = ScreenMode::explore;
};
/// The options are to be shown.
struct ShowOptions {};
/// An option's row is to come into sight, highlighted.
struct PointAtOption {
  const Option* option = nullptr;
};
/// The chart is to vary this option alone.
struct SweepOption {
  const Option* option = nullptr;
  Side side = Side::a;
};
/// The laboratory is to show this experiment.
struct ShowExperiment {
  std::string key;
};
/// A click on a link in a lesson's text.
struct LinkTarget {
  TextLink link;        ///< or, if that is none,
  std::string control;  ///< the control of this name
};
/// A drawing is to be saved; `svg` makes it when the file is known.
struct SaveDrawing {
  std::string title, suggestion;
  std::function<std::string()> svg;
};

using PanelMessage =
    std::variant<ShowTool, SetMode, ShowOptions, PointAtOption, SweepOption, ShowExperiment, LinkTarget, SaveDrawing>;

}  // namespace ps::gui
