#include "gui/panels/options/vector_field.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "gui/widgets/draw.h"

namespace ps::gui {

Edit vector_field(std::string_view name, Vec3d& value, const NumberRange& range, std::string_view tooltip) {
  static constexpr std::array axes{"x", "y", "z"};
  const float space = px(4), width = std::floor((ImGui::GetContentRegionAvail().x - 2 * space) / 3);
  Edit all;
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, space);
    const auto edit = number(fmt::format("{}/{}", name, axes[static_cast<std::size_t>(i)]), value[i], range,
                             {.tooltip = tooltip, .width = width});
    all.changed = all.changed || edit.changed;
    all.finished = all.finished || edit.finished;
  }
  return all;
}

}  // namespace ps::gui
