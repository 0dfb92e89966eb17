#pragma once
#include <memory>
#include <string>
#include <vector>

#include "gui/panels/lesson/lesson_panel.h"
#include "gui/panels/lesson/text_layout.h"

namespace ps::gui {

/// The open step as an audience reads it, in letters that are read from the last row: its text, a few whole sentences
/// at a time, then its question with the choices, and once that is revealed the answer and what to look for.
class CaptionStrip {
 public:
  /// Lays out the page that is shown, in lines of this width. Without an open lesson there is none.
  CaptionStrip(const Session& session, LessonReading& state, float width);
  /// With its margins, window pixels; 0 without a lesson.
  float height() const;
  /// In the room that there is.
  void draw(Session& session);
  /// The figure of the page that is shown, for the picked pixel, or nullptr.
  const Figure* figure() const { return figure_.get(); }

 private:
  struct Part {
    TextBlock block;
    std::string mark;
  };
  struct Page {
    std::vector<Part> parts;
    bool asks = false;
  };

  std::vector<TextLine> lines_of(const Page& page) const;
  float height_of(const Page& page) const;
  void add_text(const TextBlock& block, const std::string& mark);
  void add_question(const LessonQuestion& question);

  LessonReading& state_;
  const Lesson* lesson_;
  int step_ = 0;
  float width_;
  std::vector<Page> pages_;
  std::shared_ptr<const Figure> figure_;
};

/// A figure for the last row, as large as the room of the present region lets it be.
void draw_projected_figure(const Figure& figure);

}  // namespace ps::gui
