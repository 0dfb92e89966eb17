#include "gui/panels/space/space_groups.h"

#include <sstream>
#include <string>

namespace ps::gui {
namespace {

std::size_t index_of(SpaceGroup group) { return static_cast<std::size_t>(group); }

}  // namespace

SpaceGroups shown_groups(const OutsideView& outside) {
  SpaceGroups shown = first_space_groups();
  std::istringstream words(outside.switched);
  for (std::string key; std::getline(words, key, ',');)
    for (const auto& row : space_groups)
      if (row.key == key) shown[index_of(row.group)] = !first_space_groups()[index_of(row.group)];
  return shown;
}

void switch_group(OutsideView& outside, SpaceGroup group) {
  auto shown = shown_groups(outside);
  shown[index_of(group)] = !shown[index_of(group)];
  outside.switched.clear();
  for (const auto& row : space_groups)
    if (shown[index_of(row.group)] != first_space_groups()[index_of(row.group)])
      outside.switched += (outside.switched.empty() ? "" : ",") + std::string(row.key);
}

}  // namespace ps::gui
