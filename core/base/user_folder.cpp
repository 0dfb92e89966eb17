#include "base/user_folder.h"

#include <cstdlib>

namespace ps {

std::filesystem::path user_folder(const char* variable, const char* below_home) {
  if (const char* folder = std::getenv(variable); folder && *folder == '/') return folder;
  if (const char* home = std::getenv("HOME"); home && *home == '/') return std::filesystem::path(home) / below_home;
  return {};
}

}  // namespace ps
