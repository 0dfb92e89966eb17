#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/studies/pixel_map.h"
#include "gui/panels/studies/why_tab.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "render/precision_channels.h"

namespace ps::gui {
namespace {

constexpr StudyWords precision_words{.name = "precision",
                                     .title = "Precision",
                                     .measure = "Find out",
                                     .again = "Find again",
                                     .help = "Renders the picture again in double and compares pixel by pixel.",
                                     .preparing = "rendering in double"};

constexpr double legend_width = 208, gap_legend_width = 150;  // pixels at scale 1

/// "wrong-winner": how scripts name a fault.
std::string fault_key(PrecisionFault fault) {
  std::string key(precision_fault_label(fault));
  std::replace(key.begin(), key.end(), ' ', '-');
  return key;
}

bool faultless(const PrecisionMap& map) { return map.count(PrecisionFault::none) == map.faults.pixels().size(); }

/// In the middle of the map that was drawn last: what its evenness means.
void over_map(const std::string& text) {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const std::string lines = in_lines(text, max.x - min.x - px(12));
  const ImVec2 size{text_width(lines), text_height(lines)};
  const ImVec2 at{std::round((min.x + max.x - size.x) / 2), std::round((min.y + max.y - size.y) / 2)};
  ImGui::GetWindowDrawList()->AddRectFilled({at.x - px(6), at.y - px(3)},
                                            {at.x + size.x + px(6), at.y + size.y + px(3)},
                                            colour_u32(palette().panel, 0.94), px(3));
  draw_lines(at, lines, palette().text);
  controls().record("no-fault", text);
}

/// What the colours of the second map mean: in one column, or flowing where the room is `wide`.
void gap_legend(float room, bool wide) {
  struct Entry {
    float gap;
    const char* meaning;
  };
  static constexpr Entry entries[] = {{0, "< 1: z-fighting"},
                                      {1, "1 ulp of depth"},
                                      {4096, "2¹² ulp"},
                                      {16777216, "2²⁴ or more"},
                                      {std::numeric_limits<float>::infinity(), "no second surface"}};
  const FontScope small(Face::small);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float swatch = px(12), line = ImGui::GetTextLineHeight() + px(3);
  auto& list = *ImGui::GetWindowDrawList();
  ImVec2 at = from;
  for (const Entry& entry : entries) {
    const float width = swatch + px(6) + text_width(entry.meaning);
    if (at.x > from.x && (!wide || at.x + width > from.x + room)) at = {from.x, at.y + line};
    const Rgb8 c = depth_gap_colour(entry.gap);
    draw_swatch(list, {at.x, at.y + px(2)}, {swatch, swatch}, IM_COL32(c.r, c.g, c.b, 255));
    draw_lines({at.x + swatch + px(6), at.y}, entry.meaning, palette().text);
    at.x += width + px(12);
  }
  ImGui::Dummy({room, at.y + line - from.y});
}

void fault_row(Session& session, const PrecisionFound& found, PrecisionFault fault) {
  const Rgb8 c = precision_fault_colour(fault);
  const std::uint64_t count = found.map.count(fault);
  const std::string label(precision_fault_label(fault));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), swatch = px(14);
  const bool clicked = hit_area("fault/" + fault_key(fault), {px(legend_width), height}, {});
  draw_swatch(*ImGui::GetWindowDrawList(), {at.x, at.y + (height - swatch) / 2}, {swatch, swatch},
              IM_COL32(c.r, c.g, c.b, 255));
  draw_text({at.x + px(20), at.y}, {at.x + px(130), at.y + height}, label, palette().text, 0, Face::small);
  draw_text({at.x + px(130), at.y}, {at.x + px(legend_width), at.y + height}, count_text(count), palette().text, 1,
            Face::mono);
  controls().record("fault/" + fault_key(fault), std::to_string(count));
  tooltip(count > 0 ? "Click: picks one of these pixels." : "No pixel.");
  if (!clicked) return;
  if (const auto pixel = typical_pixel(found.map.faults, fault))
    session.navigate([&](Document& document) {
      document.pixel = *pixel;
      document.picked = found.side;
    });
}

void map_title(const char* text, const char* help) {
  show_text(text, {Face::small});
  tooltip(help);
}

std::string pixel_text(const PrecisionMap& map, Vec2i pixel) {
  const PrecisionFault fault = map.faults.at(pixel.x, pixel.y);
  std::string text = fmt::format("({}, {}): {}", pixel.x, pixel.y,
                                 fault == PrecisionFault::none ? "as in double" : precision_fault_label(fault));
  if (map.gap.empty()) return text;
  const float gap = map.gap.at(pixel.x, pixel.y);
  return text + (std::isinf(gap) ? "; no second surface"
                                 : fmt::format("; second surface {} ulp of stored depth behind",
                                               gap < 1000 ? short_number(static_cast<double>(gap))
                                                          : count_text(static_cast<std::uint64_t>(gap))));
}

}  // namespace

