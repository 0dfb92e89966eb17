#include "gui/panels/pictures/vertex_marks.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "base/number_text.h"
#include "document/number_list.h"
#include "gui/base/values.h"
#include "gui/panels/pictures/marks.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"

namespace ps::gui {
namespace {

constexpr double numbered_from = 24;          ///< window pixels for one of the picture, at scale 1
constexpr std::ptrdiff_t most_numbered = 40;  ///< more would lie over one another
constexpr std::size_t most_marks = 20'000;    ///< more would hide the picture

/// The scene, the view and the settings that decide where vertices are projected to.
std::string source_of(const Session& session, Side side) {
  const View view = session.view();
  return fmt::format("{} {}x{} {} {}", session.scene().geometry.revision(), view.width, view.height,
                     camera_text(view.camera), fmt::join(changed_options(session.settings(side)), ";"));
}

/// A square: of many marks a circle each would take long to draw.
void vertex_mark(ImDrawList& list, ImVec2 at, float radius) {
  const auto square = [&](float half, ImU32 colour) {
    list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, colour);
  };
  square(radius + px(1), IM_COL32(0, 0, 0, 220));
  square(radius, IM_COL32(255, 80, 255, 255));
}

}  // namespace

void draw_vertex_marks(const Session& session, VertexMarks& marks, Side side, const PictureTransform& transform,
                       const Area& area, const Area& clip) {
  const std::string letter(1, side == Side::a ? 'a' : 'b');
  if (!marks.on || !session.has_scene()) return values().withdraw(letter + "/vertices");
  VertexMarks::Found& found = marks.found[index_of(side)];
  if (std::string source = source_of(session, side); source != found.of)
    found = {std::move(source),
             projected_vertices(session.scene(), session.view(), session.settings(side), most_marks)};
  values().publish(letter + "/vertices", static_cast<double>(found.vertices.size()));
  const auto place = [&](const ProjectedVertex& vertex) { return transform.to_window(vertex.canvas, area); };
  const auto in_sight = std::ranges::count_if(
      found.vertices, [&](const ProjectedVertex& vertex) { return clip.contains(place(vertex)); });
  const bool numbered = transform.zoom >= px(numbered_from) && in_sight <= most_numbered;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(clip.min, clip.max, true);
  const float radius = px(numbered ? 4 : 2);
  for (const ProjectedVertex& vertex : found.vertices) {
    const ImVec2 at = place(vertex);
    if (!clip.contains(at)) continue;
    vertex_mark(list, at, radius);
    if (!numbered) continue;
    const std::string text = fmt::format("vertex {}\n({:.2f}, {:.2f})\nz = {:.4g}", vertex.id.vertex, vertex.canvas.x,
                                         vertex.canvas.y, vertex.z);
    name_plate(list, text, at, 8, clip);
    controls().record(fmt::format("view/{}/vertex/{}.{}", letter, vertex.id.object, vertex.id.vertex),
                      {at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}, text);
  }
  if (found.vertices.size() == most_marks)
    name_plate(list, fmt::format("the first {} vertices", with_thousands(std::to_string(most_marks))),
               {clip.min.x, clip.min.y + px(16)}, 8, clip);
  list.PopClipRect();
}

}  // namespace ps::gui
