#include "gui/panels/studies/experiment_groups.h"

#include <algorithm>

namespace ps::gui {

const Option* option_of(const StabilityExperiment& experiment) {
  const Option* first = nullptr;
  for (const Option& option : option_table())
    for (const OptionExperiment& about : option.shown_by.experiments.list) {
      if (about.key != experiment.key) continue;
      if (about.unsafe) return &option;
      if (!first) first = &option;
    }
  return first;
}

const std::vector<ExperimentGroup>& experiment_groups() {
  static const std::vector<ExperimentGroup> groups = [] {
    std::vector<ExperimentGroup> all;
    for (const Option& option : option_table()) all.push_back({&option, {}});
    all.emplace_back();
    for (const StabilityExperiment& experiment : stability_experiments()) {
      const Option* option = option_of(experiment);
      std::find_if(all.begin(), all.end(), [&](const ExperimentGroup& group) {
        return group.option == option;
      })->experiments.push_back(&experiment);
    }
    std::erase_if(all, [](const ExperimentGroup& group) { return group.experiments.empty(); });
    return all;
  }();
  return groups;
}

}  // namespace ps::gui
