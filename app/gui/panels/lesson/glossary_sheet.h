#pragma once
#include <optional>
#include <string>

#include "engine/glossary.h"
#include "gui/panels/lesson/text_view.h"
#include "gui/panels/sheet.h"

namespace ps::gui {

/// The glossary over the window.
class GlossarySheet final : public Sheet {
 public:
  explicit GlossarySheet(const PanelHost& host) : Sheet(host, "glossary", {"Glossary", {760, 720}}) {}
  void add_actions(Actions& actions) override;
  void take(const PanelMessage& message) override;

 protected:
  /// A link of a definition that leads out of it also closes it.
  void draw_sheet() override;

 private:
  /// Opens it at this term, or at its begin if the term is empty.
  void show(const std::string& term);
  std::optional<LinkTarget> draw_entry(const GlossaryEntry& entry, float width);

  std::string search_;
  std::string term_;    ///< that is marked: what was followed here
  int scroll_for_ = 0;  ///< frames in which the marked term is still to be brought into view
};

}  // namespace ps::gui
