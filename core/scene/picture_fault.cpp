#include "scene/picture_fault.h"

namespace ps {

std::string picture_fault(const std::filesystem::path& path, const InputError& error) {
  const std::string name = path.string() + ": ";
  std::string reason = error.what();
  if (reason.starts_with(name)) reason.erase(0, name.size());
  return reason;
}

}  // namespace ps
