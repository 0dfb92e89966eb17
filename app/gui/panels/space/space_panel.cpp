#include "gui/panels/space/space_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "gui/panels/space/space_gizmos.h"
#include "gui/panels/space/space_groups.h"
#include "gui/panels/space/space_paint.h"
#include "gui/panels/story/story_rows.h"
#include "gui/platform/texture.h"
#include "gui/session/select_event.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/redraw.h"
#include "gui/widgets/screen_painter.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double camera_margin = 1.15;     // around the image, when looking through the camera
constexpr double orbit_per_pixel = 0.006;  // at scale 1
constexpr double nearer_by_notch = 0.85;
constexpr double near_share = 0.02;        // of the viewer's distance
constexpr double negligible_share = 0.01;  // of the pixel's colour
constexpr double focus_factor = 1.1;       // distance of the viewer, of the scene's radius

const OutsideView& outside(const Session& session) { return session.document().story.outside; }

template <class Apply>
void edit_outside(Session& session, Apply&& apply) {
  session.navigate([&](Document& document) { apply(document.story.outside); });
}

SpaceOrbit orbit_now(const OutsideView& look, const SpacePanelState& state, double aspect) {
  return look.orbit ? *look.orbit : preset_orbit(look.preset, state.model.bounds, state.base, aspect);
}

View viewer(const OutsideView& look, const SpacePanelState& state, int width, int height) {
  if (look.through_camera) return through_camera(state.view, state.settings, camera_margin, width, height);
  const double aspect = static_cast<double>(width) / height;
  return orbit_view(orbit_now(look, state, aspect), state.base, width, height);
}

double near_of(const OutsideView& look, const SpacePanelState& state, double aspect) {
  return near_share *
         (look.through_camera ? state.view.camera.projection_plane_d : orbit_now(look, state, aspect).distance);
}

void set_preset(Session& session, SpacePreset preset) {
  edit_outside(session, [&](OutsideView& look) {
    look.preset = preset;
    look.orbit.reset();
    look.through_camera = false;
  });
}

void turn_to(Session& session, const SpaceOrbit& orbit) {
  edit_outside(session, [&](OutsideView& look) {
    look.orbit = orbit;
    look.through_camera = false;
  });
}

/// Puts what is selected, or else the first hit, into the middle.
void focus(Session& session, const SpacePanelState& state, int event, double aspect) {
  const SpaceItem* found = nullptr;
  for (const SpaceItem& item : state.model.items)
    if (item.kind == SpaceKind::hit_point && item.emphasised && (!found || item.event == event)) found = &item;
  if (!found) return;
  SpaceOrbit orbit = orbit_now(outside(session), state, aspect);
  orbit.distance = state.model.bounds.radius * focus_factor;
  orbit.pivot = found->points[0];
  turn_to(session, orbit);
}

void show_popup(Session& session, SpacePanelState& state) {
  if (button("show", "Show…", Emphasis::plain, {.tooltip = "What is drawn, and what the lines mean."}))
    ImGui::OpenPopup("space-show");
  if (!ImGui::BeginPopup("space-show")) return;
  const auto groups = shown_groups(outside(session));
  for (const auto& row : space_groups) {
    Stroke stroke = stroke_of({row.like, SpaceShape::line, {}});
    stroke.width = std::max(stroke.width, 2.0);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const double y = at.y + ImGui::GetFrameHeight() / 2;
    ScreenPainter(*ImGui::GetWindowDrawList()).line({at.x, y}, {at.x + px(22), y}, stroke);
    ImGui::Dummy({px(26), 1});
    ImGui::SameLine();
    bool shown = groups[static_cast<std::size_t>(row.group)];
    if (toggle(row.key, row.label, shown, {.tooltip = row.help})) {
      edit_outside(session, [&](OutsideView& look) { switch_group(look, row.group); });
      if (row.group == SpaceGroup::nodes && !shown) state.whole_tree = false;  // it is made of these boxes
    }
  }
  ImGui::Spacing();
  show_text("Boxes down to level");
  double deepest = outside(session).deepest_level, least = outside(session).least_contribution;
  if (number("level", deepest,
             {.minimum = 0, .maximum = std::max(1.0, static_cast<double>(state.model.deepest_level)), .integer = true},
             {.tooltip = "0 is the bounding box of the whole scene.", .width = px(180)})
          .changed)
    edit_outside(session, [&](OutsideView& look) { look.deepest_level = deepest; });
  const bool boxes = groups[static_cast<std::size_t>(SpaceGroup::nodes)];
  if (toggle("tree", "Whole tree", state.whole_tree,
             {.tooltip = "Also shows boxes that no ray of this pixel was tested against: the whole accelerator, level "
                         "by level. Shows the accelerator boxes, if they are hidden."}) &&
      state.whole_tree && !boxes)
    edit_outside(session, [&](OutsideView& look) { switch_group(look, SpaceGroup::nodes); });
  if (state.tree && state.tree->nodes > 0)
    show_text(fmt::format("{} nodes; {} primitives, listed {} times", state.tree->nodes, state.tree->primitives,
                          state.tree->entries));
  show_text("Hide rays that contribute less than");
  if (number("least", least, {.minimum = 0, .maximum = 1},
             {.tooltip =
                  "Hides rays that contribute a smaller fraction of the pixel's colour, with all that belongs to them.",
              .width = px(180)})
          .changed)
    edit_outside(session, [&](OutsideView& look) { look.least_contribution = least; });
  ImGui::EndPopup();
}

