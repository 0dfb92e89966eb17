#pragma once
#include <array>
#include <string_view>

/// The words that lessons and their links have for parts of the window. To a document they are strings; the window
/// looks them up among its tools. A tool that is not among these works like all others, but no lesson can name it.

namespace ps::tool_names {

inline constexpr std::string_view chart = "chart", listing = "listing", microscope = "microscope", needs = "needs",
                                  pixels = "pixels", space = "space", stability = "stability", timings = "timings",
                                  vertex = "vertex", why = "why";

/// Their order has no meaning.
inline constexpr std::array all{chart, listing, microscope, needs, pixels, space, stability, timings, vertex, why};

}  // namespace ps::tool_names

namespace ps::story_names {

/// The pixel's story, and the place where the stories of A and B part.
inline constexpr std::string_view one = "story", parting = "parting";

}  // namespace ps::story_names
