#include "gui/panels/studies/model_tab.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "base/check.h"
#include "base/enumerators.h"
#include "base/kept_inputs.h"
#include "base/sentence.h"
#include "gui/panels/pictures/picture_text.h"
#include "gui/panels/studies/reduced_scene.h"
#include "gui/panels/studies/table_cells.h"
#include "gui/widgets/widgets.h"
#include "scene/load.h"
#include "study/model/model_files.h"
#include "study/model/model_words.h"
#include "study/model/views.h"
#include "study/needs_words.h"

namespace ps::gui {
namespace {

constexpr StudyWords model_words{
    .name = "model",
    .title = "Model",
    .measure = "Find out",
    .again = "Find again",
    .help =
        "Leaves out what no ray and no fragment shows, then what hardly shows. Each step is drawn afresh by rays and "
        "by fragments. The time is estimated from small pictures.",
    .preparing = "drawing the full scene",
    .unit = "parts weighed"};

constexpr int views_around = 8;
constexpr std::size_t most_things = 6;  ///< of one row, that are listed below it

/// "31 %", "less than 1 %"; empty for none.
std::string share_text(double share) {
  if (share == 0) return "0";
  return share > 0 && share < 0.001 ? "< 0.1 %" : percent(share);
}

void share_cell(std::string_view name, std::optional<double> share) {
  ImGui::TableNextColumn();
  if (share) bar_cell(name, *share, share_text(*share));
}

void thing_rows(const ModelSaving& saving, const ModelNeeds& needs) {
  const double all = static_cast<double>(std::max<std::uint64_t>(needs.default_bytes, 1));
  for (std::size_t i = 0; i < std::min(saving.things.size(), most_things); ++i) {
    const ModelThing& thing = saving.things[i];
    const NameScope scope(fmt::format("{}", i));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::Indent(px(14));
    cell_line(thing.name, palette().text_quiet);
    ImGui::Unindent(px(14));
    tooltip(thing.name);
    share_cell("picture", thing.picture);
    share_cell("work", thing.work);
    share_cell("bytes", thing.bytes > 0 ? std::optional(static_cast<double>(thing.bytes) / all) : std::nullopt);
  }
  if (saving.things.size() <= most_things) return;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  cell_line(fmt::format("   and {} more", saving.things.size() - most_things), palette().text_quiet);
}

/// A row for each saving, the greatest first.
void savings_table(const ModelNeeds& needs) {
  if (needs.savings.empty() || !ImGui::BeginTable("savings", 4, ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch, 1.7f);
  for (const char* column : {"picture", "work", "bytes"})
    ImGui::TableSetupColumn(column, ImGuiTableColumnFlags_WidthStretch, 1);
  ImGui::TableNextRow();
  column_heading("What can go",
                 "The greatest saving first. Each row goes together with those that were found before it.");
  column_heading("Picture", "Share of the pixels in which it shows: itself, its shadow or its mirror image.");
  column_heading("Work saved", "Fraction of the rays, intersection tests, fragments and texel reads.");
  column_heading("Bytes saved", "Fraction of all bytes of vertices, triangles, texels, objects, materials and lights.");
  for (const ModelSaving* saving : greatest_first(needs)) {
    const NameScope scope(enumerator_key(saving->part));
    ImGui::TableNextRow();
    const std::string goes =
        begun_large(saving->goes) + (saving->kept.empty() ? "" : fmt::format(": {}", saving->kept));
    name_cell(goes);
    controls().record("goes", goes);
    ImGui::TableNextColumn();
    share_cell("work", saving->work);
    share_cell("bytes", saving->bytes);
    thing_rows(*saving, needs);
  }
  ImGui::EndTable();
}

/// For what the reduced scene holds, and how well.
std::string bound_words(const ModelNeeds& needs) {
  return fmt::format("{}, by rays and by fragments: the worst tile changes by a FLIP of {} (allowed: {}, {})",
                     views_words(needs.views), short_number(needs.change.increase), short_number(needs.tolerance),
                     tolerance_words(needs.tolerance));
}

}  // namespace

ModelTab::ModelTab(const PanelHost& host, const StudyFolder& results)
    : EstimatedStudy(host, {}, model_words), results_(results) {}

ModelRequest ModelTab::request_for(const Session& session) const {
  ModelRequest request;
  request.scene = session.scene();
  request.views = {session.view()};
  request.base = session.settings(side_);
  request.tolerance = tolerance_;
  request.priority = WorkerPriority::background;
  return request;
}

void ModelTab::measure(Session& session) {
  measured_ = request_for(session);
  measured_side_ = side_;
  scene_name_ = session.document().scene_name;
  key_ = picture_key(session, side_);
  start([request = measured_, views = views_](StudyControl& control, const Report& report) mutable {
    if (views == Views::around)
      request.views = orbit_views(request.scene, request.views.front(), views_around, control);
    return std::make_shared<const ModelNeeds>(
        find_model_needs(request, control, [&](const StudyStatus& status) { report(status, nullptr); }));
  });
}

void ModelTab::keep_estimate(Session& session) {
  ModelRequest request = request_for(session);
  if (views_ == Views::around) request.views.resize(views_around, request.views.front());
  if (estimate_lacks(fmt::format("{} {} views", picture_key(session, side_), request.views.size())))
    begin_estimate(estimate_model, std::move(request));
}

std::string ModelTab::expected() const {
  const auto known = estimate.found();
  return known ? at_least(known->seconds) : unknown_time();
}

void ModelTab::choices(Session& session) {
  side_choice(session, side_, "With the options of picture A.", "With the options of picture B.");
  static constexpr std::array views{Choice{"one", "This view", "The reduced scene need only hold for the picture."},
                                    Choice{"around", "8 around", "Eight views on a circle around what is seen."}};
  same_line_if_room(px(170), px(8));
  choice_of("views", views, views_, {.width = px(170)});
  tolerance_control(tolerance_);
}

std::string ModelTab::about(const Session& session) const {
  if (!found) return why_not_b(session);
  return fmt::format("{}, options of {}, {}. {} pictures drawn.{}", scene_name_, letter_of(measured_side_),
                     bound_words(*found), found->pictures,
                     key_ == picture_key(session, measured_side_) ? "" : " Scene, view or options have changed since.");
}

void ModelTab::use(Session& session) {
  open_reduced(session, found, measured_.base, results_.scenes() / "reduced" / std::to_string(session.change()));
}

void ModelTab::ask_file() {
  host_.ask_file({.title = "Save the reduced scene",
                  .extensions = {".scene"},
                  .hint = "reduced.scene",
                  .suggestion = "reduced.scene",
                  .answer = [this, needs = found, view = measured_.views.front()](const FileAnswer& file) {
                    session_.say_saved([&] {
                      require_no_input(file.path, files_of(session_.document().base));
                      save_reduced(*needs, view, file.path);
                      return fmt::format("Saved {}, with its models and textures beside it.", file.path.string());
                    });
                  }});
}

void ModelTab::more_controls(Session& session) {
  if (!found || found->savings.empty() || work.running()) return;
  const bool changed = key_ != picture_key(session, measured_side_);
  same_line_if_room(button_width("Apply"), px(8));
  if (button("apply", "Apply", Emphasis::primary,
             {.tooltip = "A renders the reduced scene, B shows the full one. Undo brings all back.",
              .disabled = changed ? "Scene, view or options have changed since." : ""}))
    use(session);
  same_line_if_room(button_width("Save as .scene"), px(3));
  if (button("save", "Save as .scene", Emphasis::plain,
             {.tooltip = "The reduced scene, with its models as OBJ and its textures as PNG files beside it."}))
    ask_file();
}

void ModelTab::draw_result(Session&) {
  if (!found) {
    if (work.running()) return;
    ImGui::Spacing();
    return quiet_text(
        "What of this scene would no pixel miss? Objects and triangles that no ray and no fragment shows, texels finer "
        "than a pixel, lights, bounces and samples. Each step is drawn afresh, by rays and by fragments, and is taken "
        "only if no tile changes by more than the tolerance.");
  }
  value_paragraph("sentence", model_sentence(*found), {Face::bold});
  savings_table(*found);
  for (const std::string& remark : found->remarks) quiet_text(remark);
}

std::optional<std::string> ModelTab::value(std::string_view name) const {
  if (!found) return {};
  if (name == "sentence") return model_sentence(*found);
  if (name == "increase") return script_text(found->change.increase);
  if (name == "work") return script_text(found->work);
  if (name == "default-work") return script_text(found->default_work);
  if (name == "bytes") return script_text(found->bytes);
  if (name == "default-bytes") return script_text(found->default_bytes);
  if (name == "views") return script_text(static_cast<int>(found->views));
  return {};
}

void ModelTab::offer_found(Values& out) const {
  out.offer_below("model/", [this](std::string_view name) { return value(name); });
}

}  // namespace ps::gui