/// Whether the words of the toolbar must be short.
bool is_narrow() { return ImGui::GetContentRegionMax().x < px(560); }

void play_buttons(Session& session, SpacePanelState& state, int selected) {
  const std::string_view none = state.model.steps.empty() ? "No event of this pixel has a place in the scene." : "";
  const bool narrow = is_narrow();
  if (button("back", narrow ? "‹" : "Back", Emphasis::plain, {.tooltip = "Previous event (comma)", .disabled = none}))
    step_story(session, state, -1);
  ImGui::SameLine(0, px(2));
  if (button("play", state.play.running ? "Pause" : "Play", Emphasis::plain,
             {.tooltip = "Shows the events one after the other (Space)", .disabled = none, .width = px(62)}))
    play_story(session, state);
  ImGui::SameLine(0, px(2));
  if (button("forward", narrow ? "›" : "Step", Emphasis::plain,
             {.tooltip = "Next event (full stop)", .disabled = none}))
    step_story(session, state, 1);
  ImGui::SameLine();
  const auto& steps = state.model.steps;
  const auto step = std::upper_bound(steps.begin(), steps.end(), selected) - steps.begin();
  const std::string place = selected >= 0 ? fmt::format("{} of {}", step, steps.size())
                            : narrow      ? fmt::format("0 of {}", steps.size())
                                          : fmt::format("{} event{}", steps.size(), steps.size() == 1 ? "" : "s");
  ImGui::AlignTextToFramePadding();
  value_text("step", place);
  tooltip("The event that is shown, of the events of this pixel that have a place in the scene.");
}

/// How fast the story plays.
void speed_choice(SpacePanelState& state) {
  static constexpr std::array<double, 5> speeds{0.5, 1, 2, 5, 20};
  static constexpr std::array choices{
      Choice{"half", "½ / s", "An event every two seconds."}, Choice{"one", "1 / s", "An event every second."},
      Choice{"two", "2 / s", "Two events in a second."}, Choice{"five", "5 / s", "Five events in a second."},
      Choice{"twenty", "20 / s", "Twenty events in a second: a film."}};
  const auto found = std::find(speeds.begin(), speeds.end(), state.play.per_second);
  int index = found == speeds.end() ? 2 : static_cast<int>(found - speeds.begin());
  ImGui::SameLine();
  if (choice("speed", choices, index, {.tooltip = "How fast the story plays.", .width = px(84)}))
    state.play.per_second = speeds[static_cast<std::size_t>(index)];
}

/// Hides rays with an invisible contribution to the pixel; the threshold is set under "Show".
void hide_negligible(Session& session) {
  same_line_if_room(button_width("Main rays"), px(2));
  const bool hidden = outside(session).least_contribution > 0;
  if (button_on_off(
          "negligible", "Main rays", hidden,
          {.tooltip =
               "Hides rays that contribute less than 1 % of the pixel's colour, with all that belongs to them."}))
    edit_outside(session, [&](OutsideView& look) { look.least_contribution = hidden ? 0 : negligible_share; });
}

