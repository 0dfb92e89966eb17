#include "gui/panels/story/vertex_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/screen_names.h"
#include "gui/widgets/draw.h"
#include "record/value_text.h"
#include "render/renderer_table.h"

namespace ps::gui {
namespace {

constexpr double card_width = 322, card_gap = 16, column_width = 76;

std::string place_text(const Vec2d& v) { return vector_text(v); }
std::string place_text(const Vec3d& v) { return vector_text(v); }
std::string place_text(const Vec4d& v) {
  return fmt::format("({}, {}, {}, {})", ps::number_text(v.x), ps::number_text(v.y), ps::number_text(v.z),
                     ps::number_text(v.w));
}

void matrix(const char* id, const Mat4d& m) {
  constexpr auto look = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_BordersOuterV | ImGuiTableFlags_NoHostExtendX;
  if (!ImGui::BeginTable(id, 4, look)) return;
  for (int column = 0; column < 4; ++column)
    ImGui::TableSetupColumn("number", ImGuiTableColumnFlags_WidthFixed,
                            px(column_width) - 2 * ImGui::GetStyle().CellPadding.x);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      const TextScope scope({.quiet = m[column][row] == 0});
      const std::string digits = ps::number_text(m[column][row]);
      number_cell(digits, digits);
    }
  ImGui::EndTable();
}

/// Where the vertex is after a step; what an edit changed shows beside it.
template <class Place>
void result(std::string_view name, const Place& now, const Place& plain) {
  value_text(name, place_text(now), {Face::mono_bold});
  if (now != plain) show_text("was " + place_text(plain), {Face::small});
}

/// One step in a frame of its own; cards are side by side as far as there is room.
template <class Body>
void card(int number, const char* title, const char* says, Body&& body) {
  if (number > 0) {  // all but the first
    const float next = ImGui::GetItemRectMax().x + px(card_gap + card_width);
    if (next <= ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) ImGui::SameLine(0, px(card_gap));
  }
  ImGui::BeginGroup();
  ImGui::PushItemWidth(px(card_width));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  show_text(number > 0 ? fmt::format("{}  {}", number, title) : title, {Face::bold});
  {
    const FontScope font(Face::small);
    show_text(in_lines(says, px(card_width)), {.quiet = true});
  }
  body();
  ImGui::PopItemWidth();
  const float used = ImGui::GetCursorScreenPos().x - at.x;
  ImGui::Dummy({std::max(px(card_width) - used, 1.f), px(10)});
  ImGui::EndGroup();
}

void model_card(const VertexChain& now, const VertexChain& plain, const VertexUses& uses) {
  card(1, "model", "Position in the model (CGFS ch. 10).", [&] {
    result("model", now.model, plain.model);
    const FontScope font(Face::small);
    for (std::size_t i = 0; i < uses.first.size(); ++i)
      value_text(fmt::format("use/{}", i), in_lines(use_text(uses.first[i]), px(card_width)));
    if (uses.count > uses.first.size())
      quiet_text(fmt::format("and {} more triangles", uses.count - uses.first.size()));
  });
}

template <class Apply>
void try_out(Session& session, Apply&& apply) {
  session.navigate([&](Document& document) { apply(document.story.vertex_edits); });
}

void keep(Session& session, const std::optional<VertexId>& vertex) {
  session.navigate([&](Document& document) { document.story.vertex = vertex; });
}

void world_card(Session& session, const VertexChain& now, const VertexChain& plain) {
  card(2, "world", "Translation, rotation and scale, as one matrix.", [&] {
    static constexpr std::array orders{
        Choice{"turn-then-move", "turn, move", "Rotation first, as in the renderers."},
        Choice{"move-then-turn", "move, turn", "Translation first: the rotation turns it as well."}};
    int order = session.document().story.vertex_edits.order == ModelOrder::turn_then_move ? 0 : 1;
    if (choice("order", orders, order, {.width = px(card_width)}))
      try_out(session, [&](VertexEdits& edits) {
        edits.order = order == 0 ? ModelOrder::turn_then_move : ModelOrder::move_then_turn;
      });
    matrix("to-world", now.to_world);
    result("world", now.world, plain.world);
  });
}

void camera_card(const VertexChain& now, const VertexChain& plain) {
  card(3, "camera", "World position minus camera position, along the camera's right, up and forward axes.", [&] {
    matrix("to-camera", now.to_camera);
    result("camera", now.camera, plain.camera);
  });
}

void clip_card(Session& session, const VertexChain& now, const VertexChain& plain) {
  card(4, "clip", "Distances to the planes; negative = clipped (CGFS ch. 11).", [&] {
    double near = session.document().story.vertex_edits.near.value_or(session.settings(inspected_side(session)).near);
    show_text("near");
    ImGui::SameLine(0, px(8));
    const Option* option = find_option("near");
    if (number("near", near, {.minimum = option->minimum, .maximum = option->maximum, .scale = option->scale},
               {.tooltip = "Tries another near plane for this vertex.", .width = px(110)})
            .changed)
      try_out(session, [&](VertexEdits& edits) { edits.near = near; });
    for (const PlaneDistance& plane : now.planes) {
      const bool cut = plane.distance < 0;
      value_text(fmt::format("plane-{}", plane.plane),
                 fmt::format("{:<12} {:>9}{}", plane.plane, ps::number_text(plane.distance), cut ? "  outside" : ""),
                 {Face::mono});
    }
    if (now.planes.empty()) quiet_text("Clipping is off.");
    result("clip", now.clip, plain.clip);
  });
}

void viewport_card(const VertexChain& now, const VertexChain& plain) {
  card(5, "projection", "x and y divided by w, which is z: pixels from the centre, y up (CGFS ch. 9).", [&] {
    matrix("to-clip", now.to_clip);
    result("centred", now.centred, plain.centred);
    value_text("viewport", "on the viewport " + place_text(now.viewport), {Face::small, true});
  });
}

void canvas_card(const VertexChain& now, const VertexChain& plain) {
  card(6, "canvas", "Pixels from the top left, y down: where the vertex is drawn.",
       [&] { result("canvas", now.canvas, plain.canvas); });
}

bool toolbar(Session& session, const VertexChain& chain, bool filled) {
  const VertexId vertex = chain.id;
  const auto& mesh_of =
      std::get<Instance>(session.scene().geometry->objects[static_cast<std::size_t>(vertex.object)].shape);
  const int count = static_cast<int>(session.scene().geometry->meshes[mesh_of.mesh]->positions.size());
  {
    const FontScope font(Face::heading);
    value_text("name", fmt::format("vertex {} of {}", vertex.vertex, chain.object_name));
  }
  same_line_if_room(button_width("Previous") + button_width("Next"), px(16));
  if (button("previous", "Previous")) keep(session, VertexId{vertex.object, (vertex.vertex + count - 1) % count});
  ImGui::SameLine();
  if (button("next", "Next")) keep(session, VertexId{vertex.object, (vertex.vertex + 1) % count});
  const float keep_width = text_width("Keep this vertex") + px(48);  // with the switch before it
  same_line_if_room(keep_width);
  bool kept = session.document().story.vertex.has_value();
  if (toggle("keep", "Keep this vertex", kept,
             {.tooltip = "Off: follows the vertex nearest to the picked pixel, of the triangle that it shows.",
              .width = keep_width}))
    keep(session, kept ? std::optional(vertex) : std::nullopt);
  same_line_if_room(button_width("Show in space"));
  if (button("space", "Show in space", Emphasis::plain,
             {.tooltip = "Keeps the vertex, and shows it in the view from outside."})) {
    keep(session, vertex);
    session.navigate([](Document& document) { document.layout.bottom_tab = tool_names::space; });
  }
  if (session.document().story.vertex_edits != VertexEdits{}) {
    same_line_if_room(button_width("Undo the edits"));
    if (button("reset", "Undo the edits", Emphasis::plain, {.tooltip = "Restores the transforms of the renderers."}))
      try_out(session, [](VertexEdits& edits) { edits = {}; });
  }
  return fill_button(filled, "Shows the transforms in the whole window; Esc goes back.");
}

}  // namespace

