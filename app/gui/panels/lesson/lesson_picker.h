#pragma once
#include <optional>
#include <string>

#include "engine/lesson_search.h"
#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/sheet.h"
#include "gui/widgets/overlay.h"
#include "gui/work/thumbnails.h"

namespace ps::gui {

/// All lessons over the whole window, as pictures, and a search in their texts.
class LessonPicker final : public Sheet {
 public:
  LessonPicker(const PanelHost& host, const ReadLessons& read)
      : Sheet(host, "picker", {"", whole_window}), read_(read), thumbnails_(host.wake) {}
  /// Opens it with the open lesson selected.
  void show();
  void add_actions(Actions& actions) override;
  void offer(Values& out) override;
  bool busy() const override { return open_ && thumbnails_.busy(); }

 protected:
  /// A click, or Enter for the selected one, opens a lesson or the step that was found.
  void draw_sheet() override;

 private:
  /// Where a click or Enter leads.
  using Chosen = std::optional<LessonPlace>;
  Chosen lesson_tiles();
  Chosen hit_rows();
  std::string found_text() const;
  void help_with_query();
  void follow_query();
  void title_row();

  const ReadLessons& read_;
  std::string search_, searched_;  ///< as it is typed, and what `found_` was found for
  LessonHits found_;
  int selected_ = 0;  ///< of the pictures, or of the hits
  Thumbnails thumbnails_;
};

}  // namespace ps::gui