/// Where to look from: words side by side, or a list where the window is narrow.
void look_from(Session& session) {
  static constexpr std::array looks{
      Choice{"outside", "Outside", "The whole scene, from above on the camera's right."},
      Choice{"side", "Side", "From the camera's right: the camera is at the left."},
      Choice{"top", "Top", "From above: the camera is at the left."},
      Choice{"front", "Front", "In the camera's direction, from farther away."},
      Choice{"camera", "Camera", "Through the picture's own camera: its eye ray is a point."},
      Choice{"turned", "Turned", "As you turned it."}};
  constexpr int camera = 4, turned = 5;
  const OutsideView& look = outside(session);
  const int before = look.through_camera ? camera : look.orbit ? turned : static_cast<int>(look.preset);
  const bool wide = ImGui::GetWindowWidth() >= px(690);
  int index = wide && before == turned ? -1 : before;
  const std::span<const Choice> shown(looks.data(), wide || before != turned ? turned : turned + 1);
  const float width = px(wide ? 330 : 104);
  same_line_if_room(width, px(14));
  if (!choice("look", shown, index, {.width = width}) || index == turned) return;
  if (index == camera)
    edit_outside(session, [](OutsideView& changed) { changed.through_camera = true; });
  else
    set_preset(session, static_cast<SpacePreset>(index));
}

/// The parts of the model that are drawn.
SpaceLook look_of(const Session& session, const SpacePanelState& state) {
  SpaceLook look;
  look.groups = shown_groups(outside(session));
  look.least_contribution = outside(session).least_contribution;
  look.deepest_level = static_cast<int>(outside(session).deepest_level);
  look.up_to_event = drawn_until(session, state);
  if (state.shown_story)
    look.highlighted = shown_event(state.model, *state.shown_story, session.selected_event(inspected_side(session)));
  return look;
}

/// What the panel shows now as an SVG file; empty before the first picture has come.
std::string space_drawing(const Session& session, const SpacePanelState& state) {
  if (!state.picture || !session.has_scene()) return {};
  return space_svg(state.model, *state.picture, look_of(session, state));
}

/// Answers whether to fill the window, or no longer.
bool toolbar(SpacePanelState& state, const PanelHost& host, int selected, double aspect, bool filled) {
  Session& session = host.session;
  play_buttons(session, state, selected);
  speed_choice(state);
  look_from(session);
  same_line_if_room(button_width("Focus"), px(2));
  if (button("focus", "Focus", Emphasis::plain, {.tooltip = "Shows the hit point in the centre, from near by."}))
    focus(session, state, selected, aspect);
  same_line_if_room(button_width("Show…"), px(2));
  show_popup(session, state);
  hide_negligible(session);
  svg_button([&] {
    host.send(
        SaveDrawing{"Save the view from outside", "space.svg", [&] { return space_drawing(host.session, state); }});
  });
  return fill_button(filled, "Shows this view in the whole window (double click; Esc).");
}

void move_by_mouse(Session& session, SpacePanelState& state, double aspect) {
  const ImGuiIO& io = ImGui::GetIO();
  const OutsideView& look = outside(session);
  if (ImGui::IsItemActivated()) state.dragged = false;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, px(4)) &&
      (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    SpaceOrbit orbit = orbit_now(look, state, aspect);
    if (look.through_camera) orbit.yaw = orbit.pitch = 0;
    const double step = orbit_per_pixel / static_cast<double>(px(1));
    if (io.KeyShift) {  // moves what is in the middle
      const Camera camera = state.picture ? state.picture->view.camera : Camera{};
      const double size = orbit.distance * space_view_height / std::max(1.f, ImGui::GetItemRectSize().y);
      orbit.pivot +=
          (camera.up * static_cast<double>(io.MouseDelta.y) - camera.right * static_cast<double>(io.MouseDelta.x)) *
          size;
    } else {
      orbit.yaw -= io.MouseDelta.x * step;
      orbit.pitch = std::clamp(orbit.pitch + io.MouseDelta.y * step, -std::numbers::pi / 2, std::numbers::pi / 2);
    }
    turn_to(session, orbit);
    state.dragged = true;
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    SpaceOrbit orbit = orbit_now(look, state, aspect);
    if (look.through_camera) orbit.yaw = orbit.pitch = 0;
    orbit.distance *= std::pow(nearer_by_notch, static_cast<double>(io.MouseWheel));
    turn_to(session, orbit);
  }
}

