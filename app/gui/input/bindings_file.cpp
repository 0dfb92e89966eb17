#include "gui/input/bindings_file.h"

#include "base/atomic_file.h"
#include "base/check.h"

namespace ps::gui {

std::string load_bindings(const std::filesystem::path& path, Actions& actions) {
  constexpr std::uintmax_t largest_file = 1 << 16;
  std::error_code error;
  if (path.empty() || !std::filesystem::exists(path, error)) return {};
  try {
    std::string text = read_whole_file(path, largest_file);
    if (text.starts_with("\xEF\xBB\xBF")) text.replace(0, 3, "   ");  // a byte order mark
    actions.rebind(text, path.string());
  } catch (const InputError& problem) {
    return problem.what() + std::string("; the keys stay as they are");
  }
  return {};
}

}  // namespace ps::gui
