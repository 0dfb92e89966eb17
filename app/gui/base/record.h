#pragma once
#include <imgui.h>

#include <map>
#include <string>
#include <string_view>

namespace ps::gui {

/// What a control showed in the frame in which it was last drawn.
struct ControlRecord {
  ImVec2 min, max;            ///< rectangle in window pixels
  ImVec2 clip_min, clip_max;  ///< the visible part of its parent
  bool enabled = true;
  std::string value;  ///< what it shows, as text: "on", "0.001", "phong", the label of a button
  int frame = -1;     ///< ImGui's frame count
};

/// Every control of the window by name, for scripts and tests. Names are paths: "options/shadow-epsilon".
class ControlRecords {
 public:
  /// Called by the widgets (and by own drawing code that wants to be found) right after the item was submitted; uses
  /// ImGui's last item rectangle. Scrolls the item into view if that was asked for.
  void record(std::string_view name, std::string value, bool enabled = true);
  /// The same with an explicit rectangle.
  void record(std::string_view name, ImVec2 min, ImVec2 max, std::string value, bool enabled = true);
  /// The control, if it was drawn in the last finished frame or in this one.
  const ControlRecord* find(std::string_view name) const;
  bool visible(const ControlRecord& control) const;  ///< its middle is inside its parent's clip rectangle
  const std::map<std::string, ControlRecord, std::less<>>& all() const { return records_; }

  /// Scrolls the control into view when it is next drawn. Sections and tab rows whose content holds the name open.
  void reveal(std::string_view name) { reveal_ = name; }
  bool reveals(std::string_view name) const { return !reveal_.empty() && reveal_ == name; }
  const std::string& revealing() const { return reveal_; }
  void stop_revealing() { reveal_.clear(); }

 private:
  std::map<std::string, ControlRecord, std::less<>> records_;
  std::string reveal_;
};
ControlRecords& controls();

/// Puts "prefix/" before the names of the controls in its scope; scopes nest. Full names are the controls' ImGui ids
/// too.
class NameScope {
 public:
  explicit NameScope(std::string_view prefix);
  ~NameScope();
  NameScope(const NameScope&) = delete;
  NameScope& operator=(const NameScope&) = delete;
};
/// The full name of a control in the current scopes.
std::string full_name(std::string_view name);

}  // namespace ps::gui
