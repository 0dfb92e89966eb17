#pragma once
#include <imgui.h>

#include <string>

#include "gui/panels/pictures/picture_transform.h"

namespace ps::gui {

/// The two sides of an experiment.
enum class Method { naive, robust };

const ImVec4& method_colour(Method method);
/// A purple cross for the naive method, a green ring for the robust one.
void draw_method_sign(ImDrawList& list, ImVec2 at, Method method, bool strong);

/// The names of both methods above a plot, each behind its sign, in one line or in two.
struct MethodNames {
  std::string naive, robust;

  /// The height that they take in an area of this width.
  float height(float width) const;
  /// Answers the name under the mouse if it does not fit even so.
  std::string draw(ImDrawList& list, const Area& area, ImVec2 mouse) const;
};

}  // namespace ps::gui
