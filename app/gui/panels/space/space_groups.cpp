#include "gui/panels/space/space_groups.h"

#include <sstream>
#include <string>

namespace ps::gui {
namespace {

std::size_t group_index(SpaceGroup group) { return static_cast<std::size_t>(group); }

}  // namespace

SpaceGroups shown_groups(const OutsideView& outside) {
  SpaceGroups shown = first_space_groups();
  std::istringstream words(outside.switched);
  for (std::string key; std::getline(words, key, ',');)
    for (const auto& row : space_groups)
      if (row.key == key) shown[group_index(row.group)] = !first_space_groups()[group_index(row.group)];
  return shown;
}

void switch_group(OutsideView& outside, SpaceGroup group) {
  auto shown = shown_groups(outside);
  shown[group_index(group)] = !shown[group_index(group)];
  outside.switched.clear();
  for (const auto& row : space_groups)
    if (shown[group_index(row.group)] != first_space_groups()[group_index(row.group)])
      outside.switched += (outside.switched.empty() ? "" : ",") + std::string(row.key);
}

}  // namespace ps::gui
