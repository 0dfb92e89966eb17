#include "student/isolate.h"

#include "base/check.h"
#include "student/run_listing.h"

namespace ps {
namespace {

std::vector<std::string> bubblewrap_arguments() {
  const std::filesystem::path found = find_program({"bwrap"}, "/usr/local/bin:/usr/bin:/bin");
  if (found.empty()) return {};
  std::vector<std::string> arguments{found.string(), "--unshare-all", "--die-with-parent", "--new-session",
                                     "--clearenv"};
  for (const char* folder : {"/usr", "/lib", "/lib64", "/bin", "/etc/ld.so.cache"})
    arguments.insert(arguments.end(), {"--ro-bind-try", folder, folder});
  arguments.insert(arguments.end(), {"--dev", "/dev", "--proc", "/proc"});
  return arguments;
}

bool try_bubblewrap() {
  std::vector<std::string> command = bubblewrap_arguments();
  if (command.empty()) return false;
  command.emplace_back("/usr/bin/true");
  try {
    const PrivateFolder place;
    const Launched launched = launch({.command = command,
                                      .environment = {},
                                      .folder = place.path(),
                                      .input = {},
                                      .limits = {},
                                      .rights = LaunchRights::nobody_for_root});
    return launched.end == LaunchEnd::exited && launched.status == 0;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

bool bubblewrap_works() {
  static const bool works = try_bubblewrap();
  return works;
}

std::vector<std::string> isolated_command(const std::filesystem::path& program, const std::filesystem::path& folder) {
  if (!bubblewrap_works()) return {};
  std::vector<std::string> command = bubblewrap_arguments();
  const std::string file = program.string(), home = folder.string();
  command.insert(command.end(), {"--ro-bind", file, file, "--bind", home, home, "--chdir", home, file});
  return command;
}

}  // namespace ps
