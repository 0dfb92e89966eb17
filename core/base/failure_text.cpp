#include "base/failure_text.h"

#include <new>
#include <system_error>

#include <fmt/format.h>

namespace ps {

std::string failure_text(const std::exception& failure) {
  if (dynamic_cast<const std::bad_alloc*>(&failure) != nullptr)
    return "there is not enough memory for this; try a smaller picture, fewer samples, smaller shadow maps or "
           "textures, "
           "or a scene with fewer triangles";
  if (const auto* of_system = dynamic_cast<const std::system_error*>(&failure)) {
    if (of_system->code() == std::errc::resource_unavailable_try_again)
      return "the system cannot start another thread; close other programs, or raise the limit (ulimit -u, ulimit -v)";
    return fmt::format("the system reports: {}", of_system->code().message());
  }
  return failure.what();
}

}  // namespace ps
