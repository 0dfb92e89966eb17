// The laboratory's list: each experiment once, under an option that names it.
#include "gui/panels/studies/experiment_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace ps::gui::experiment_groups_test {
namespace {

TEST(ExperimentGroups, EachExperimentIsInOneAndItsOptionNamesIt) {
  std::map<std::string_view, int> times;
  for (const ExperimentGroup& group : experiment_groups()) {
    EXPECT_FALSE(group.experiments.empty()) << group.title();
    for (const StabilityExperiment* experiment : group.experiments) {
      ++times[experiment->key];
      EXPECT_EQ(option_of(*experiment), group.option) << experiment->key;
      if (!group.option) continue;
      const auto& named = group.option->shown_by.experiments.list;
      EXPECT_TRUE(std::any_of(named.begin(), named.end(), [&](const auto& one) { return one.key == experiment->key; }))
          << experiment->key << " is under " << group.option->key;
    }
  }
  EXPECT_EQ(times.size(), stability_experiments().size());
  for (const auto& [key, count] : times) EXPECT_EQ(count, 1) << key;
}

/// An experiment that several options name is under the one whose safe window it shows.
TEST(ExperimentGroups, TheOptionWithTheSafeWindowComesFirst) {
  const auto about = [](std::string_view key) { return option_of(find_stability_experiment(key))->key; };
  EXPECT_EQ(about("bvh-holes"), "slab-test");                 // the accelerator names it before
  EXPECT_EQ(about("triangle-edge-cracks"), "triangle-test");  // so does the precision
  EXPECT_EQ(about("srgb-averaging"), "gamma");                // the only one, without a window
}

}  // namespace
}  // namespace ps::gui::experiment_groups_test
