#include "gui/panels/studies/needs_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <optional>

#include "gui/panels/pictures/picture_text.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/scene_settings.h"
#include "study/needs_words.h"
#include "study/setting_words.h"

namespace ps::gui {
namespace {

constexpr double number_width = 62, least_bar = 30;           // pixels at scale 1
constexpr double thumbnail_height = 64, large_picture = 300;  // pixels at scale 1

/// A number with a bar of that share of the cell, and a line at `limit` if there is one.
void bar_cell(std::string_view name, double share, const std::string& text, std::optional<double> limit = {}) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  const float digits = px(number_width), bar = std::max(room - digits - px(8), px(least_bar));
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

/// One line over the width of the cell, cut where it is too long.
void cell_line(std::string_view text, const ImVec4& colour, Face face = Face::body) {
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

std::string changes_text(const Settings& from, const Settings& to) {
  return fmt::format("{}", fmt::join(settings_difference(from, to), ", "));
}

/// A fraction of the time, or "within noise".
void time_cell(const FeatureShare& share) {
  if (share.cost_differs) return bar_cell("time", share.cost_share, percent(share.cost_share));
  const std::string text = "within noise";
  cell_line(text, palette().text_quiet);
  controls().record("time", text);
}

float thumbnail_width(const Needs& needs) {
  if (!needs.picture || needs.picture->height() < 1) return px(thumbnail_height);
  return px(thumbnail_height) * static_cast<float>(needs.picture->width()) /
         static_cast<float>(needs.picture->height());
}

void thumbnail_cell(NeedsThumbnails& thumbnails, std::string_view name,
                    const std::shared_ptr<const Image<Rgb8>>& picture) {
  ImGui::TableNextColumn();
  if (!picture) return;
  NeedsThumbnails::One& one = thumbnails.pictures[std::string(name)];
  if (one.of != picture) {
    one.of = picture;
    one.texture.upload(*picture);
    one.texture.set_shrunk(true);
  }
  const float shape = static_cast<float>(picture->width()) / static_cast<float>(std::max(picture->height(), 1));
  ImGui::Image(one.texture.id(), {px(thumbnail_height) * shape, px(thumbnail_height)});
  controls().record("thumbnail", fmt::format("{}x{}", picture->width(), picture->height()));
  if (!begin_tooltip()) return;
  ImGui::Image(one.texture.id(), {px(large_picture) * shape, px(large_picture)});
  end_tooltip();
}

void free_features(const Needs& needs) {
  for (const FeatureShare& share : needs.shares) {
    if (share.used) continue;
    const std::string text = needs_free_sentence(share);
    quiet_text(text);
    controls().record(fmt::format("free/{}", share.feature.name), text_of(share.reason));
  }
}

/// What became of the time, which need not follow the work.
std::string time_sentence(const Needs& needs) {
  const bool less_work = needs.work < needs.default_work;
  const double saved = needs.default_time_ms > 0 ? 1 - needs.time_ms / needs.default_time_ms : 0;
  const std::string times =
      fmt::format("{} ms instead of {} ms", short_number(needs.time_ms), short_number(needs.default_time_ms));
  if (!needs.time_differs)
    return fmt::format("{}the time is the same within noise: {}.", less_work ? "Less work, but here " : "Here ", times);
  if (saved > 0) return fmt::format("Here the time is less, too: {}.", times);
  return fmt::format("{}: {}.",
                     less_work ? "Less work, but not less time here: tests and fragments do not all take equally long"
                               : "It takes more time here",
                     times);
}

}  // namespace

NeedsAdvice needs_advice(const Needs& needs, const Settings& base) {
  NeedsAdvice words;
  words.changes = changes_text(base, needs.advice);
  words.words = settings_in_words(words.changes);
  if (words.changes.empty()) {
    words.verdict = keep_sentence();
    return words;
  }
  const double work = needs.default_work > 0
                          ? 100.0 * (1 - static_cast<double>(needs.work) / static_cast<double>(needs.default_work))
                          : 0;
  if (needs.within_tolerance)
    words.verdict = fmt::format(
        "{:.0f} % of the counted work can be saved. That adds a FLIP of {} to the worst tile (allowed: {}, {}).", work,
        short_number(needs.increase), short_number(needs.tolerance), tolerance_words(needs.tolerance));
  else
    words.verdict = not_enough_sentence(needs);
  words.saving = fmt::format("Work is counted and the same on every computer: {} instead of {} rays, tests, fragments "
                             "and reads of textures and maps.",
                             count_text(needs.work), count_text(needs.default_work));
  words.time = time_sentence(needs);
  if (!needs.machinery.empty()) words.time += fmt::format(" Timed {}.", needs.machinery);
  return words;
}

void needs_shares(const Needs& needs, bool timed, NeedsThumbnails& thumbnails) {
  double largest = needs.tolerance * 1.5;
  bool any = false;
  for (const FeatureShare& share : needs.shares) {
    largest = std::max(largest, share.increase);
    any = any || share.used;
  }
  ImGui::Spacing();
  if (any && ImGui::BeginTable("shares", timed ? 5 : 4, ImGuiTableFlags_SizingStretchProp)) {
    ImGui::TableSetupColumn("thumbnail", ImGuiTableColumnFlags_WidthFixed, thumbnail_width(needs));
    ImGui::TableSetupColumn("feature", ImGuiTableColumnFlags_WidthStretch, 0.8f);
    ImGui::TableSetupColumn("picture", ImGuiTableColumnFlags_WidthStretch, 1.5f);  // it has the longest heading
    ImGui::TableSetupColumn("work", ImGuiTableColumnFlags_WidthStretch, 1);
    if (timed) ImGui::TableSetupColumn("time", ImGuiTableColumnFlags_WidthStretch, 1);
    ImGui::TableNextRow();
    column_heading("Picture", "The picture without the feature.");
    column_heading("Without", "The feature that is switched off.");
    column_heading("Error grows by, FLIP of the worst tile",
                   "How much the mean FLIP of a tile against the truth grows, where it grows most. The line marks the "
                   "tolerance.");
    column_heading("Work saved", "Fraction of the rays, intersection tests, fragments and texel reads.");
    if (timed)
      column_heading(
          "Time saved",
          "Fraction of the time of one picture on this computer. Below 0: the picture takes longer without it. Within "
          "noise: the interquartile ranges of the runs overlap, or the times differ by less than 10 %.");
    if (needs.picture) {
      ImGui::TableNextRow();
      thumbnail_cell(thumbnails, "", needs.picture);
      name_cell("nothing: as it is");
      ImGui::TableNextColumn();
      bar_cell("as-it-is", 0, "0", needs.tolerance / largest);
    }
    for (const FeatureShare& share : needs.shares) {
      if (!share.used) continue;
      const NameScope scope(share.feature.name);
      ImGui::TableNextRow();
      thumbnail_cell(thumbnails, share.feature.name, share.picture);
      name_cell(share.feature.label);
      ImGui::TableNextColumn();
      bar_cell("picture", share.increase / largest, fmt::format("{:.3f}", share.increase), needs.tolerance / largest);
      ImGui::TableNextColumn();
      bar_cell("work", share.work_share, percent(share.work_share));
      if (!timed) continue;
      ImGui::TableNextColumn();
      time_cell(share);
    }
    ImGui::EndTable();
  }
  quiet_text(settings_in_words(truth_sentence(needs)));
  free_features(needs);
}

void needs_trail(const Needs& needs) {
  const float digits = px(number_width + 20);
  if (!ImGui::BeginTable("trail", 4, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("taken", ImGuiTableColumnFlags_WidthFixed, px(52));
  ImGui::TableSetupColumn("change", ImGuiTableColumnFlags_WidthFixed,
                          std::min(px(250), ImGui::GetContentRegionAvail().x * 0.4f));
  ImGui::TableSetupColumn("error", ImGuiTableColumnFlags_WidthFixed, digits);
  ImGui::TableSetupColumn("work", ImGuiTableColumnFlags_WidthFixed, digits);
  ImGui::TableNextRow();
  column_heading("", "");
  column_heading("Tried", "Changes one setting at a time and takes the cheapest one within the tolerance.");
  column_heading("Error", "How much the mean FLIP of a tile grows, where it grows most.");
  column_heading("Work", "Rays, intersection tests, fragments and texel reads.");
  for (std::size_t i = 0; i < needs.trail.size(); ++i) {
    const NeedsStep& step = needs.trail[i];
    ImGui::TableNextRow();
    if (step.accepted) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, colour_u32(palette().selection));
    ImGui::TableNextColumn();
    if (step.accepted) show_text("taken");
    name_cell(setting_words(step.change));
    controls().record(fmt::format("trail/{}", i), step.change);
    tooltip(step.change);
    number_cell(fmt::format("{:.3f}", step.increase), full_number(step.increase));
    number_cell(count_text(step.work), full_number(static_cast<double>(step.work)));
  }
  ImGui::EndTable();
}

}  // namespace ps::gui