Rgb8 paper_colour() {
  const ImVec4 paper = palette().field;
  const auto level = [](float share) { return static_cast<std::uint8_t>(std::lround(share * 255)); };
  return {level(paper.x), level(paper.y), level(paper.z)};
}

void caption(const SpacePanelState& state, const Session& session, int event, const Area& area) {
  if (!state.shown_story || event < 0 || static_cast<std::size_t>(event) >= state.shown_story->events.size()) return;
  const FontScope font(Face::body);
  const std::string text =
      in_lines(short_description(state.shown_story->events[static_cast<std::size_t>(event)], session.scene()),
               area.width() - px(32));
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const ImVec2 at{area.min.x + px(12), area.max.y - size.y - px(10)};
  auto& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x - px(6), at.y - px(3)}, {at.x + size.x + px(6), at.y + size.y + px(3)},
                     colour_u32(palette().panel, 0.9), px(4));
  attention_bar(list, {at.x - px(6), at.y - px(3)}, {at.x - px(2), at.y + size.y + px(3)});
  draw_lines(at, text, palette().text);
}

bool same_vertex(const VertexChain* a, const std::optional<VertexChain>& b) {
  return (a != nullptr) == b.has_value() && (!a || (a->id == b->id && a->world == b->world && a->camera == b->camera));
}

/// Adds the rest of the accelerator to the model once it is known. A story must be there: the picture has then built
/// it.
void update_tree(Session& session, SpacePanelState& state) {
  if (!state.whole_tree || !state.shown_story) return state.tree_worker.rest();
  if (state.tree) return;
  const SpaceTreeRequest wanted{session.scene(), state.settings, state.shown_story, session.work().prepared().get()};
  state.tree_worker.request(wanted);
  state.tree_worker.take_news();
  const auto found = state.tree_worker.result();
  if (!found || !same_request(found->of, wanted)) return;
  state.tree = found->tree;
  state.model.items.insert(state.model.items.end(), found->nodes.items.begin(), found->nodes.items.end());
  state.model.deepest_level = std::max(state.model.deepest_level, found->nodes.deepest_level);
}

}  // namespace

SpacePanel::SpacePanel(const PanelHost& host, const PicturesState& pictures, VertexPanel& vertex)
    : Panel(host, {.name = "space",
                   .answers = Answers::yes,
                   .heading = "Space",
                   .brief = "Space",
                   .command = "Space: the scene from outside",
                   .help = "The scene from outside, with the rays or triangles of the picked pixel."}),
      pictures_(pictures), vertex_(vertex), state_(host.wake) {}

void SpacePanel::offer(Values& out) {
  out.offer("space/items", [this] { return state_.items; });
  out.offer("space/rays", [this] { return state_.rays; });
  out.offer("space/shadow-rays", [this] { return state_.shadow_rays; });
  out.offer("space/boxes", [this] { return state_.boxes; });
  out.offer("space/tree-nodes", [this] { return state_.tree ? static_cast<int>(state_.tree->nodes) : 0; });
  out.offer("space/steps", [this] { return static_cast<int>(state_.model.steps.size()); });
  out.offer("space/playing", [this] { return state_.play.running; });
  out.offer("space/up-to", [this] { return drawn_until(session_, state_); });
  out.offer("space/orbit", [this] {
    const auto& orbit = outside(session_).orbit;
    return orbit ? fmt::format("{:.6g} {:.6g} {:.6g}", orbit->yaw, orbit->pitch, orbit->distance) : "none";
  });
}

void SpacePanel::update() {
  Session& session = session_;
  SpacePanelState& state = state_;
  wait_unless_drawn(state.worker);
  if (!session.has_scene()) return;
  const VertexChain* vertex = session.document().story.vertex ? vertex_.followed_chain() : nullptr;
  advance_play(session, state);
  const Side side = inspected_side(session);
  const auto story = session.story(side);
  const Scene& scene = session.scene();
  if (story == state.shown_story && scene.revision() == state.revision && session.view() == state.view &&
      session.settings(side) == state.settings && same_vertex(vertex, state.followed) &&
      (!state.tree || (state.whole_tree && story)))
    return update_tree(session, state);
  state.shown_story = story;
  state.revision = scene.revision();
  state.view = session.view();
  state.base = scene.camera;
  state.settings = session.settings(side);
  state.followed.reset();
  if (vertex) state.followed = *vertex;
  state.model = build_space(scene, state.view, state.settings, story.get());
  state.tree.reset();
  if (state.followed) add_vertex(*state.followed, state.view.camera, state.model);
  update_tree(session, state);
}

