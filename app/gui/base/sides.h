#pragma once
#include <array>
#include <cstddef>

#include "document/document.h"

/// The two pictures of the window.
namespace ps::gui {

inline constexpr std::array both_sides{Side::a, Side::b};
inline char letter_of(Side side) { return side == Side::a ? 'A' : 'B'; }
inline std::size_t index_of(Side side) { return side == Side::a ? 0 : 1; }

}  // namespace ps::gui
