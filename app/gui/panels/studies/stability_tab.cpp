#include "gui/panels/studies/stability_tab.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "gui/panels/studies/bar_plot.h"
#include "gui/panels/studies/pause_and_stop.h"
#include "gui/widgets/draw.h"
#include "gui/widgets/shorten.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr double list_width = 290, wide_list = 350, room_for_wide_list = 1100, narrow = 640,
                 little_height = 330;  // pixels at scale 1
constexpr double least_plot = 230;     // below it, the rest is scrolled to
constexpr float curves_share = 0.42f;  // of the height, above a film strip

const StabilityExperiment& selected(const StabilityTabState& state) {
  for (const StabilityExperiment& experiment : stability_experiments())
    if (experiment.key == state.selected) return experiment;
  return stability_experiments().front();
}

bool complete(const StabilityTabState& state, std::string_view key) {
  const auto found = state.measured.find(key);
  return found != state.measured.end() && found->second.complete;
}

/// Why this machine could not measure it; empty where it could, or where that was not asked.
std::string why_absent(const StabilityTabState& state, std::string_view key) {
  const auto found = state.measured.find(key);
  return found == state.measured.end() ? "" : found->second.absent;
}

/// Begins or goes on with experiments, whose results are kept in the folder.
void begin(StabilityTabState& state, std::vector<std::string> keys, StabilityRequest::Kept kept) {
  StabilityRequest request;
  request.keys = state.asked = std::move(keys);
  request.folder = state.folder;
  request.kept = kept;
  state.of_step.forget();
  state.study.start([request](StudyControl& control, const StabilityStudy::Publish& publish) {
    auto newest = std::make_shared<const StabilityFound>();
    run_stability(request, control, [&](const MeasuredExperiment& experiment, const StudyStatus& status) {
      auto next = std::make_shared<StabilityFound>(*newest);
      next->measured.insert_or_assign(experiment.key, experiment);
      next->now = experiment.complete ? "" : experiment.key;
      newest = next;
      publish(newest, status);
    });
  });
}

void look_into_folder(StabilityTabState& state) {
  if (std::exchange(state.looked, true)) return;
  StabilityRequest request;
  request.folder = state.folder;
  for (MeasuredExperiment& experiment : read_stability(request))
    if (experiment.complete) state.measured.insert_or_assign(experiment.key, std::move(experiment));
}

/// Something is being measured that somebody still waits for.
bool measuring(const StabilityTabState& state) { return state.study.running() && !state.of_step.left(); }

void select(StabilityTabState& state, const StabilityExperiment& experiment) {
  state.selected = experiment.key;
  state.series.clear();
  if (!complete(state, experiment.key) && !measuring(state))
    begin(state, {std::string(experiment.key)}, StabilityRequest::Kept::take);
}

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

const std::string& kept_worst_text(StabilityTabState& state, const StabilityExperiment& experiment) {
  const auto [kept, is_new] = state.worst.try_emplace(std::string(experiment.key));
  if (is_new) kept->second = worst_text(experiment, state.measured.find(experiment.key)->second.rows);
  return kept->second;
}

/// One experiment of the list: its title, and below it what came out.
void list_row(StabilityTabState& state, const StabilityExperiment& experiment) {
  const float small_line = theme().font(Face::small)->FontSize;
  const float width = ImGui::GetContentRegionAvail().x, title = ImGui::GetTextLineHeight() + px(5);
  const float height = title + small_line + px(5);
  const bool clicked = hit_area(experiment.key, {width, height}, {});
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  auto& list = *ImGui::GetWindowDrawList();
  const bool shown = &selected(state) == &experiment;
  if (shown || ImGui::IsItemHovered())
    list.AddRectFilled(min, max, colour_u32(shown ? palette().selection : palette().field_hover), px(3));
  if (shown) list.AddRectFilled(min, {min.x + px(3), max.y}, colour_u32(palette().text));
  const std::string note = state.study.running() && state.taken && state.taken->now == experiment.key ? "measuring"
                           : complete(state, experiment.key)            ? kept_worst_text(state, experiment)
                           : !why_absent(state, experiment.key).empty() ? why_absent(state, experiment.key)
                                                                        : "not measured yet";
  draw_text({min.x + px(8), min.y}, {max.x - px(4), min.y + title}, whole_words(experiment.title, width - px(12)),
            palette().text, 0);
  {
    const FontScope small(Face::small);
    draw_text({min.x + px(8), min.y + title}, {max.x - px(4), max.y - px(4)}, whole_words(note, width - px(12)),
              palette().text_quiet, 0);
  }
  if (text_width(experiment.title) > width - px(12)) tooltip(experiment.title);
  controls().record(experiment.key, note);
  if (clicked) select(state, experiment);
}

