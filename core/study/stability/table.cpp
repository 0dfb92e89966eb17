#include <experiments_table.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "base/check.h"
#include "base/csv.h"
#include "base/spelling.h"
#include "base/word_search.h"
#include "render/renderer_table.h"
#include "scene/scene.h"
#include "study/stability/support.h"

namespace ps {

namespace stability {
#define PS_DECLARE(file, name)                                                                                         \
  namespace file {                                                                                                     \
  extern const StabilityExperiment name;                                                                               \
  }
PS_STABILITY_EXPERIMENTS(PS_DECLARE)
#undef PS_DECLARE
}  // namespace stability

namespace {

bool is_here(const StabilityExperiment& experiment) { return !experiment.measures_driver || driver_renderer(); }

std::vector<StabilityExperiment> in_order() {
#define PS_EXPERIMENT(file, name) stability::file::name,
  std::vector<StabilityExperiment> all{PS_STABILITY_EXPERIMENTS(PS_EXPERIMENT)};
#undef PS_EXPERIMENT
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
  return all;
}

const auto& everything() {
  static const std::vector<StabilityExperiment> experiments = in_order();
  return experiments;
}

const auto& table() {
  static const std::vector<StabilityExperiment> experiments = [] {
    std::vector<StabilityExperiment> here;
    std::copy_if(everything().begin(), everything().end(), std::back_inserter(here), is_here);
    return here;
  }();
  return experiments;
}

constexpr std::string_view no_driver =
    "measures the graphics driver, and this program was built without a renderer that uses it";

std::string number_field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

}  // namespace

std::span<const StabilityExperiment> stability_experiments() { return table(); }

bool experiment_matches(const StabilityExperiment& experiment, std::string_view wanted) {
  return has_words(wanted, {experiment.key, experiment.title, experiment.keywords, experiment.explanation,
                            experiment.naive, experiment.robust});
}

const StabilityExperiment& find_stability_experiment(std::string_view key) {
  const auto found = std::find_if(table().begin(), table().end(), [&](const auto& row) { return row.key == key; });
  if (found != table().end()) return *found;
  const auto left_out =
      std::find_if(everything().begin(), everything().end(), [&](const auto& row) { return row.key == key; });
  if (left_out != everything().end()) throw InputError(fmt::format("experiment '{}': {}", key, no_driver));
  std::vector<std::string_view> known;
  for (const StabilityExperiment& row : table()) known.push_back(row.key);
  throw InputError(fmt::format("unknown experiment '{}'{}", key,
                               did_you_mean(key, known, "; 'pixelscope-cli stability --help' lists them")));
}

std::optional<std::string> why_not_measured(const StabilityExperiment& experiment) {
  if (!experiment.measures_driver) return {};
  const auto renderer = driver_renderer();
  if (!renderer) return std::string(no_driver);
  const RendererKind& kind = renderer_kind(*renderer);
  const auto reason = kind.inactive ? kind.inactive(Settings{}, SceneTraits{}) : std::nullopt;
  return reason ? std::optional(reason->text()) : std::nullopt;
}

std::string_view set_up_text(SetUp set_up) {
  switch (set_up) {
  case SetUp::illustration:
    return "The set-up is an illustration of our own.";
  case SetUp::reproduction:
    break;
  }
  return "";
}

std::vector<StabilityRow> StabilityExperiment::measure(const StabilityRun& run) const {
  stability::Rows rows(run);
  add_rows(run, rows);
  return rows.take();
}

std::string stability_csv(std::span<const StabilityRow> rows) {
  std::string text = csv_row({"knob", "series", "naive", "robust", "unit"});
  for (const StabilityRow& row : rows)
    text +=
        csv_row({fmt::format("{}", row.knob), row.series, number_field(row.naive), number_field(row.robust), row.unit});
  return text;
}

}  // namespace ps
