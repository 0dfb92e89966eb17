#include "image/read_limit.h"

#include <fmt/format.h>

#include "image/image.h"

namespace ps {

void require_read_size(std::int64_t width, std::int64_t height, std::int64_t most_pixels, const std::string& file) {
  require_image_size(width, height, file);
  if (width * height <= most_pixels) return;
  const std::int64_t mebibytes = width * height * static_cast<std::int64_t>(sizeof(Vec3f)) >> 20;
  throw InputError(
      fmt::format("{}: found a picture of {} x {} pixels, which takes {} MiB of memory, expected at most {} "
                  "pixels",
                  file, width, height, mebibytes, most_pixels));
}

}  // namespace ps
