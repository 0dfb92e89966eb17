#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace ps::gui {

/// Brings controls into sight and lights them up for a moment, so that the eye finds them. Those that are not there
/// are waited for as long as a panel takes to open.
void flash(std::vector<std::string> names);
/// For the window, once a frame after all controls: draws what is lit up.
void draw_flash();
/// Whether the control of that name is lit up.
bool flashes(std::string_view name);

}  // namespace ps::gui
