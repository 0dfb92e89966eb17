#include "gui/frame/story_mirror.h"

#include <sstream>

namespace ps::gui {
namespace {

std::string switched_groups(const SpacePanelState& space) {
  std::string keys;
  for (const auto& row : space_groups)
    if (space.groups[static_cast<std::size_t>(row.group)] != row.shown)
      keys += (keys.empty() ? "" : ",") + std::string(row.key);
  return keys;
}

void switch_groups(SpacePanelState& space, const std::string& keys) {
  for (const auto& row : space_groups) space.groups[static_cast<std::size_t>(row.group)] = row.shown;
  std::istringstream words(keys);
  for (std::string key; std::getline(words, key, ',');)
    for (const auto& row : space_groups)
      if (row.key == key) space.groups[static_cast<std::size_t>(row.group)] = !row.shown;
}

StoryView gather(const Session& session, const StoryPanels& panels, const StoryMirror& mirror) {
  const SpacePanelState& space = panels.space;
  const Vec2i pixel = session.document().pixel;
  StoryView view;
  view.outside = {
      space.preset,       space.orbit, space.through_camera, switched_groups(space), space.least_contribution,
      space.deepest_level};
  view.until_event = mirror.resumes || space.play.up_to >= 0;
  if (panels.listing.stepped_pixel == pixel) view.listing_instance = panels.listing.stepped_to;
  if (panels.microscope.pixel == pixel) {
    view.sample = panels.microscope.point;
    view.micro_triangle = panels.microscope.selected;
  }
  if (panels.vertex.keep) view.vertex = panels.vertex.vertex;
  view.vertex_edits = panels.vertex.edits;
  return view;
}

void show_outside(const OutsideView& outside, SpacePanelState& space) {
  space.preset = outside.preset;
  space.orbit = outside.orbit;
  space.through_camera = outside.through_camera;
  switch_groups(space, outside.switched);
  space.least_contribution = outside.least_contribution;
  space.deepest_level = outside.deepest_level;
}

void show_vertex(const Session& session, const StoryView& view, VertexPanelState& vertex) {
  vertex.edits = view.vertex_edits;
  if (vertex.keep == view.vertex.has_value() && (!vertex.keep || vertex.vertex == view.vertex)) return;
  vertex.keep = view.vertex.has_value();
  vertex.vertex = view.vertex;
  vertex.pixel = {-1, -1};
  vertex.revision = session.scene().geometry.revision();
}

void show(const Session& session, const StoryView& view, const StoryPanels& panels, StoryMirror& mirror) {
  const Vec2i pixel = session.document().pixel;
  show_outside(view.outside, panels.space);
  mirror.resumes = view.until_event;
  if (!view.until_event) panels.space.play.up_to = -1;
  panels.space.play.running = false;
  panels.listing.stepped_pixel = pixel;
  panels.listing.stepped_to = view.listing_instance;
  panels.listing.shown_story.reset();  // so that the view is made anew
  panels.microscope.pixel = pixel;
  panels.microscope.point = view.sample;
  panels.microscope.selected = view.micro_triangle;
  show_vertex(session, view, panels.vertex);
}

}  // namespace

void mirror_story(Session& session, const StoryPanels& panels, const ScreenMirror& screen, StoryMirror& mirror) {
  if (!session.has_scene()) return;
  if (const StoryView& asked = session.document().story; !(asked == mirror.shown)) {
    mirror.shown = asked;
    show(session, asked, panels, mirror);
    return;
  }
  if (screen.wanted) return;  // the event that some of it is about is still to come
  const StoryView now = gather(session, panels, mirror);
  if (now == mirror.shown) return;
  mirror.shown = now;
  session.navigate([&](Document& document) { document.story = now; });
}

void restore_play(const Session& session, const StoryPanels& panels, const ScreenMirror& screen, StoryMirror& mirror) {
  if (!mirror.resumes || screen.wanted) return;
  const Side side = inspected_side(session);
  const auto story = session.story(side);
  if (!story || panels.space.shown_story != story) return;
  mirror.resumes = false;
  const int selected = panels.pixel.cursors[index_of(side)].selected;
  panels.space.play.up_to = selected >= 0 ? shown_event(panels.space.model, *story, selected) : -1;
}

}  // namespace ps::gui
