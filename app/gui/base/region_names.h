#pragma once
#include <string_view>

/// The parts that can have the window for themselves, as documents name them: the options, the pixel's story, the
/// tools, a lesson's text.
namespace ps::region_names {

inline constexpr std::string_view left = "left", right = "right", bottom = "bottom", lesson = "lesson";

}  // namespace ps::region_names
