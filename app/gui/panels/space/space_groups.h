#pragma once
#include <array>

#include "document/story_view.h"
#include "gui/panels/space/space_style.h"

namespace ps::gui {

/// Which of space_groups are drawn, in their order.
std::array<bool, space_groups.size()> shown_groups(const OutsideView& outside);
/// Shows a group that is hidden, and hides one that is shown.
void switch_group(OutsideView& outside, SpaceGroup group);

}  // namespace ps::gui