VertexPanel::VertexPanel(const PanelHost& host)
    : Panel(host, {.name = "vertex",
                   .height = PanelHeight::tall,
                   .heading = "Vertex",
                   .brief = "Vertex",
                   .command = "Vertex: from the model to the canvas",
                   .help = "The transforms of a vertex from its model to the canvas, with matrices and numbers."}) {}

void VertexPanel::add_actions(Actions& actions) {
  ActionGroup(actions, "Study", [this] {
    return session_.has_scene();
  }).add("vertex-film", "Vertex: play its way from the model to the canvas", "", [this] {
    host_.send(ShowTool{facts.name});
    play_film(film_);
  });
}

void VertexPanel::offer(Values& out) {
  out.offer("vertex", [this] {
    const auto vertex = followed_vertex();
    return vertex ? fmt::format("{},{}", vertex->object, vertex->vertex) : "none";
  });
}

std::optional<VertexId> VertexPanel::followed_vertex() {
  if (!session_.has_scene()) return {};
  if (const auto& kept = session_.document().story.vertex) return kept;
  const auto pixel = session_.pixel();
  const Side side = inspected_side(session_);
  const auto story = session_.story(side);
  const Scene& scene = session_.scene();
  if (geometry_ != scene.geometry.revision()) {  // other objects may have these numbers now
    geometry_ = scene.geometry.revision();
    nearest_.reset();
    story_.reset();
  }
  if (pixel && story && story->pixel == *pixel && story != story_) {
    story_ = story;
    nearest_ = nearest_vertex(scene, session_.view(), session_.settings(side), {pixel->x + 0.5, pixel->y + 0.5},
                              shown_triangle(*story));
  }
  return nearest_;
}

