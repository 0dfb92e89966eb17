#pragma once
#include "gui/theme/theme.h"

namespace ps::gui {

/// Type for the last row behind a projector: a theme of its own, in which body text has the size of the presenter's
/// caption and all else grows with it. Its faces are loaded between frames, while they are wanted.
void want_projected_type(bool wanted);

/// Brings both themes up to date; call between frames. True if the font atlas changed and its texture must be made
/// anew.
bool prepare_themes();

/// How much larger all is in it.
inline double projected_share() { return type_size(Face::caption) / type_size(Face::body); }

/// In its scope theme() is that theme, once its faces are loaded.
class ProjectedType {
 public:
  ProjectedType();
  ~ProjectedType();
  ProjectedType(const ProjectedType&) = delete;
  ProjectedType& operator=(const ProjectedType&) = delete;
  /// Whether such a scope is open.
  static bool in_use();

 private:
  ImGuiStyle outside_;
  bool acts_ = false;
};

}  // namespace ps::gui
