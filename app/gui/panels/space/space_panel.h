#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "gui/panels/pictures/pictures_panel.h"
#include "gui/panels/space/space_style.h"
#include "gui/panels/story/pixel_panel.h"
#include "gui/work/space_tree_worker.h"
#include "gui/work/space_worker.h"
#include "inspect/space_orbit.h"
#include "inspect/space_tree.h"
#include "inspect/vertex_chain.h"

namespace ps::gui {

/// Going through a story's events one by one.
struct StoryPlay {
  bool running = false;
  int up_to = -1;         ///< the last event that has happened; -1 = all have
  double per_second = 2;  ///< events
  double next_at = 0;     ///< on the window's clock
};

/// What the view from outside remembers of itself.
struct SpacePanelState {
  explicit SpacePanelState(const std::function<void()>& wake) : tree_worker(wake), worker(wake) {
    for (const auto& row : space_groups) groups[static_cast<std::size_t>(row.group)] = row.shown;
  }

  std::optional<SpaceOrbit> orbit;  ///< empty = the preset that shows all
  SpacePreset preset = SpacePreset::outside;
  bool through_camera = false;
  std::array<bool, space_groups.size()> groups{};
  double least_contribution = 0;
  double deepest_level = 3;
  bool whole_tree = false;  ///< also the nodes of the accelerator that no ray came to
  StoryPlay play;

  // The model and what it was made from.
  std::shared_ptr<const PixelStory> shown_story;
  SceneRevision revision;
  View view;
  Camera base;  ///< whose axes the orbit turns about
  Settings settings;
  std::optional<VertexChain> vertex;  ///< that is followed; set before update_space()
  std::optional<VertexChain> followed;
  SpaceModel model;
  std::optional<SpaceTree> tree;  ///< what is known of the accelerator, if the whole of it is in the model
  SpaceTreeWorker tree_worker;

  // What is on the screen.
  SpaceWorker worker;
  std::shared_ptr<const SpacePicture> picture;
  Texture texture;
  Brightness paper = Brightness::light;  ///< of the theme that `texture` was made for
  bool dragged = false;                  ///< the button that is down has moved
  int rays = 0, shadow_rays = 0, boxes = 0, items = 0;
  std::function<void()> save;  ///< asks where to write the view; empty = it cannot be written
};

/// The scene from outside with the picked pixel's story in it. Selecting an event here selects it in the inspector, and
/// the other way round. `filled`: it has the whole window; answers whether that shall change.
bool space_panel(Session& session, SpacePanelState& state, PixelPanelState& pixel, const PicturesState& pictures,
                 bool filled);

/// What the panel shows now as an SVG file; empty before the first picture has come.
std::string space_drawing(const Session& session, const SpacePanelState& state);

/// Brings the model up to date; also while the panel is not shown, for steps and for what is published.
void update_space(Session& session, SpacePanelState& state);
/// Selects the event `by` steps on, and shows only what has happened until then.
void step_story(Session& session, SpacePanelState& state, PixelPanelState& pixel, int by);
/// Starts or stops going through the events.
void play_story(Session& session, SpacePanelState& state, PixelPanelState& pixel);

}  // namespace ps::gui
