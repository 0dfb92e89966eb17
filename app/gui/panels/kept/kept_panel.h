#pragma once
#include <string>
#include <vector>

#include "gui/panels/kept/kept_list.h"
#include "gui/panels/sheet.h"

namespace ps::gui {

/// Named sets of options and named screens, kept from one start to the next: a list with buttons to use and to delete
/// them, and fields for new names.
class KeptPanel final : public Sheet {
 public:
  explicit KeptPanel(const PanelHost& host);
  void add_actions(Actions& actions) override;
  void add_entries(std::vector<PaletteEntry>& entries) override;

 protected:
  bool has_subject() override { return session_.has_scene(); }
  void draw_sheet() override;

 private:
  void presets();
  void bookmarks();
  void keep_preset(Side side);
  void keep_bookmark();

  std::vector<KeptEntry> presets_;    ///< options that are not at their defaults, "key=value" with blanks between them
  std::vector<KeptEntry> bookmarks_;  ///< permalinks
  std::string preset_name_, bookmark_name_;  ///< being typed
};

}  // namespace ps::gui