PrecisionTab::PrecisionTab(const PanelHost& host) : Study(host, {}, precision_words) {}

void PrecisionTab::measure(Session& session) {
  start([side = side_, name = session.document().scene_name, scene = session.scene(), view = session.view(),
         settings = session.settings(side_)](StudyControl& control, const Report&) {
    auto result = std::make_shared<PrecisionFound>();
    Prepared prepared;
    result->side = side;
    result->scene_name = name;
    result->map = precision_map(scene, view, settings, prepared, control.progress(), WorkerPriority::background);
    result->faults = fault_picture(result->map);
    result->gaps = gap_picture(result->map);
    return result;
  });
}

void PrecisionTab::took(Session&) {
  textures_[0].upload(found->faults);
  textures_[1].upload(found->gaps);
  for (Texture& texture : textures_) texture.set_shrunk(true);
}

void PrecisionTab::choices(Session& session) { side_choice(session, side_, "Picture A.", "Picture B."); }

std::string PrecisionTab::about(const Session& session) const {
  return found ? fmt::format("{}, picture {}", found->scene_name, letter_of(found->side)) : why_not_b(session);
}

void PrecisionTab::draw_result(Session& session) {
  if (!found) {
    if (work.running()) return;
    return quiet_text(
        "Which pixels differ from a rendering in double: false hits, missed hits, wrong winners and wrong shading; and "
        "how close the depth buffer is to z-fighting.");
  }
  ImGui::BeginGroup();
  for (std::size_t i = 1; i < precision_fault_count; ++i) fault_row(session, *found, static_cast<PrecisionFault>(i));
  ImGui::EndGroup();
  ImGui::SameLine(0, px(14));
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  // The second map's legend is at its right, or below it where that would make the maps smaller.
  const float gap = px(12), legend = px(gap_legend_width), tall = std::max(room.y - 2 * line, px(60));
  const float aspect = static_cast<float>(found->map.faults.width()) / static_cast<float>(found->map.faults.height());
  const bool beside = 2 * tall * aspect + 2 * gap + legend <= room.x;
  const float under = room.y - 5 * line;  // in a low panel the legend is scrolled to
  const ImVec2 each =
      beside ? ImVec2{tall * aspect, tall} : ImVec2{(room.x - gap) / 2, under >= px(160) ? under : tall};
  std::optional<Vec2i> pixel;
  ImGui::BeginGroup();
  map_title("against double", "Pixels that differ from a rendering in double, in the colours at the left.");
  pixel = pixel_map("faults", textures_[0], each, session, found->side);
  if (faultless(found->map)) over_map("no pixel differs from double");
  ImGui::EndGroup();
  ImGui::SameLine(0, gap);
  ImGui::BeginGroup();
  map_title("second surface", "Distance to the second surface, in units in the last place of the stored depth: dark = "
                              "1, light = 2^24, red = below 1, white = no second surface.");
  if (const auto here = pixel_map("gaps", textures_[1], each, session, found->side)) pixel = here;
  if (!beside) gap_legend(each.x, true);
  ImGui::EndGroup();
  if (beside) {
    ImGui::SameLine(0, gap);
    ImGui::BeginGroup();
    ImGui::Dummy({1, theme().font(Face::small)->FontSize});
    gap_legend(legend, false);
    ImGui::EndGroup();
  }
  const std::string text = pixel ? pixel_text(found->map, *pixel) : "";
  show_text(text);
}

namespace {

std::optional<std::string> fault_value(const PrecisionMap& map, std::string_view key) {
  for (std::size_t i = 1; i < precision_fault_count; ++i)
    if (fault_key(static_cast<PrecisionFault>(i)) == key) return script_text(map.counts[i]);
  return {};
}

}  // namespace

void PrecisionTab::offer_found(Values& out) const {
  out.offer_below("why/faults/",
                  [this](std::string_view key) { return found ? fault_value(found->map, key) : std::nullopt; });
}

}  // namespace ps::gui
