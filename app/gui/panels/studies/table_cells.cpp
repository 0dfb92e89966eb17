#include "gui/panels/studies/table_cells.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double least_bar = 30;                              // pixels at scale 1
constexpr double thumbnail_height = 64, large_picture = 300;  // pixels at scale 1

float shape_of(const Image<Rgb8>& picture) {
  return static_cast<float>(picture.width()) / static_cast<float>(std::max(picture.height(), 1));
}

}  // namespace

void bar_cell(std::string_view name, double share, const std::string& text, std::optional<double> limit) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  const float digits = px(cell_digits_width), bar = std::max(room - digits - px(8), px(least_bar));
  ImGui::Dummy({room, height});
  controls().record(name, text);
  auto& list = *ImGui::GetWindowDrawList();
  draw_text(at, {at.x + digits, at.y + height}, text, palette().text, 1, Face::mono);
  const ImVec2 from{at.x + digits + px(8), at.y + px(3)}, to{from.x + bar, at.y + height - px(3)};
  list.AddRectFilled(from, to, colour_u32(palette().line, 0.6));
  const auto part = static_cast<float>(std::clamp(share, 0.0, 1.0));
  list.AddRectFilled(from, {from.x + bar * part, to.y}, colour_u32(palette().text_quiet));
  if (!limit) return;
  const float x = from.x + bar * static_cast<float>(std::clamp(*limit, 0.0, 1.0));
  list.AddLine({x, from.y - px(3)}, {x, to.y + px(3)}, colour_u32(palette().text), px(2));
}

void cell_line(std::string_view text, const ImVec4& colour, Face face) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  draw_text(at, {at.x + room, at.y + height}, text, colour, 0, face);
  ImGui::Dummy({room, height});
}

void column_heading(const char* text, const char* help) {
  ImGui::TableNextColumn();
  cell_line(text, palette().text_quiet, Face::bold);
  tooltip(help);
}

void name_cell(std::string_view text) {
  ImGui::TableNextColumn();
  const bool cut = text_width(text) > ImGui::GetContentRegionAvail().x;
  cell_line(text, palette().text);
  if (cut) tooltip(text);
}

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

const Texture& SmallPictures::texture(std::string_view name, const std::shared_ptr<const Image<Rgb8>>& picture) {
  One& one = pictures_[std::string(name)];
  if (one.of != picture) {
    one.of = picture;
    one.texture.upload(*picture);
    one.texture.set_shrunk(true);
  }
  return one.texture;
}

float thumbnail_width(const std::shared_ptr<const Image<Rgb8>>& picture) {
  return px(thumbnail_height) * (picture ? shape_of(*picture) : 1);
}

void thumbnail_cell(SmallPictures& thumbnails, std::string_view name,
                    const std::shared_ptr<const Image<Rgb8>>& picture) {
  ImGui::TableNextColumn();
  if (!picture) return;
  const Texture& texture = thumbnails.texture(name, picture);
  ImGui::Image(texture.id(), {thumbnail_width(picture), px(thumbnail_height)});
  controls().record("thumbnail", fmt::format("{}x{}", picture->width(), picture->height()));
  if (!begin_tooltip()) return;
  ImGui::Image(texture.id(), {px(large_picture) * shape_of(*picture), px(large_picture)});
  end_tooltip();
}

}  // namespace ps::gui
