#pragma once
#include <span>
#include <string_view>

namespace ps::gui {

/// Something that people look for and Pixelscope does not have.
struct AbsentFeature {
  std::string_view name;      ///< "depth of field"
  std::string_view words;     ///< what else people call it, with commas between
  std::string_view nearest;   ///< what there is in its place
  std::string_view leads_to;  ///< name of an action, or of an entry of the palette
};

std::span<const AbsentFeature> absent_features();

}  // namespace ps::gui
