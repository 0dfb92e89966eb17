#include "record/shadow_events.h"

#include <array>

namespace ps {

std::string_view cube_face_name(int face) {
  static constexpr std::array<std::string_view, 6> names{"+x", "-x", "+y", "-y", "+z", "-z"};
  return names.at(static_cast<std::size_t>(face));
}

}  // namespace ps
