#include "base/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/check.h"

namespace ps {

void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free number is this one. Input and output are opened the other way round, so that use is an error.
    const int mode = stream == STDOUT_FILENO ? O_RDONLY : O_WRONLY;
    if (open("/dev/null", mode) != stream) return;  // there is no better stream
  }
}

void require_printed() {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw InputError(unprinted_text(errno));  // 0 where an earlier write failed
}

std::string unprinted_text(int error) {
  constexpr const char* text = "standard output cannot be written";
  return error == 0 ? text : fmt::format("{} ({})", text, std::generic_category().message(error));
}

}  // namespace ps
