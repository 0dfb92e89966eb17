#pragma once
#include <map>
#include <string>

#include "gui/panels/sheet.h"
#include "gui/platform/texture.h"
#include "scene/notation.h"

namespace ps::gui {

/// The notation of scene files over the window: each construct with its picture, example and fields.
class NotationSheet final : public Sheet {
 public:
  explicit NotationSheet(const PanelHost& host) : Sheet(host, "notation", {"Scene notation", {980, 820}}) {}
  void add_actions(Actions& actions) override;

 protected:
  void draw_sheet() override;

 private:
  void read_page();
  void draw_part(const NotationPart& part);
  void draw_fields(const NotationPart& part);

  std::string search_;
  Notation page_;      ///< empty until it is opened
  std::string fault_;  ///< what is wrong with the page
  std::map<std::string, Texture> pictures_;
};

}  // namespace ps::gui
