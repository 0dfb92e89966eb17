#include "gui/panels/studies/stability_tab.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "gui/panels/options/row_results.h"
#include "gui/panels/studies/bar_plot.h"
#include "gui/panels/studies/experiment_groups.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/option_pair.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double list_width = 290, wide_list = 350, room_for_wide_list = 1100, narrow = 640,
                 little_height = 330;  // pixels at scale 1
constexpr double least_plot = 230;     // below it, the rest is scrolled to
constexpr float curves_share = 0.42f;  // of the height, above a film strip

/// "worst: 6.1 %, robust 0": the worst of the naive method in the figure shown first, with the robust one at its place.
std::string worst_text(const StabilityExperiment& experiment, const std::vector<StabilityRow>& rows) {
  const auto figures = experiment_figures(experiment, rows);
  if (figures.empty()) return "";
  const auto worst = worst_row(figures.front());
  if (!worst) return "";
  const std::string naive = result_text(worst->naive, worst->naive);
  const std::string unit(figures.front().quantity->unit);
  if (std::isnan(worst->robust)) return fmt::format("worst: {} {}", naive, unit);
  const double scale = std::max(std::abs(worst->naive), std::abs(worst->robust));
  return fmt::format("worst: {} {}, robust {}", naive, unit, result_text(worst->robust, scale));
}

void explanation(const StabilityExperiment& experiment, std::span<const StabilityRow> rows) {
  show_paragraph(experiment.title, {Face::bold});
  show_paragraph(experiment.explanation);
  if (const std::string first = first_figure_text(experiment, rows); !first.empty()) {
    value_paragraph("first", first);
  }
  show_paragraph(fmt::format("Safe: {} {}", experiment.safe, set_up_text(experiment.set_up)), {Face::small, true});
  controls().record("explanation", std::string(experiment.explanation));
  controls().record("set-up", std::string(set_up_text(experiment.set_up)));
}

void point_tooltip(const Curves& curves, const ExperimentFigure::Row& row, bool has_picture) {
  begin_tooltip_at_pointer();
  show_text(fmt::format("{}: {}", curves.knob, short_number(row.knob)));
  for (const auto& [name, value] : {std::pair{"naive", row.naive}, std::pair{"robust", row.robust}})
    if (!std::isnan(value))
      show_text(fmt::format("{}: {} {}", name, short_number(value), curves.figure.quantity->unit));
  if (!curves.safe.empty())
    show_text(curves.safe.holds(row.knob) ? "inside the safe window" : "outside the safe window");
  if (has_picture) show_text("Click: opens it in A (naive) and B (robust).");
  end_tooltip();
}

void group_heading(const ExperimentGroup& group) {
  ImGui::Spacing();
  value_text(fmt::format("group/{}", group.option ? group.option->key : "none"), group.title(), {Face::bold, true});
}

/// Pictures belong to the knob of the first figure.
bool of_the_pictures(const StabilityExperiment& experiment, const ExperimentFigure& figure) {
  return experiment.picture &&
         knob_title(experiment, *figure.quantity) == knob_title(experiment, experiment.series.front());
}

}  // namespace

/// What came out, or why there cannot be a result; empty where it is only not measured yet.
std::string StabilityTab::note_of(const StabilityExperiment& experiment) {
  const std::string key(experiment.key);
  if (work.running() && found && found->now == key) return "measuring";
  if (complete(key)) {
    const auto [kept, is_new] = worst_.try_emplace(key);
    if (is_new) kept->second = worst_text(experiment, result_of(key)->rows);
    return kept->second;
  }
  return why_absent(key);
}

/// One experiment of the list: its title, and below it what came out.
void StabilityTab::list_row(const StabilityExperiment& experiment) {
  const float width = ImGui::GetContentRegionAvail().x, edge = px(8);
  const std::string note = note_of(experiment), title = in_lines(experiment.title, width - 2 * edge);
  const float title_height = text_height(title), gap = px(4);
  const ImVec2 at{ImGui::GetCursorScreenPos().x + edge, ImGui::GetCursorScreenPos().y + gap};
  const FontScope small(Face::small);
  const std::string below = in_lines(note, width - 2 * edge);
  const float height = title_height + (note.empty() ? 0 : text_height(below)) + 2 * gap;
  const bool clicked = gui::list_row(experiment.key, {width, height}, &selected() == &experiment);
  {
    const FontScope body(Face::body);
    draw_lines(at, title, palette().text);
  }
  draw_lines({at.x, at.y + title_height}, below, palette().text_quiet);
  controls().record(experiment.key, note);
  if (clicked) select(experiment);
}

