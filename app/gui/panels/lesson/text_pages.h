#pragma once
#include <cstddef>
#include <vector>

namespace ps::gui {

/// A line, or anything else that is not parted between two pages.
struct PagePart {
  float gap = 0, height = 0;     ///< free space above it (none at the top of a page), and its own height
  bool begins_block = false;     ///< a page may well begin here
  bool stays_with_next = false;  ///< must not be the last of a page
};

/// The parts with which pages of this height begin; {0} where all fits one page. A page ends between blocks if that
/// leaves it no more than a third empty, else between lines. A part that is higher than a page has one for itself.
std::vector<std::size_t> page_starts(const std::vector<PagePart>& parts, float height);

}  // namespace ps::gui
