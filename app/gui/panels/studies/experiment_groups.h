#pragma once
#include <string_view>
#include <vector>

#include "options/option.h"
#include "study/stability/experiment.h"

namespace ps::gui {

/// The experiments about one option, in the order of stability_experiments().
struct ExperimentGroup {
  const Option* option = nullptr;  ///< nullptr: of the experiments that are about none
  std::vector<const StabilityExperiment*> experiments;
  /// The option's name, or what else they have in common.
  std::string_view title() const { return option ? option->label : "Broken input"; }
};

/// All experiments, each in one group: that of the option whose safe window it shows, else of the first option that
/// names it. Groups are in the order of the option table, the one without an option is last.
const std::vector<ExperimentGroup>& experiment_groups();

/// The option that the experiment is about; nullptr for none.
const Option* option_of(const StabilityExperiment& experiment);

}  // namespace ps::gui
