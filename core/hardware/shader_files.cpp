#include "hardware/shader_files.h"

#include "base/read_file.h"
#include "base/resources.h"

namespace ps::hardware {

const std::string& ShaderFiles::text(const std::string& name) {
  const auto found = texts_.find(name);
  if (found != texts_.end()) return found->second;
  return texts_[name] = read_whole_file(shader_file(name));
}

}  // namespace ps::hardware