const VertexUses& VertexPanel::uses_of(const VertexId& vertex) {
  const Scene& scene = session_.scene();
  if (used_vertex_ != vertex || used_geometry_ != scene.geometry.revision()) {
    uses_ = vertex_uses(scene, vertex);
    used_vertex_ = vertex;
    used_geometry_ = scene.geometry.revision();
  }
  return uses_;
}

const VertexChain* VertexPanel::followed_chain() {
  const auto vertex = followed_vertex();
  chain_.reset();
  error_.clear();
  if (!vertex) return nullptr;
  const Settings& settings = session_.settings(inspected_side(session_));
  try {
    chain_ = vertex_chain(session_.scene(), session_.view(), settings, *vertex, session_.document().story.vertex_edits);
    plain_ = vertex_chain(session_.scene(), session_.view(), settings, *vertex);
  } catch (const InputError& error) {
    error_ = error.what();
  }
  return chain_ ? &*chain_ : nullptr;
}

bool VertexPanel::draw(const Context& context) {
  const NameScope scope("vertex");
  if (!followed_chain()) {
    quiet_text(!error_.empty() ? error_
               : session_.pixel() && session_.has_scene()
                   ? "This scene has no models, so there are no vertices to follow."
                   : "Click a pixel to follow the nearest vertex of its triangle.");
    return false;
  }
  const VertexChain now = *chain_, plain = *plain_;
  const bool fill = toolbar(session_, now, context.filled);
  if (renderer_row(session_.settings(inspected_side(session_)).renderer).by_driver)
    quiet_text("Computed by this program in double precision. The graphics driver does not report its own positions, "
               "which may differ in the last digits.");
  ImGui::Spacing();
  begin_tool_content();
  ImGui::BeginChild("chain");
  card(0, "Film", "Its model on the way from space to space.",
       [&] { vertex_film(session_, film_, now.id, px(card_width)); });
  model_card(now, plain, uses_of(now.id));
  world_card(session_, now, plain);
  camera_card(now, plain);
  clip_card(session_, now, plain);
  viewport_card(now, plain);
  canvas_card(now, plain);
  ImGui::EndChild();
  return fill;
}

}  // namespace ps::gui
