#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "frame/display_frame.h"
#include "gui/panels/studies/why_tab.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr StudyWords missing_words_of_study{
    .name = "missing",
    .title = "What is missing",
    .measure = "Find out",
    .again = "Find again",
    .help = "Renders A without each feature, light and object, and with other values and other ways to store levels, "
            "and names what gives the file.",
    .preparing = "rendering A",
    .unit = "pictures"};

constexpr std::size_t most_changes_shown = 12;
constexpr double level_column = 84, missing_table_width = 620;  // pixels at scale 1

std::string file_name(const PictureFile& file) { return std::filesystem::path(file.path).filename().string(); }

float table_room() { return std::min(px(missing_table_width), ImGui::GetContentRegionAvail().x); }

std::string signed_level(int level) { return level == 0 ? "0" : fmt::format("{:+}", level); }

void levels_row(const std::string& name, std::string_view text, const std::array<int, 3>& levels) {
  numbers_row(text);
  for (const int level : levels) number_cell(signed_level(level), std::to_string(level));
  controls().record(name, fmt::format("{} {} {}", levels[0], levels[1], levels[2]));
}

/// B minus A beside what each row of A's sum adds, in levels; rows that explain it are bold.
void pixel_rows(Session& session) {
  const auto term = missing_term_of(session);
  const auto story = session.story(Side::a);
  if (!term) return value_paragraph("pixel", "Click a pixel: the rows of its sum are compared with the file here.");
  value_paragraph("pixel", fmt::format("At ({}, {}): {}", story->pixel.x, story->pixel.y, term->sentence),
                  {Face::bold});
  if (term->rows.empty() || !begin_numbers("rows", 3, {.numbers = px(level_column), .all = table_room()})) return;
  {
    const TextScope quiet({Face::small, true});
    numbers_row("Levels of 255");
    for (const char* channel : {"red", "green", "blue"}) number_cell(channel, channel);
  }
  levels_row("pixel/difference", "B − A", term->difference);
  for (const TermRow& row : term->rows) {
    const LedgerLine& line = story->ledger[row.line];
    const bool named = std::find(term->named.begin(), term->named.end(), row.line) != term->named.end();
    const TextScope scope({named ? Face::bold : Face::body});
    levels_row(fmt::format("pixel/row/{}", row.line),
               std::string(2 * static_cast<std::size_t>(line.level), ' ') + line.term, row.adds);
  }
  ImGui::EndTable();
}

/// The changes of A that come nearest, each alone.
void changes_table(const MissingFeature& feature) {
  if (feature.single.empty() || !begin_numbers("changes", 3, {.numbers = px(level_column), .all = table_room()}))
    return;
  {
    const TextScope quiet({Face::small, true});
    numbers_row("A with one change, share of the pixels");
    number_cell("equal", "pixels with the levels of the file");
    number_cell("within 1", "pixels of which no channel is more than one level off");
    number_cell("mean", "mean difference of a channel, in levels");
  }
  const auto row = [](const MissingMatch& match) {
    numbers_row(missing_words(match));
    number_cell(fmt::format("{:.1f} %", 100 * match.equal_share()), full_number(match.equal_share()));
    number_cell(fmt::format("{:.1f} %", 100 * match.near_share()), full_number(match.near_share()));
    number_cell(short_number(match.mean), full_number(match.mean));
  };
  row(feature.as_is);
  for (std::size_t i = 0; i < std::min(most_changes_shown, feature.single.size()); ++i) row(feature.single[i]);
  ImGui::EndTable();
}

}  // namespace

std::optional<MissingTerm> missing_term_of(Session& session) {
  const auto file = session.picture_b();
  const auto story = session.story(Side::a);
  if (!file || !story || !file->levels.contains(story->pixel.x, story->pixel.y)) return {};
  return find_missing_term(*story, display_transform(session.settings(Side::a)),
                           file->levels.at(story->pixel.x, story->pixel.y));
}

MissingTab::MissingTab(const PanelHost& host) : Study(host, {}, missing_words_of_study) {}

void MissingTab::measure(Session& session) {
  auto result = std::make_shared<MissingFound>(MissingFound{session.picture_b(), session.settings(Side::a), {}});
  MissingRequest request{.scene = session.scene(),
                         .view = session.view(),
                         .settings = result->settings,
                         .file = result->file->levels,
                         .priority = WorkerPriority::background};
  start([request = std::move(request), result](StudyControl& control, const Report& report) {
    result->feature =
        find_missing_feature(request, control, [&](const StudyStatus& status) { report(status, nullptr); });
    return result;
  });
}

std::string MissingTab::about(const Session& session) const {
  if (!found) return {};
  const bool old = found->file != session.picture_b() || !(found->settings == session.settings(Side::a));
  return fmt::format("{} changes tried, {} pictures rendered.{}", found->feature.candidates, found->feature.renders,
                     old ? " The options of A or the file have changed since." : "");
}

void MissingTab::draw_result(Session& session) {
  if (found) {
    value_paragraph("sentence", missing_sentence(found->feature, file_name(*found->file)), {Face::bold});
    ImGui::Spacing();
  } else if (!work.running()) {
    quiet_text(
        "A file has no options whose share could be measured. But A can be rendered without each of its features, "
        "lights and objects, and stored in other ways: what makes the file is named with its share of the pixels.");
    ImGui::Spacing();
  }
  pixel_rows(session);
  if (!found) return;
  ImGui::Spacing();
  changes_table(found->feature);
}

void MissingTab::offer_found(Values& out) const {
  const auto offer = [&](const char* name, std::string (*value)(const MissingFeature&)) {
    out.offer_below(name, [this, value](std::string_view rest) {
      return found && rest.empty() ? std::optional(value(found->feature)) : std::nullopt;
    });
  };
  offer("missing/changes",
        [](const MissingFeature& feature) { return fmt::format("{}", fmt::join(feature.best.keys, ";")); });
  offer("missing/share", [](const MissingFeature& feature) { return script_text(feature.best.equal_share()); });
}

}  // namespace ps::gui
