#include "gui/panels/studies/needs_known.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "gui/widgets/draw.h"
#include "gui/widgets/tick.h"
#include "gui/widgets/widgets.h"
#include "options/option.h"
#include "study/features.h"
#include "study/setting_words.h"

namespace ps::gui {
namespace {

constexpr double tick_room = 20, least_words = 170;  // at scale 1

float widest_label() {
  float widest = 0;
  for (const Feature& feature : features()) widest = std::max(widest, text_width(feature.label));
  return widest;
}

/// "Shadows: traced"
std::string setting_of(const Feature& feature, const Settings& settings) {
  const Option* option = find_option(feature.option);
  return option ? setting_words(fmt::format("{}={}", option->key, option_text(*option, settings))) : std::string();
}

}  // namespace

void needs_known(const Settings& settings, const SceneTraits& traits, char letter) {
  const NameScope scope("known");
  {
    const FontScope bold(Face::bold);
    value_paragraph("title", fmt::format("What the options of {} use in this scene, before measuring", letter));
  }
  const float space = ImGui::GetContentRegionAvail().x, left = px(tick_room) + widest_label() + px(24);
  const auto columns = std::max(1, static_cast<int>(space / (left + px(least_words))));
  if (!ImGui::BeginTable("features", columns)) return;
  for (const Feature& feature : features()) {
    ImGui::TableNextColumn();
    const auto reason = unused_reason(feature, settings, traits);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float room = std::max(px(80), ImGui::GetContentRegionAvail().x - left);
    const std::string words = reason ? fmt::format("not used: {}", *reason) : setting_of(feature, settings);
    const std::string lines = in_lines(words, room);
    if (!reason) draw_tick({at.x - px(2), at.y}, ImGui::GetTextLineHeight());
    const ImVec4& ink = reason ? palette().text_quiet : palette().text;
    draw_lines({at.x + px(tick_room), at.y}, feature.label, ink);
    draw_lines({at.x + left, at.y}, lines, ink);
    ImGui::Dummy({left + room, text_height(lines)});
    controls().record(feature.name, words);
  }
  ImGui::EndTable();
}

}  // namespace ps::gui
