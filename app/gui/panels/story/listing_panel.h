#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gui/panels/lesson/lesson_question.h"
#include "gui/panels/panel.h"
#include "gui/panels/story/listing_marks.h"
#include "gui/panels/story/own_listing.h"
#include "gui/panels/story/shader_panel.h"
#include "gui/session/session.h"
#include "textbook/listing_view.h"

namespace ps::gui {

/// State of the panel of listings.
struct ListingPanelState {
  explicit ListingPanelState(const std::function<void()>& wake)
      : worker(std::make_shared<Prepared>(), wake), shaders(wake), own(wake) {}

  InspectWorker worker;     ///< runs the listing, whichever renderer makes the pictures
  std::string folder, bug;  ///< whose text is shown
  std::unique_ptr<ListingText> text;
  std::string error;                              ///< why there is no text
  std::shared_ptr<const PixelStory> shown_story;  ///< what the view looks into
  std::optional<ListingView> view;
  bool reveal = false;           ///< the listing or its marked line is new: scroll there
  std::vector<ListingRow> rows;  ///< of the view
  int instance = -1;             ///< the document's, that the view was made for
  LineMarks marks;               ///< of the listing of A
  int opened_within = 0;         ///< the line whose routine was scrolled to

  ShaderPanelState shaders;
  OwnListingState own;
  /// The code shown where the picture is drawn by shaders.
  enum class Code { shaders, routine } code = Code::shaders;
};

/// A lesson's routine with the values that its lines had for the picked pixel, or the shaders that drew it.
class ListingPanel final : public Panel {
 public:
  /// A click on a line answers a question for it; the open step may ask to write a routine.
  ListingPanel(const PanelHost& host, LessonShelf& shelf, LessonQuestions& questions);
  bool draw(const Context& context) override;
  /// The panel's controls as buttons in one line, the rarer ones in a menu, so that the code has all of the height
  /// below. Empty where shaders or one's own file are shown, which have more to choose.
  bool head() override;
  void offer(Values& out) override;
  /// Takes up the values that have come.
  void update() override;
  bool busy() const override;

 private:
  void follow_lesson();

  LessonShelf& shelf_;
  LessonQuestions& questions_;
  ListingPanelState state_;
};

}  // namespace ps::gui
