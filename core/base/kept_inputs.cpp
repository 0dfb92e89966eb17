#include "base/kept_inputs.h"

#include <fmt/format.h>

#include "base/check.h"

namespace ps {

void require_no_input(const std::filesystem::path& output, const std::vector<std::string>& inputs) {
  std::error_code error;
  // Not by equivalent(): another hard link may be written, for it gets a file of its own.
  const auto place = std::filesystem::canonical(output, error);
  if (error || !std::filesystem::is_regular_file(place, error)) return;
  for (const std::string& input : inputs)
    if (const auto read = std::filesystem::canonical(input, error); !error && read == place)
      throw InputError(fmt::format("{}: is an input of this run ('{}') and is not overwritten; choose another name",
                                   output.string(), input));
}

}  // namespace ps
