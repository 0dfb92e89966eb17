#include "gui/panels/lesson/text_pages.h"

namespace ps::gui {
namespace {

constexpr float least_filled = 2.f / 3;  // of a page that ends before a block

/// The first part from `first` on that does not fit the page, and how much of it is filled up to each part.
std::size_t first_over(const std::vector<PagePart>& parts, std::size_t first, float height,
                       std::vector<float>& filled) {
  float used = 0;
  std::size_t next = first;
  for (; next < parts.size(); ++next) {
    const float more = (next == first ? 0 : parts[next].gap) + parts[next].height;
    if (next > first && used + more > height) break;
    filled.push_back(used);
    used += more;
  }
  return next;
}

}  // namespace

std::vector<std::size_t> page_starts(const std::vector<PagePart>& parts, float height) {
  std::vector<std::size_t> starts{0};
  while (true) {
    const std::size_t first = starts.back();
    std::vector<float> filled;
    const std::size_t over = first_over(parts, first, height, filled);
    if (over >= parts.size()) return starts;
    std::size_t next = over;
    for (std::size_t i = over; i > first; --i) {
      const float left_filled = i < over ? filled[i - first] : height;
      if (left_filled < least_filled * height) break;
      if (parts[i].begins_block && !parts[i - 1].stays_with_next) {
        next = i;
        break;
      }
    }
    while (next > first + 1 && parts[next - 1].stays_with_next) --next;
    starts.push_back(next);
  }
}

}  // namespace ps::gui