/// Those that were asked for last and are not complete.
std::vector<std::string> left_over(const StabilityTabState& state) {
  std::vector<std::string> keys;
  for (const std::string& key : state.asked)
    if (!complete(state, key) && why_absent(state, key).empty()) keys.push_back(key);
  return keys;
}

void run_buttons(StabilityTabState& state) {
  if (state.study.running()) {
    pause_and_stop(state.study, "Measured rows are kept; the study can be resumed.");
    return;
  }
  const StabilityExperiment& experiment = selected(state);
  const std::vector<std::string> left = left_over(state);
  const bool done = complete(state, experiment.key);
  const char* word = !left.empty() ? "Resume" : done ? "Again" : "Measure";
  if (button("measure", word, Emphasis::primary, {.width = button_width("Measure")})) {
    if (!left.empty())
      begin(state, state.asked, StabilityRequest::Kept::take);
    else
      begin(state, {std::string(experiment.key)}, StabilityRequest::Kept::measure_again);
  }
  same_line_if_room(button_width("All"), px(4));
  if (!button("all", "All", Emphasis::quiet, {.tooltip = "Measures every experiment that is not measured yet."}))
    return;
  std::vector<std::string> all;
  for (const StabilityExperiment& each : stability_experiments()) all.emplace_back(each.key);
  begin(state, std::move(all), StabilityRequest::Kept::take);
}

/// One line: what is going on, or how much is there.
std::string state_line(const StabilityTabState& state) {
  const StudyStatus status = state.study.status();
  switch (state.study.state()) {
  case StudyState::running:
    return "Measuring: " + status_text(status, "experiments");
  case StudyState::paused:
    return "Paused after " + status_text(status, "experiments");
  case StudyState::cancelled:
    if (!left_over(state).empty())
      return fmt::format("Stopped after {} of {} experiments; Resume goes on from there.", status.done, status.total);
    break;
  case StudyState::failed:
    return "Failed: " + state.study.message();
  case StudyState::done:
  case StudyState::none:
    break;
  }
  const auto there = std::count_if(state.measured.begin(), state.measured.end(),
                                   [](const auto& entry) { return entry.second.complete; });
  return fmt::format("{} of {} experiments measured", there, stability_experiments().size());
}

void progress_line(const StabilityTabState& state) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string text = state_line(state);
  {
    const FontScope small(Face::small);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
  }
  controls().record("status", text);
  const StudyStatus status = state.study.status();
  if (!state.study.running() || status.total == 0) return;
  auto& list = *ImGui::GetWindowDrawList();
  const float y = ImGui::GetItemRectMax().y, share = static_cast<float>(status.done) / static_cast<float>(status.total);
  list.AddRectFilled({at.x, y}, {at.x + width, y + px(2)}, colour_u32(palette().line));
  list.AddRectFilled({at.x, y}, {at.x + width * share, y + px(2)}, colour_u32(palette().text_quiet));
}

void experiment_choice(StabilityTabState& state) {
  std::vector<Choice> choices;
  int index = 0;
  for (const StabilityExperiment& experiment : stability_experiments()) {
    if (&experiment == &selected(state)) index = static_cast<int>(choices.size());
    choices.push_back({experiment.key, experiment.title, ""});
  }
  if (choice("experiment", choices, index, {.width = std::min(px(240), ImGui::GetContentRegionAvail().x)}))
    select(state, stability_experiments()[static_cast<std::size_t>(index)]);
}