void StabilityTab::choices(Session&) {
  if (ImGui::GetContentRegionAvail().x < px(narrow)) experiment_choice();
}

void StabilityTab::experiment_choice() {
  std::vector<Choice> choices;
  std::vector<const StabilityExperiment*> shown;
  int index = 0;
  for (const ExperimentGroup& group : experiment_groups())
    for (const StabilityExperiment* experiment : group.experiments) {
      if (experiment == &selected()) index = static_cast<int>(choices.size());
      choices.push_back({experiment->key, experiment->title, group.title()});
      shown.push_back(experiment);
    }
  if (choice("experiment", choices, index, {.width = std::min(px(240), ImGui::GetContentRegionAvail().x)}))
    select(*shown[static_cast<std::size_t>(index)]);
}

/// The figure that is chosen, or the first one.
std::size_t StabilityTab::shown_figure(const Figures& figures) const {
  const auto chosen =
      std::find_if(figures.begin(), figures.end(), [&](const auto& figure) { return figure.name == series_; });
  return chosen == figures.end() ? 0 : static_cast<std::size_t>(chosen - figures.begin());
}

void StabilityTab::figure_choice(const Figures& figures) {
  if (figures.size() < 2) return;
  int index = static_cast<int>(shown_figure(figures));
  std::vector<Choice> choices;
  float widest = 0;
  for (const ExperimentFigure& figure : figures) {
    choices.push_back({figure.name, figure.name, figure.quantity->title});
    widest = std::max(widest, text_width(figure.name));
  }
  const float room = ImGui::GetFrameHeight() + px(16);  // for the arrow and the frame
  if (choice("series", choices, index, {.width = std::min(widest + room, ImGui::GetContentRegionAvail().x)}))
    series_ = figures[static_cast<std::size_t>(index)].name;
}

/// What is in place of a figure that is not there yet.
const char* StabilityTab::no_figure_text(const StabilityExperiment& experiment) const {
  const bool alone = asked_.size() == 1 && asked_.front() == experiment.key;
  const bool now = alone || (found && found->now == experiment.key);
  return !work.running() ? "Not measured yet: press Measure."
         : now           ? "Measuring."
                         : "Not measured yet: others are being measured.";
}

/// Answers where the plot lies, if it is one over the knob of the pictures.
std::optional<PlotFrame> StabilityTab::curve_area(const StabilityExperiment& experiment, const ExperimentFigure& figure,
                                                  const Area& area, ImVec2 mouse, bool clicked) {
  const bool has_picture = of_the_pictures(experiment, figure);
  Curves curves{
      figure,
      std::string(knob_title(experiment, *figure.quantity)),
      {std::string(naive_name(experiment, *figure.quantity)), std::string(robust_name(experiment, *figure.quantity))},
      figure.quantity->knob.empty() ? experiment.window : SafeWindow{1, 0}};
  std::optional<std::size_t> marked;  // the row of the frame that A and B show
  if (has_picture && strip_.chosen && strip_.chosen_of == experiment.key)
    for (std::size_t i = 0; i < figure.rows.size(); ++i)
      if (figure.rows[i].knob == *strip_.chosen) marked = i;
  const CurvesDrawn drawn = draw_curves(*ImGui::GetWindowDrawList(), area, curves, mouse, marked);
  if (!drawn.cut.empty()) tooltip(drawn.cut);
  if (drawn.hovered) {
    const ExperimentFigure::Row& row = figure.rows[*drawn.hovered];
    point_tooltip(curves, row, has_picture);
    if (clicked && has_picture) begin_opening(opening_, experiment, row.knob);
  }
  if (!has_picture) return {};
  return drawn.frame;
}

