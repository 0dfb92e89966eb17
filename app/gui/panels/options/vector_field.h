#pragma once
#include <string_view>

#include "gui/widgets/widgets.h"
#include "math/vec.h"

namespace ps::gui {

/// Three numbers side by side: a place, a size or a colour.
Edit vector_field(std::string_view name, Vec3d& value, const NumberRange& range, std::string_view tooltip);

}  // namespace ps::gui
