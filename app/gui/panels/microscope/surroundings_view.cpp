#include "gui/panels/microscope/surroundings_view.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "gui/widgets/widgets.h"
#include "render/story/names.h"

namespace ps::gui {
namespace {

/// "9 of 9 pixels show red." and "light 2 does not reach 3 of 9."
std::vector<std::string> counts(const Scene& scene, const std::vector<SeenPixel>& around) {
  std::map<std::string, std::size_t> seen;
  std::map<int, std::size_t> blocked;
  for (const SeenPixel& one : around) {
    ++seen[one.seen];
    for (const int light : one.blocked) ++blocked[light];
  }
  std::vector<std::string> lines;
  lines.reserve(seen.size() + blocked.size());
  for (const auto& [what, count] : seen)
    lines.push_back(fmt::format("{} of {} pixels here show {}.", count, around.size(), what));
  for (const auto& [light, count] : blocked)
    lines.push_back(fmt::format("{} does not reach {} of {}.", light_name(scene, light), count, around.size()));
  return lines;
}

std::string edge_text(const NearestEdge& edge, Vec2i pixel) {
  const Vec2d away = Vec2d(edge.pixel - pixel);
  const std::string where =
      fmt::format("{:.3g} pixels away, at ({}, {})", std::hypot(away.x, away.y), edge.pixel.x, edge.pixel.y);
  if (edge.here == edge.beyond) return fmt::format("The nearest border of a shadow lies {}, on {}.", where, edge.here);
  return fmt::format("The nearest edge lies {}: {} beside {}.", where, edge.here, edge.beyond);
}

}  // namespace

void surroundings_view(Session& session, const PixelSurroundings& surroundings, Vec2i pixel) {
  value_paragraph("no-edge", "No edge runs through this pixel: all of it shows the same.");
  int index = 0;
  for (const std::string& line : counts(session.scene(), surroundings.around))
    value_paragraph(fmt::format("around/{}", index++), line);
  value_paragraph("nearest", surroundings.edge
                                 ? edge_text(*surroundings.edge, pixel)
                                 : fmt::format("There is no edge within {} pixels.", surroundings.searched));
  if (surroundings.edge && button("to-edge", "To the nearest edge", Emphasis::plain, {.tooltip = "Picks that pixel."}))
    session.set_pixel(surroundings.edge->pixel);
}

}  // namespace ps::gui
