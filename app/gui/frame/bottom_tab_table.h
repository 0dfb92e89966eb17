#pragma once
#include <array>
#include <string_view>

#include "document/document.h"

namespace ps::gui {

/// How a tab below the pictures is called.
struct BottomTab {
  std::string_view heading, brief;  ///< brief where there is little room
  std::string_view command;         ///< in the menu Study and the palette
  std::string_view help;            ///< one sentence
};

/// In the order of bottom_tabs, which has their names.
inline constexpr std::array<BottomTab, bottom_tabs.size()> bottom_tab_table{
    {{"SPACE", "Space", "Space: the scene from outside",
      "The scene from outside, with the rays or triangles of the picked pixel."},
     {"MICROSCOPE", "Micro", "Microscope: the pixel at panel size",
      "The picked pixel at panel size: edges with their fill rule, samples, texels."},
     {"PIXELS", "Pixels", "Pixels: the worst ones", "The worst pixels, watched pixels, and the levels of a rectangle."},
     {"LISTING", "Listing", "Listing: a routine with its values",
      "A lesson's routine with the values of its lines at the picked pixel."},
     {"VERTEX", "Vertex", "Vertex: from the model to the canvas",
      "The transforms of a vertex from its model to the canvas, with matrices and numbers."},
     {"CHART", "Chart", "Chart: time against error", "Time against error over a sweep of options."},
     {"STABILITY", "Stable", "Stability: where methods fail", "Where methods fail: naive beside robust."},
     {"NEEDS", "Needs", "Needs: what the scene can do without",
      "The features that this scene needs, and the cheapest settings within a tolerance."},
     {"WHY", "Why", "Why: what makes A and B differ",
      "Which option makes A and B differ, and which pixels float gets wrong."},
     {"TIMINGS", "Times", "Timings: times and counts", "Times of the stages and counts of the work, A beside B."}}};

}  // namespace ps::gui