/// The figure that is chosen, or the first one.
std::size_t shown_figure(const StabilityTabState& state, const std::vector<ExperimentFigure>& figures) {
  const auto chosen =
      std::find_if(figures.begin(), figures.end(), [&](const auto& figure) { return figure.name == state.series; });
  return chosen == figures.end() ? 0 : static_cast<std::size_t>(chosen - figures.begin());
}

void figure_choice(StabilityTabState& state, const std::vector<ExperimentFigure>& figures) {
  if (figures.size() < 2) return;
  int index = static_cast<int>(shown_figure(state, figures));
  std::vector<Choice> choices;
  float widest = 0;
  for (const ExperimentFigure& figure : figures) {
    choices.push_back({figure.name, figure.name, figure.quantity->title});
    widest = std::max(widest, ImGui::CalcTextSize(figure.name.c_str()).x);
  }
  const float room = ImGui::GetFrameHeight() + px(16);  // for the arrow and the frame
  if (choice("series", choices, index, {.width = std::min(widest + room, ImGui::GetContentRegionAvail().x)}))
    state.series = figures[static_cast<std::size_t>(index)].name;
}

void explanation(const StabilityExperiment& experiment, std::span<const StabilityRow> rows) {
  {
    const FontScope bold(Face::bold);
    ImGui::TextWrapped("%s", std::string(experiment.title).c_str());
  }
  ImGui::TextWrapped("%s", std::string(experiment.explanation).c_str());
  if (const std::string first = first_figure_text(experiment, rows); !first.empty()) {
    ImGui::TextWrapped("%s", first.c_str());
    controls().record("first", first);
  }
  const FontScope small(Face::small);
  ImGui::PushStyleColor(ImGuiCol_Text, palette().text_quiet);
  ImGui::TextWrapped("Safe: %s Set-up: %s.", std::string(experiment.safe).c_str(),
                     std::string(set_up_text(experiment.set_up)).c_str());
  ImGui::PopStyleColor();
  controls().record("explanation", std::string(experiment.explanation));
  controls().record("set-up", std::string(set_up_text(experiment.set_up)));
}

void point_tooltip(const Curves& curves, const ExperimentFigure::Row& row, bool has_picture) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(8), px(8)});
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(fmt::format("{}: {}", curves.knob, short_number(row.knob)).c_str());
  for (const auto& [name, value] : {std::pair{"naive", row.naive}, std::pair{"robust", row.robust}})
    if (!std::isnan(value))
      ImGui::TextUnformatted(fmt::format("{}: {} {}", name, short_number(value), curves.figure.quantity->unit).c_str());
  if (!curves.safe.empty())
    ImGui::TextUnformatted(curves.safe.holds(row.knob) ? "inside the safe window" : "outside the safe window");
  if (has_picture) ImGui::TextUnformatted("Click: opens it in A (naive) and B (robust).");
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

/// What is in place of a figure that is not there yet.
void no_figure(const StabilityTabState& state, const StabilityExperiment& experiment, const Area& area) {
  ImGui::GetWindowDrawList()->AddRectFilled(area.min, area.max, colour_u32(palette().field));
  const bool alone = state.asked.size() == 1 && state.asked.front() == experiment.key;
  const bool now = alone || (state.taken && state.taken->now == experiment.key);
  const char* text = !state.study.running() ? "Not measured yet: press Measure."
                     : now                  ? "Measuring."
                                            : "Not measured yet: others are being measured.";
  draw_text(area.min, area.max, whole_words(text, area.width()), palette().text_quiet, 0.5f);
}

/// Pictures belong to the knob of the first figure.
bool of_the_pictures(const StabilityExperiment& experiment, const ExperimentFigure& figure) {
  return experiment.picture &&
         knob_title(experiment, *figure.quantity) == knob_title(experiment, experiment.series.front());
}

