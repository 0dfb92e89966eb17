#include "gui/panels/studies/stability_tab.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "gui/widgets/key_focus.h"
#include "gui/widgets/widgets.h"

namespace ps::gui {
namespace {

constexpr StudyWords stability_words{.name = "stability",
                                     .title = "Stability",
                                     .measure = "Measure",
                                     .again = "Again",
                                     .help = "Measures this experiment.",
                                     .preparing = "measuring",
                                     .unit = "experiments",
                                     .kept = "Resume goes on from there"};

}  // namespace

StabilityTab::StabilityTab(const PanelHost& host, const StudyFolder& folder)
    : Study(host,
            study_facts({.name = "stability",
                         .group = ToolGroup::stability,
                         .heading = "Stability",
                         .brief = "Stable",
                         .command = "Stability: where methods fail",
                         .help = "Where methods fail: naive beside robust."}),
            stability_words),
      results_(folder.of("stability")), scenes_(folder.scenes()), strip_(host.wake), opening_(host.wake) {}

void StabilityTab::add_actions(Actions& actions) {
  ActionGroup(actions, "Study", [this] {
    return session_.has_scene();
  }).add("film-frame", "Stability: go through the frames of the film strip", "", [this] {
    host_.send(ShowTool{facts.name});
    key_focus().go_to("stability/scrub");
  });
}

const StabilityExperiment& StabilityTab::selected() const {
  for (const StabilityExperiment& experiment : stability_experiments())
    if (experiment.key == selected_) return experiment;
  return stability_experiments().front();
}

/// nullptr before its first row.
const MeasuredExperiment* StabilityTab::result_of(std::string_view key) const {
  const auto entry = measured_.find(key);
  return entry == measured_.end() ? nullptr : &entry->second;
}

bool StabilityTab::complete(std::string_view key) const {
  const MeasuredExperiment* result = result_of(key);
  return result && result->complete;
}

/// Why this machine could not measure it; empty where it could, or where that was not asked.
std::string StabilityTab::why_absent(std::string_view key) const {
  const MeasuredExperiment* result = result_of(key);
  return result ? result->absent : "";
}

/// Begins or goes on with experiments, whose results are kept in the folder.
void StabilityTab::begin(std::vector<std::string> keys, StabilityRequest::Kept kept) {
  StabilityRequest request;
  request.keys = asked_ = std::move(keys);
  request.folder = results_;
  request.kept = kept;
  of_step_.forget();
  start([request](StudyControl& control, const Report& report) {
    auto newest = std::make_shared<const StabilityFound>();
    run_stability(request, control, [&](const MeasuredExperiment& experiment, const StudyStatus& status) {
      auto next = std::make_shared<StabilityFound>(*newest);
      next->measured.insert_or_assign(experiment.key, experiment);
      next->now = experiment.complete ? "" : experiment.key;
      newest = next;
      report(status, newest);
    });
    return nullptr;
  });
}

void StabilityTab::look_into_folder() {
  if (std::exchange(looked_, true)) return;
  StabilityRequest request;
  request.folder = results_;
  for (MeasuredExperiment& experiment : read_stability(request))
    if (experiment.complete) measured_.insert_or_assign(experiment.key, std::move(experiment));
}

void StabilityTab::select(const StabilityExperiment& experiment) {
  selected_ = experiment.key;
  series_.clear();
  if (!complete(experiment.key) && !is_awaited()) begin({std::string(experiment.key)}, StabilityRequest::Kept::take);
}

void StabilityTab::take(const PanelMessage& message) {
  if (const auto* asked = std::get_if<ShowExperiment>(&message)) show(asked->key);
}

void StabilityTab::show(const std::string& key) {
  look_into_folder();
  select(find_stability_experiment(key));
}

/// Those that were asked for last and are not complete.
std::vector<std::string> StabilityTab::left_over() const {
  std::vector<std::string> keys;
  for (const std::string& key : asked_)
    if (!complete(key) && why_absent(key).empty()) keys.push_back(key);
  return keys;
}

std::string StabilityTab::measure_word() const {
  if (!left_over().empty()) return "Resume";
  return std::string(complete(selected().key) ? words_.again : words_.measure);
}

void StabilityTab::measure(Session&) {
  if (left_over().empty())
    begin({std::string(selected().key)}, StabilityRequest::Kept::measure_again);
  else
    begin(asked_, StabilityRequest::Kept::take);
}

void StabilityTab::more_controls(Session&) {
  if (work.running()) return;
  same_line_if_room(button_width("All"), px(4));
  if (!button("all", "All", Emphasis::plain, {.tooltip = "Measures every experiment that is not measured yet."}))
    return;
  std::vector<std::string> all;
  for (const StabilityExperiment& each : stability_experiments()) all.emplace_back(each.key);
  begin(std::move(all), StabilityRequest::Kept::take);
}

std::size_t StabilityTab::complete_count() const {
  return static_cast<std::size_t>(
      std::count_if(measured_.begin(), measured_.end(), [](const auto& entry) { return entry.second.complete; }));
}

std::string StabilityTab::about(const Session&) const {
  return fmt::format("{} of {} experiments measured", complete_count(), stability_experiments().size());
}

bool StabilityTab::busy() const { return Study::busy() || opening_.running() || strip_.study.running(); }

std::string StabilityTab::status() const {
  return !measuring() && opening_.running() ? "Stability: opening a point" : Study::status();
}

void StabilityTab::take_up(Session& session) {
  if (of_step_.leave(session)) work.cancel();
  if (const auto opening = opening_.found(); opening && opening != opened_) {
    opened_ = opening;
    try {
      show_opening(session, *opening, scenes_);
      // The pictures are what was asked for; only a drag over the frames must not lose its hold.
      if (!ImGui::IsMouseDown(ImGuiMouseButton_Left))
        session.navigate([](Document& document) { document.layout.filled.clear(); });
    } catch (const InputError& error) {
      session.say(Message::Kind::error, error.what());
    }
  }
  Study::take_up(session);
}

void StabilityTab::took(Session&) {
  for (const auto& [key, experiment] : found->measured) {
    measured_.insert_or_assign(key, experiment);
    worst_.erase(key);
  }
}

void StabilityTab::follow(Session& session) {
  look_into_folder();
  const std::string first(stability_experiments().front().key);
  bool of_step = of_step_.came_back(session);
  if (of_step) select(selected());
  choice_.follow(session, [&](const std::string& asked) {
    of_step = !is_awaited();
    show(asked.empty() ? first : asked);
  });
  if (of_step && work.running()) of_step_.begin(session);
  const std::string shown(selected().key);
  choice_.keep(session, shown == first ? "" : shown);
}

/// "rows", and "row/0/naive".
std::optional<std::string> StabilityTab::value(std::string_view name) const {
  const MeasuredExperiment* result = result_of(selected().key);
  if (!result) return {};
  const std::vector<StabilityRow>& rows = result->rows;
  if (name == "figure") {
    const auto figures = experiment_figures(selected(), rows);
    return figures.empty() ? std::string() : figures[shown_figure(figures)].name;
  }
  if (name == "rows") return script_text(static_cast<int>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (name == fmt::format("row/{}/naive", i)) return script_text(rows[i].naive);
    if (name == fmt::format("row/{}/robust", i)) return script_text(rows[i].robust);
  }
  return {};
}

void StabilityTab::offer_found(Values& out) const {
  out.offer("stability/shown", [this] { return selected().key; });
  out.offer("stability/measured", [this] { return static_cast<int>(complete_count()); });
  out.offer_below("stability/", [this](std::string_view name) { return value(name); });
}

}  // namespace ps::gui
