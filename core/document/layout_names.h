#pragma once
#include <array>
#include <string_view>

/// The names of the window's parts, as documents, permalinks, lessons and scripts write them. Each is written here
/// alone; the window's table of panels takes its names from here.

namespace ps::tool_names {

inline constexpr std::string_view chart = "chart", listing = "listing", microscope = "microscope", needs = "needs",
                                  pixels = "pixels", space = "space", stability = "stability", timings = "timings",
                                  vertex = "vertex", why = "why";

/// The tools below the pictures. Their order has no meaning.
inline constexpr std::array all{chart, listing, microscope, needs, pixels, space, stability, timings, vertex, why};

}  // namespace ps::tool_names

namespace ps::story_names {

/// The part of the pixel's stories that is shown: that of the picked side, both, or the place where they part.
inline constexpr std::string_view one = "story", both = "both", parting = "parting";
inline constexpr std::array all{one, both, parting};

}  // namespace ps::story_names

namespace ps::region_names {

/// The parts that can have the window for themselves: the options, the pixel's story, the tools, a lesson's text.
inline constexpr std::string_view left = "left", right = "right", bottom = "bottom", lesson = "lesson";

}  // namespace ps::region_names