/// Draws the figure that is chosen; bars take the height that they need. Answers as curve_area().
std::optional<PlotFrame> StabilityTab::figure_area(const StabilityExperiment& experiment, const Figures& figures,
                                                   float height) {
  const float width = ImGui::GetContentRegionAvail().x;
  if (width < px(80)) return {};
  const ExperimentFigure* figure = figures.empty() ? nullptr : &figures[shown_figure(figures)];
  const bool bars = figure && figure->form == FigureForm::bars;
  MethodNames names;
  if (bars) {
    names = {std::string(naive_name(experiment, *figure->quantity)),
             std::string(robust_name(experiment, *figure->quantity))};
    height = bars_height(*figure, names, width);
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Area area{at, {at.x + width, at.y + height}};
  const bool clicked = ImGui::InvisibleButton("plot", {width, height});
  controls().record("plot", fmt::format("{:.0f}x{:.0f}", width, height));
  const ImVec2 mouse = ImGui::IsItemHovered() ? ImGui::GetIO().MousePos : ImVec2{-1e6f, -1e6f};
  if (!figure) {
    ImGui::GetWindowDrawList()->AddRectFilled(area.min, area.max, colour_u32(palette().field));
    draw_text(area.min, area.max, whole_words(no_figure_text(experiment), width), palette().text_quiet, 0.5f);
    return {};
  }
  if (!bars) return curve_area(experiment, *figure, area, mouse, clicked);
  const std::string cut = draw_bars(*ImGui::GetWindowDrawList(), area, *figure, names, mouse);
  if (!cut.empty()) tooltip(cut);
  return {};
}

/// The option that the experiment is about, of A and of B, to see it act in the pictures.
void StabilityTab::option_switch(Session& session, const StabilityExperiment& experiment) {
  const Option* option = option_of(experiment);
  if (!option || !session.has_scene()) return;
  std::array<Settings, 2> settings{session.settings(Side::a), session.settings(Side::b)};
  const auto results = option_pair(*option, settings, session.traits(), {.picked = session.document().picked});
  for (const Side side : both_sides) {
    const OptionRowResult& result = results[index_of(side)];
    if (result.request == OptionRequest::sweep) {
      host_.send(SweepOption{option, side});
      host_.send(ShowTool{"chart", ShowTool::Room::as_there_is});
    }
    take_row_result(session, side, *option, settings[index_of(side)], result);
  }
}

/// Where there is little height the curves come first and the words follow below, to be scrolled to; the options are
/// beside the pictures then.
void StabilityTab::shown_experiment(Session& session) {
  const StabilityExperiment& experiment = selected();
  const MeasuredExperiment* result = result_of(experiment.key);
  const std::span<const StabilityRow> rows = result ? std::span(result->rows) : std::span<const StabilityRow>{};
  const auto figures = experiment_figures(experiment, rows);
  const bool low = ImGui::GetContentRegionAvail().y < px(little_height);
  if (!low) {
    option_switch(session, experiment);
    explanation(experiment, rows);
  }
  if (const std::string reason = why_absent(experiment.key); !reason.empty()) {
    quiet_text(fmt::format("Not measured: {}.", reason));
    controls().record("absent", reason);
    return;
  }
  figure_choice(figures);
  if (figures.size() > 1 && experiment.picture) same_line_if_room(px(film_slider_width), px(16));
  if (const auto knob = film_strip_slider(strip_, experiment)) begin_opening(opening_, experiment, *knob);
  const bool strip = experiment.picture && !experiment.frames.empty();
  const float room = ImGui::GetContentRegionAvail().y;
  const float height = std::max(strip && !low ? room * curves_share : room, px(least_plot));
  const auto frame = figure_area(experiment, figures, height);
  if (low) explanation(experiment, rows);
  if (const auto knob = film_strip_view(strip_, experiment, frame && !low ? &*frame : nullptr))
    begin_opening(opening_, experiment, *knob);
}

void StabilityTab::list() {
  const bool much = ImGui::GetContentRegionAvail().x >= px(room_for_wide_list);
  ImGui::BeginChild("list", {px(much ? wide_list : list_width), 0});
  search_box("search", search_, "Find an experiment");
  ImGui::BeginChild("rows");
  bool any = false;
  for (const ExperimentGroup& group : experiment_groups()) {
    bool headed = false;
    for (const StabilityExperiment* experiment : group.experiments) {
      if (!experiment_matches(*experiment, search_)) continue;
      if (!std::exchange(headed, true)) group_heading(group);
      any = true;
      list_row(*experiment);
    }
  }
  if (!any) {
    value_paragraph("nothing-found", "No experiment matches.", {.quiet = true});
  }
  ImGui::EndChild();
  ImGui::EndChild();
}

void StabilityTab::draw_result(Session& session) {
  if (ImGui::GetContentRegionAvail().x >= px(narrow)) {
    list();
    ImGui::SameLine(0, px(14));
  }
  ImGui::BeginChild("experiment");
  shown_experiment(session);
  ImGui::EndChild();
}

}  // namespace ps::gui
