#pragma once
#include "gui/frame/screen_state.h"
#include "gui/panels/microscope/microscope_panel.h"
#include "gui/panels/space/space_panel.h"
#include "gui/panels/story/listing_panel.h"
#include "gui/panels/story/pixel_panel.h"
#include "gui/panels/story/vertex_panel.h"

namespace ps::gui {

/// The panels that show a pixel's story; all must outlive it.
struct StoryPanels {
  PixelPanelState& pixel;
  SpacePanelState& space;
  MicroscopePanelState& microscope;
  ListingPanelState& listing;
  VertexPanelState& vertex;
};

/// What of these panels belongs to the document, as it was when the two were last alike.
struct StoryMirror {
  StoryView shown;
  bool resumes = false;  ///< the playing is to go on from the selected event, once that is there
};

/// Keeps the document's StoryView the same as what the panels show, whichever of the two changed. After mirror_screen()
/// and before the panels look at the scene.
void mirror_story(Session& session, const StoryPanels& panels, const ScreenMirror& screen, StoryMirror& mirror);

/// Resumes the playback that a permalink stores, when its story and its event have arrived. After update_space().
void restore_play(const Session& session, const StoryPanels& panels, const ScreenMirror& screen, StoryMirror& mirror);

}  // namespace ps::gui
