#include "image/image.h"

#include <fmt/format.h>

namespace ps {

void require_image_size(std::int64_t width, std::int64_t height, const std::string& what) {
  constexpr std::int64_t longest_side = std::int64_t{1} << 31;
  const bool positive = width >= 1 && height >= 1;
  if (positive && width < longest_side && height < longest_side && width * height <= max_image_pixels) return;
  throw InputError(fmt::format("{}: found a size of {} x {}, expected at least 1 x 1 and at most {} pixels in all",
                               what, width, height, max_image_pixels));
}

}  // namespace ps