bool SpacePanel::draw(const Context& context) {
  Session& session = session_;
  SpacePanelState& state = state_;
  const PicturesState& pictures = pictures_;
  const NameScope scope("space");
  if (!session.has_scene()) return false;
  const Side side = inspected_side(session);
  const int event = session.selected_event(side);
  const int selected = state.shown_story ? shown_event(state.model, *state.shown_story, event) : -1;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  bool fill_or_not = toolbar(state, host_, selected, room.x / std::max(room.y, 1.f), context.filled);
  begin_tool_content();
  const int width = static_cast<int>(ImGui::GetContentRegionAvail().x),
            height = static_cast<int>(ImGui::GetContentRegionAvail().y);
  const double aspect = static_cast<double>(std::max(width, 1)) / std::max(height, 1);
  if (width < 16 || height < 16) return fill_or_not;

  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Area area{{std::floor(at.x), std::floor(at.y)},
                  {std::floor(at.x) + static_cast<float>(width), std::floor(at.y) + static_cast<float>(height)}};
  ImGui::InvisibleButton("view", {area.width(), area.height()});
  controls().record("view", fmt::format("{}x{}", width, height));
  const bool hovered = ImGui::IsItemHovered();
  space_gizmo_input(session, state, pictures, area);
  if (!state.gizmo_drag && !state.cancelled) move_by_mouse(session, state, aspect);
  const bool clicked = ImGui::IsItemDeactivated() && !state.dragged && hovered;
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) fill_or_not = true;

  const OutsideView& from = outside(session);
  state.worker.request({session.scene(), viewer(from, state, width, height), near_of(from, state, aspect)});
  state.worker.take_news();
  if (const auto picture = state.worker.result();
      picture && (picture != state.picture || state.paper != theme().brightness())) {
    state.picture = picture;
    state.paper = theme().brightness();
    state.texture.upload(paled(*picture, state.model.ground, paper_colour()));
  }
  auto& list = *ImGui::GetWindowDrawList();
  const bool covered = state.picture && static_cast<float>(state.picture->view.width) >= area.width() &&
                       static_cast<float>(state.picture->view.height) >= area.height();
  if (!covered) list.AddRectFilled(area.min, area.max, colour_u32(palette().field));
  if (!state.picture) return fill_or_not;
  const View& view = state.picture->view;
  const Area drawn_area{area.min,
                        {area.min.x + static_cast<float>(view.width), area.min.y + static_cast<float>(view.height)}};
  list.PushClipRect(area.min, area.max, true);
  add_plain_texture(list, state.texture, drawn_area.min, drawn_area.max);
  const SpaceLook look = look_of(session, state);
  const SpaceProjection projection(view, Settings{}, state.picture->near);
  if (!from.through_camera)
    draw_on_image_plane(list, area, state.model, projection, look, pictures.pictures[index_of(side)].texture);
  ScreenPainter painter(list);
  const SpaceDrawn drawn =
      draw_space(painter, paint_area(area.min, area.max), state.model, projection, state.picture->depth, look);
  const int hovered_event = hovered ? event_under(ImGui::GetIO().MousePos, area, state.model, projection, look) : -1;
  draw_space_gizmos(session, state, pictures, area);
  list.PopClipRect();
  state.items = drawn.items;
  state.rays = drawn.rays;
  state.shadow_rays = drawn.shadow_rays;
  state.boxes = drawn.boxes;
  if (drawn.highlight_place) {
    const ImVec2 place = window_place(*drawn.highlight_place);
    controls().record("highlight", {place.x - 2, place.y - 2}, {place.x + 2, place.y + 2}, "");
  }
  if (clicked) {
    state.play.running = false;
    select_event(session, side, hovered_event);
  }
  caption(state, session, hovered_event >= 0 ? hovered_event : event, area);
  return fill_or_not;
}

}  // namespace ps::gui
