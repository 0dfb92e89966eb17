#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gui/frame/panels.h"
#include "gui/frame/plan.h"

namespace ps::gui {

/// The regions of the window with the panels in them, as the document's mode and layout divide it. A lesson: its text,
/// the pictures, and below or beside these the tool that the step is about. Exploring: the bar of techniques, below it
/// the options if they are open, the pictures with a drawer of tools, and the pixel's story. A study: its tool at full
/// height beside small pictures. The presenter: pictures, and the lesson's text as a caption.
class Regions {
 public:
  /// All must outlive it.
  Regions(Session& session, Panels& panels)
      : session_(session), my_(panels), lessons_(panels.lessons.state), panels_(panels.all()) {}

  /// Draws all of it. `offers_first_look`: the offer to lead a newcomer round is below the pixel's story.
  void draw(const Area& area, bool offers_first_look);
  /// In the window's last line, below them: the buttons of the question for a line of the listing, where the listing
  /// has the place of the text. Returns its sentence, for the rest of that line; none without such a question.
  std::optional<std::string> question_in_line();
  /// How the offer was answered in this frame.
  bool first_look_answered() const { return answered_; }

 private:
  void filled(const Area& area);
  void lesson(const Area& area);
  void explore(const Area& whole);
  void study(const Area& area);
  void presenter(const Area& area);
  void left(const Area& area, bool has_options);
  void right(const Area& column, bool open);
  void drawer(const Area& area);
  bool tool(Panel& panel, const Context& context);
  void stage(const Area& area);
  void verdict_line(const Area& area);
  void ask_in_text();
  void question(bool pending);
  void lesson_text(const Area& area);
  void titled_text(const Area& area, const std::string& title);
  void column(const Area& area);
  bool column_head();
  void fill_with_stage();
  void choose_stage(float width, std::string_view shown);
  void pictures(const Area& area, double least_share, PictureCaptions captions,
                TwoPictures two = TwoPictures::may_share);
  Area first_look(const Area& area);
  /// A region with its heading, and the panel in it. `region` is its name in the document's layout.
  void panel_in(Panel& panel, std::string_view region, const Area& area);
  Panel& panel(std::string_view name) const { return find_panel(panels_, name); }
  /// The tool of a lesson's stage.
  Panel& staged() const;
  StagePlace stage_place() const;
  PlanInput plan_input(const Area& area, PictureCaptions captions) const;

  Session& session_;
  Panels& my_;
  LessonReading& lessons_;
  const PanelList& panels_;
  bool offers_first_look_ = false, answered_ = false, asks_in_line_ = false;
  float lesson_share_ = 0.6f;  ///< of the left region's height, while a lesson is open
};

}  // namespace ps::gui
