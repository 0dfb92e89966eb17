#include "hardware/shader_files.h"

#include <fmt/format.h>

#include "base/check.h"
#include "base/read_file.h"
#include "base/resources.h"

namespace ps::hardware {

const std::string& ShaderFiles::text(const std::string& name) {
  if (name.find('/') != std::string::npos || name == "..")
    throw InputError(fmt::format("\"{}\": expected a name in the folder of the shaders, without '/'", name));
  const auto found = texts_.find(name);
  if (found != texts_.end()) return found->second;
  return texts_[name] = read_whole_file(shader_file(name));
}

std::optional<std::string> ShaderFiles::included_name(std::string_view line) {
  constexpr std::string_view include = "#include \"";
  if (!line.starts_with(include)) return {};
  const std::string_view name = line.substr(include.size());
  return std::string(name.substr(0, name.find('"')));
}

}  // namespace ps::hardware
