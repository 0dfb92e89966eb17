#include "document/permalink_file.h"

#include "base/atomic_file.h"
#include "base/check.h"
#include "document/permalink.h"
#include "image/file.h"

namespace ps {
namespace {

constexpr std::uintmax_t largest_permalink = 1u << 20;  // bytes

}  // namespace

std::optional<std::string> permalink_in_file(const std::filesystem::path& path) {
  if (path.extension() == permalink_extension) {
    const std::string text = read_whole_file(path, largest_permalink);
    const std::string line = text.substr(0, text.find_first_of("\r\n"));
    if (line.empty()) throw InputError({path.string(), 1, 1}, "an empty line", "a permalink");
    return line;
  }
  if (path.extension() != ".png") return {};
  for (const ImageText& text : load_texts(path))
    if (text.key == "permalink") return text.value;
  return {};
}

void save_permalink(const std::filesystem::path& path, const Document& document) {
  write_file_atomically(path, permalink(document) + "\n");
}

}  // namespace ps
