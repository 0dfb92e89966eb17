#pragma once
#include <array>
#include <functional>
#include <string>
#include <utility>

#include "gui/panels/panel.h"
#include "gui/panels/pictures/canvas_rows_view.h"
#include "gui/panels/pictures/pictures_panel.h"
#include "gui/panels/story/parting_view.h"
#include "gui/panels/story/pin_view.h"
#include "gui/panels/story/predict_panel.h"
#include "gui/panels/story/shown_field.h"
#include "gui/panels/story/story_tree_view.h"
#include "gui/session/session.h"

namespace ps::gui {

/// State of the inspector.
struct PixelPanelState {
  /// `wake` as for PinState.
  explicit PixelPanelState(const std::function<void()>& wake) : pin(wake) {}

  std::array<StoryTreeState, 2> trees;
  PartingViewState parting;
  PinState pin;
  bool events_open = true, sum_open = true, work_open = false, rows_open = false;
  CanvasRowsState rows;
  ShownFieldState field;   ///< of the number that the pictures show
  Vec2i scrolled{-1, -1};  ///< the pixel whose story may have been scrolled: another one begins at its top
  std::array<bool, 2> both_events_open{false, false}, both_sum_open{true, true};  ///< in the view of both
};

/// The story of the picked pixel: verdict, events as a tree, the colour as a sum, and the work it took; or the question
/// about it, which comes first.
class PixelPanel final : public Panel {
 public:
  PixelPanel(const PanelHost& host, LessonQuestions& questions);
  bool draw(const Context& context) override;
  void add_actions(Actions& actions) override;
  void offer(Values& out) override;
  /// Takes up a question, so that what comes after it in a frame knows of it.
  void update() override;
  bool busy() const override { return pin_busy(state_.pin); }

  /// Whether an open question hides the story.
  bool asks() { return prediction_pending(session_, predict); }
  /// What the open question covers of the pictures.
  PictureCovers covers();
  /// Esc: no longer asks about pixels. Answers whether it did.
  bool stop_asking();

  PredictState predict;  ///< for the frame, which has a place for the question beside a lesson's text

 private:
  void story();

  PixelPanelState state_;
};

}  // namespace ps::gui
