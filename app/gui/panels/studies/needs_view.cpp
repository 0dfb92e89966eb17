#include "gui/panels/studies/needs_view.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <optional>

#include "gui/panels/pictures/picture_text.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"
#include "options/difference_words.h"
#include "options/scene_settings.h"
#include "study/needs_words.h"

namespace ps::gui {
namespace {

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

void needs_shares(const Needs& needs, bool timed, SmallPictures& thumbnails) {
  double largest = needs.tolerance * 1.5;
  bool any = false;
  for (const FeatureShare& share : needs.shares) {
    largest = std::max(largest, share.increase);
    any = any || share.used;
  }
  ImGui::Spacing();
  if (any && ImGui::BeginTable("shares", timed ? 5 : 4, ImGuiTableFlags_SizingStretchProp)) {
    ImGui::TableSetupColumn("thumbnail", ImGuiTableColumnFlags_WidthFixed, thumbnail_width(needs.picture));
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
  if (const std::string meshes = mesh_bytes_text(needs.meshes); !meshes.empty()) {
    value_paragraph("meshes", fmt::format("Its meshes: {}.", meshes));
    tooltip("In single precision. Shared: each vertex once, and three indices a triangle. Unshared: three vertices a "
            "triangle (CGPP 15.4).");
  }
  unused_features(needs.shares);
}

void unused_features(std::span<const FeatureShare> shares) {
  value_paragraph("unused", unused_sentence(shares), {.quiet = true});
}

void needs_trail(const Needs& needs) {
  const float digits = px(cell_digits_width + 10);
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
