#pragma once
#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace ps::gui {

/// Finds the parts of a frame that do not fit: text that is cut off, and controls that lie over each other. It knows
/// every control that is recorded for scripts (record.h), and every text that the widgets draw into a rectangle.
class FitWatch {
 public:
  /// A control was drawn here; the rest of it is clipped away. Called by ControlRecords.
  void placed(const std::string& name, ImVec2 min, ImVec2 max, ImVec2 clip_min, ImVec2 clip_max);
  /// A text was shortened in the middle of a word because it did not fit its rectangle. Called by what draws text.
  void shortened(ImVec2 min, ImVec2 max, std::string_view text);

  /// Names of the controls of the last finished frame whose text is shortened, or that are partly out of sight where
  /// nothing can be scrolled: joined with "; ", empty if there are none.
  std::string cut() const;
  /// Pairs of controls that overlap, "a and b; c and d". What lies over a picture by intention, parts of the same
  /// control, and lists that drop down do not count.
  std::string overlap() const;

 private:
  struct Control {
    std::string name;
    ImVec2 min, max;            ///< window pixels
    ImVec2 seen_min, seen_max;  ///< the part that is not clipped away
    const void* layer;          ///< controls of different layers may overlap: lists, dialogs
    bool cut;
  };
  struct Text {
    ImVec2 min, max;
    std::string text;
  };
  struct Frame {
    int number = -1;
    std::vector<Control> controls;
    std::vector<Text> texts;
  };
  Frame& now();
  const Frame& finished() const;
  Frame now_, before_;
};
FitWatch& fit_watch();

}  // namespace ps::gui
