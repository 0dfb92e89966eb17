#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "gui/panels/panel.h"
#include "gui/panels/pictures/pictures_panel.h"
#include "gui/panels/story/vertex_panel.h"
#include "gui/work/space_tree_worker.h"
#include "gui/work/space_worker.h"
#include "inspect/space_model.h"
#include "inspect/space_orbit.h"
#include "inspect/space_tree.h"
#include "inspect/vertex_chain.h"

namespace ps::gui {

/// Going through a story's events one by one. How far it has come is the document's (StoryView::until_event).
struct StoryPlay {
  bool running = false;
  int played = -1;        ///< the event that it selected last; another one stops it
  double per_second = 2;  ///< events
  double next_at = 0;     ///< on the window's clock
};

/// State of the view from outside.
struct SpacePanelState {
  explicit SpacePanelState(const std::function<void()>& wake) : tree_worker(wake), worker(wake) {}

  bool whole_tree = false;  ///< also the nodes of the accelerator that no ray came to
  StoryPlay play;

  // The model and what it was made from.
  std::shared_ptr<const PixelStory> shown_story;
  SceneRevision revision;
  View view;
  Camera base;  ///< whose axes the orbit turns about
  Settings settings;
  std::optional<VertexChain> followed;  ///< the way of the vertex that the document keeps
  SpaceModel model;
  std::optional<SpaceTree> tree;  ///< what is known of the accelerator, if the whole of it is in the model
  SpaceTreeWorker tree_worker;

  // What is on the screen.
  SpaceWorker worker;
  std::shared_ptr<const SpacePicture> picture;
  Texture texture;
  Brightness paper = Brightness::light;  ///< of the theme that `texture` was made for
  bool dragged = false;                  ///< the button that is down has moved
  std::optional<GizmoDrag> gizmo_drag;   ///< what the mouse has taken hold of
  bool cancelled = false;                ///< its drag was taken back; the button is still down
  int rays = 0, shadow_rays = 0, boxes = 0, items = 0;
};

/// The scene from outside with the picked pixel's story in it. A click on an event selects it.
class SpacePanel final : public Panel {
 public:
  /// It shows what the mouse can take hold of in `pictures`, and the way of the vertex that the document keeps.
  SpacePanel(const PanelHost& host, const PicturesState& pictures, VertexPanel& vertex);
  bool draw(const Context& context) override;
  void add_actions(Actions& actions) override;
  void offer(Values& out) override;
  /// Brings the model up to date and goes on playing.
  void update() override;
  bool busy() const override { return works(state_.worker) || works(state_.tree_worker); }
  bool cancel_drag() override;

 private:
  const PicturesState& pictures_;
  VertexPanel& vertex_;
  SpacePanelState state_;
};

/// The last event that is drawn; -1 = all are.
int drawn_until(const Session& session, const SpacePanelState& state);
/// Selects the event `by` steps on, and shows only what has happened until then.
void step_story(Session& session, SpacePanelState& state, int by);
/// Starts or stops going through the events.
void play_story(Session& session, SpacePanelState& state);
/// Takes the next step when it is time; stops at the end, and where another event was selected.
void advance_play(Session& session, SpacePanelState& state);

}  // namespace ps::gui