/// Answers where the plot lies, if it is one over the knob of the pictures.
std::optional<PlotFrame> curve_area(StabilityTabState& state, const StabilityExperiment& experiment,
                                    const ExperimentFigure& figure, const Area& area, ImVec2 mouse, bool clicked) {
  const bool has_picture = of_the_pictures(experiment, figure);
  Curves curves{
      figure,
      std::string(knob_title(experiment, *figure.quantity)),
      {std::string(naive_name(experiment, *figure.quantity)), std::string(robust_name(experiment, *figure.quantity))},
      figure.quantity->knob.empty() ? experiment.window : SafeWindow{1, 0}};
  std::optional<std::size_t> marked;  // the row of the frame that A and B show
  if (has_picture && state.strip.chosen && state.strip.chosen_of == experiment.key)
    for (std::size_t i = 0; i < figure.rows.size(); ++i)
      if (figure.rows[i].knob == *state.strip.chosen) marked = i;
  const CurvesDrawn drawn = draw_curves(*ImGui::GetWindowDrawList(), area, curves, mouse, marked);
  if (!drawn.cut.empty()) tooltip(drawn.cut);
  if (drawn.hovered) {
    const ExperimentFigure::Row& row = figure.rows[*drawn.hovered];
    point_tooltip(curves, row, has_picture);
    if (clicked && has_picture) begin_opening(state.opening, experiment, row.knob);
  }
  if (!has_picture) return {};
  return drawn.frame;
}

/// Draws the figure that is chosen; bars take the height that they need. Answers as curve_area().
std::optional<PlotFrame> figure_area(StabilityTabState& state, const StabilityExperiment& experiment,
                                     const std::vector<ExperimentFigure>& figures, float height) {
  const float width = ImGui::GetContentRegionAvail().x;
  if (width < px(80)) return {};
  const ExperimentFigure* figure = figures.empty() ? nullptr : &figures[shown_figure(state, figures)];
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
    no_figure(state, experiment, area);
    return {};
  }
  if (!bars) return curve_area(state, experiment, *figure, area, mouse, clicked);
  const std::string cut = draw_bars(*ImGui::GetWindowDrawList(), area, *figure, names, mouse);
  if (!cut.empty()) tooltip(cut);
  return {};
}

/// Where there is little height the curves come first and the words follow below, to be scrolled to.
void shown_experiment(StabilityTabState& state) {
  const StabilityExperiment& experiment = selected(state);
  const auto found = state.measured.find(experiment.key);
  const std::span<const StabilityRow> rows =
      found == state.measured.end() ? std::span<const StabilityRow>{} : std::span(found->second.rows);
  const auto figures = experiment_figures(experiment, rows);
  const bool low = ImGui::GetContentRegionAvail().y < px(little_height);
  if (!low) explanation(experiment, rows);
  if (const std::string reason = why_absent(state, experiment.key); !reason.empty()) {
    quiet_text(fmt::format("Not measured: {}.", reason));
    controls().record("absent", reason);
    return;
  }
  figure_choice(state, figures);
  if (figures.size() > 1 && experiment.picture) same_line_if_room(px(film_slider_width), px(16));
  if (const auto knob = film_strip_slider(state.strip, experiment)) begin_opening(state.opening, experiment, *knob);
  const bool strip = experiment.picture && !experiment.frames.empty();
  const float room = ImGui::GetContentRegionAvail().y;
  const float height = std::max(strip && !low ? room * curves_share : room, px(least_plot));
  const auto frame = figure_area(state, experiment, figures, height);
  if (low) explanation(experiment, rows);
  if (const auto knob = film_strip_view(state.strip, experiment, frame && !low ? &*frame : nullptr))
    begin_opening(state.opening, experiment, *knob);
}

/// Buttons, the list, and the experiment that is chosen. Answers whether the window shall be filled.
bool laboratory(StabilityTabState& state, bool filled) {
  const bool wide = ImGui::GetContentRegionAvail().x >= px(narrow);
  if (!wide) {
    experiment_choice(state);
    same_line_if_room(state.study.running() ? pause_and_stop_width() : button_width("Measure"), px(8));
  }
  run_buttons(state);
  same_line_if_room(button_width("Fill"), px(8));
  const bool fill = button_on_off("fill", "Fill", filled, {.tooltip = "Shows this table in the whole window (Esc)."});
  progress_line(state);
  if (wide) {
    const bool much = ImGui::GetContentRegionAvail().x >= px(room_for_wide_list);
    ImGui::BeginChild("list", {px(much ? wide_list : list_width), 0});
    search_box("search", state.search, "Find an experiment");
    ImGui::BeginChild("rows");
    bool any = false;
    for (const StabilityExperiment& experiment : stability_experiments()) {
      if (!experiment_matches(experiment, state.search)) continue;
      any = true;
      list_row(state, experiment);
    }
    if (!any) {
      ImGui::TextColored(palette().text_quiet, "No experiment matches.");
      controls().record("nothing-found", "No experiment matches.");
    }
    ImGui::EndChild();
    ImGui::EndChild();
    ImGui::SameLine(0, px(14));
  }
  ImGui::BeginChild("experiment");
  shown_experiment(state);
  ImGui::EndChild();
  return fill;
}

}  // namespace

