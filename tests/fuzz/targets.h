#pragma once
#include <span>
#include <string_view>

namespace ps::fuzz {

/// Whether some bytes were a good file.
enum class Outcome { read, refused };

/// A way for bytes from outside into the program. `run` reads them and checks what comes out; it lets nothing but
/// InputError pass for "refused", so a crash, an assertion, another exception or a sanitizer's report is a finding.
struct Target {
  std::string_view name;  ///< also the folder of its files below tests/corpus/
  Outcome (*run)(std::string_view bytes);
};

/// scene obj mtl png pnm pfm jpeg tga permalink bundle chart-log lesson own-result
std::span<const Target> targets();
const Target& target(std::string_view name);

}  // namespace ps::fuzz
