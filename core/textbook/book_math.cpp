#include "textbook/book_math.h"

#include <numbers>
#include <stdexcept>
#include <string>

namespace ps {

BookView book_view(const Camera& camera) {
  const double half = portable::atan2(camera.viewport_height / 2, camera.projection_plane_d);
  return {camera.position, camera.position + camera.forward, 2 * half * 180 / std::numbers::pi};
}

void throw_no_entry(std::size_t size) {
  throw std::out_of_range("an entry was asked for that a list of " + std::to_string(size) + " values does not have");
}

}  // namespace ps