void show_experiment(StabilityTabState& state, const std::string& key) {
  look_into_folder(state);
  select(state, find_stability_experiment(key));
}

bool stability_busy(const StabilityTabState& state) {
  return state.study.state() == StudyState::running || state.opening.running() || state.strip.study.running();
}

void update_stability(Session& session, StabilityTabState& state, const std::filesystem::path& folder) {
  if (state.of_step.leave(session)) state.study.cancel();
  if (const auto opening = state.opening.found(); opening && opening != state.opened) {
    state.opened = opening;
    try {
      show_opening(session, *opening, folder);
      // The pictures are what was asked for; only a drag over the frames must not lose its hold.
      if (!ImGui::IsMouseDown(ImGuiMouseButton_Left))
        session.navigate([](Document& document) { document.layout.filled.clear(); });
    } catch (const InputError& error) {
      session.say(Message::Kind::error, error.what());
    }
  }
  const auto found = state.study.found();
  if (found && found != state.taken) {
    state.taken = found;
    for (const auto& [key, experiment] : found->measured) {
      state.measured.insert_or_assign(key, experiment);
      state.worst.erase(key);
    }
  }
}

bool stability_tab(Session& session, StabilityTabState& state, bool filled) {
  const NameScope scope("stability");
  look_into_folder(state);
  const std::string first(stability_experiments().front().key);
  bool of_step = state.of_step.came_back(session);
  if (of_step) select(state, selected(state));
  state.choice.follow(session, [&](const std::string& asked) {
    of_step = !measuring(state);
    show_experiment(state, asked.empty() ? first : asked);
  });
  if (of_step && state.study.running()) state.of_step.begin(session);
  const bool fill = laboratory(state, filled);
  const std::string shown(selected(state).key);
  state.choice.keep(session, shown == first ? "" : shown);
  return fill;
}

namespace {

/// The measurement of the experiment that is shown; nullptr while there is none.
const std::vector<StabilityRow>* measured_rows(const StabilityTabState& state) {
  const auto found = state.measured.find(selected(state).key);
  return found == state.measured.end() ? nullptr : &found->second.rows;
}

/// "rows", and "row/0/naive".
std::optional<std::string> measured_value(const StabilityTabState& state, std::string_view name) {
  const auto* rows = measured_rows(state);
  if (!rows) return {};
  if (name == "figure") {
    const auto figures = experiment_figures(selected(state), *rows);
    return figures.empty() ? std::string() : figures[shown_figure(state, figures)].name;
  }
  if (name == "rows") return script_text(static_cast<int>(rows->size()));
  for (std::size_t i = 0; i < rows->size(); ++i) {
    if (name == fmt::format("row/{}/naive", i)) return script_text((*rows)[i].naive);
    if (name == fmt::format("row/{}/robust", i)) return script_text((*rows)[i].robust);
  }
  return {};
}

}  // namespace

void offer_stability_values(Values& out, const StabilityTabState& state) {
  out.offer("stability/running", [&state] { return state.study.running(); });
  out.offer("stability/shown", [&state] { return selected(state).key; });
  out.offer("stability/paused", [&state] { return state.study.state() == StudyState::paused; });
  out.offer("stability/measured", [&state] {
    return static_cast<int>(std::count_if(state.measured.begin(), state.measured.end(),
                                          [](const auto& entry) { return entry.second.complete; }));
  });
  out.offer_below("stability/", [&state](std::string_view name) { return measured_value(state, name); });
}

}  // namespace ps::gui
