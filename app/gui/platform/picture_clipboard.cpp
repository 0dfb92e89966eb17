#include "gui/platform/picture_clipboard.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

namespace ps::gui {

bool copy_picture(const std::filesystem::path& file) {
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  std::array<std::string, 5> of_wayland{"wl-copy", "--type", "image/png"},
      of_x{"xclip", "-selection", "clipboard", "-target", "image/png"};
  std::array<char*, 6> words{};
  auto& command = wayland && *wayland ? of_wayland : of_x;
  for (std::size_t i = 0; i < command.size() && !command[i].empty(); ++i) words[i] = command[i].data();
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, file.c_str(), O_RDONLY, 0);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})  // which it would keep open
    posix_spawn_file_actions_addopen(&streams, stream, "/dev/null", O_WRONLY, 0);
  pid_t child = -1;
  int status = -1;
  const bool started = posix_spawnp(&child, words[0], &streams, nullptr, words.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&streams);
  // It reads the file, leaves a copy of itself behind and ends.
  return started && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace ps::gui
