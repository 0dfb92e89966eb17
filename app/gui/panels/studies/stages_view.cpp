#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/studies/pixel_map.h"
#include "gui/panels/studies/why_tab.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double stage_legend_width = 300, name_end = 132, count_end = 214;  // pixels at scale 1

/// As tall as a control, or less where all causes would not fit the room.
float row_height(float room) {
  const FontScope small(Face::small);
  const float least = ImGui::GetTextLineHeight() + px(1);
  return std::clamp(room / static_cast<float>(stage_cause_count - 1), least, ImGui::GetFrameHeight());
}

/// A cause with its colour, the number of its pixels and their share. A click picks one of them.
void stage_row(Session& session, const StagesFound& found, StageCause cause, float height) {
  const StageShare& share = found.split.share(cause);
  const std::string key = "stage/" + stage_key(cause);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float swatch = std::min(px(14), height - px(2));
  const bool clicked = hit_area(key, {px(stage_legend_width), height}, {});
  const Rgb8 c = stage_cause_colour(cause);
  auto& list = *ImGui::GetWindowDrawList();
  const float top = at.y + (height - swatch) / 2;
  list.AddRectFilled({at.x, top}, {at.x + swatch, top + swatch}, IM_COL32(c.r, c.g, c.b, 255));
  list.AddRect({at.x, top}, {at.x + swatch, top + swatch}, colour_u32(palette().line_strong));
  {
    const FontScope small(Face::small);
    draw_text({at.x + px(20), at.y}, {at.x + px(name_end), at.y + height}, std::string(stage_cause_label(cause)),
              palette().text, 0);
  }
  {
    const FontScope mono(Face::mono);
    draw_text({at.x + px(name_end), at.y}, {at.x + px(count_end), at.y + height},
              count_text(static_cast<std::uint64_t>(share.pixels)), palette().text, 1);
    draw_text({at.x + px(count_end), at.y}, {at.x + px(stage_legend_width), at.y + height},
              fmt::format("{:.1f} %", 100 * found.split.part(cause)), palette().text, 1);
  }
  controls().record(key, std::to_string(share.pixels));
  tooltip(fmt::format("{} {} in colour, {} in what is seen.{}", stage_cause_help(cause), share.colours, share.ids,
                      share.pixels > 0 ? " Click: picks one of these pixels." : ""));
  if (!clicked) return;
  if (const auto pixel = typical_pixel(found.split.causes, cause))
    session.navigate([&](Document& document) { document.pixel = *pixel; });
}

std::string pixel_line(const StageSplit& split, Vec2i pixel) {
  const StageCause cause = split.causes.at(pixel.x, pixel.y);
  return fmt::format("({}, {}): {}", pixel.x, pixel.y,
                     cause == StageCause::none ? "equal within one level of 255" : stage_cause_label(cause));
}

}  // namespace

void stages_view(Session& session, WhyTabState& state) {
  if (!state.split) {
    if (state.stages.running()) return quiet_text("Drawing the pixels that differ again, stage by stage.");
    if (state.stages.state() == StudyState::failed) return quiet_text("Failed: " + state.stages.message());
    const auto reason = why_no_stages(session.traits(), session.settings(Side::a), session.settings(Side::b));
    return quiet_text(reason
                          ? *reason
                          : "Which stage makes hardware and rasterizer differ? Each pixel that differs is drawn again "
                            "with one stage's values taken from the driver, until it is equal.");
  }
  const StagesFound& found = *state.split;
  const bool old = !(session.settings(Side::a) == found.compared[0] && session.settings(Side::b) == found.compared[1]);
  const StageShare& whole = found.split.whole;
  quiet_text(
      fmt::format("{} of {} pixels differ: {} in colour, {} in what is seen{}",
                  count_text(static_cast<std::uint64_t>(whole.pixels)), count_text(found.split.causes.pixels().size()),
                  count_text(static_cast<std::uint64_t>(whole.colours)),
                  count_text(static_cast<std::uint64_t>(whole.ids)), old ? ". The options have changed since." : ""));
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0});
  const float height = row_height(ImGui::GetContentRegionAvail().y);
  for (std::size_t i = 1; i < stage_cause_count; ++i) stage_row(session, found, static_cast<StageCause>(i), height);
  ImGui::PopStyleVar();
  ImGui::EndGroup();
  ImGui::SameLine(0, px(14));
  ImGui::BeginGroup();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float tall = std::max(room.y - ImGui::GetTextLineHeightWithSpacing(), px(60));
  const auto pixel = pixel_map("stages-map", state.stages_texture, {room.x, tall}, session, session.document().picked);
  const std::string text = pixel ? pixel_line(found.split, *pixel) : "";
  ImGui::TextUnformatted(text.c_str());
  ImGui::EndGroup();
}

}  // namespace ps::gui
