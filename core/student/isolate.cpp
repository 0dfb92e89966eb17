#include "student/isolate.h"

#include <signal.h>

#include "base/check.h"
#include "student/find_program.h"
#include "student/private_folder.h"

namespace ps {
namespace {

constexpr int signal_base = 128;  // bubblewrap adds it to the number of the signal that ended its program

std::filesystem::path bubblewrap() { return find_program({"bwrap"}, "/usr/local/bin:/usr/bin:/bin"); }

std::vector<std::string> bubblewrap_arguments() {
  const std::filesystem::path found = bubblewrap();
  if (found.empty()) return {};
  std::vector<std::string> arguments{found.string(), "--unshare-all", "--die-with-parent", "--new-session"};
  for (const char* place : {"/usr", "/lib", "/lib64", "/bin", "/etc/ld.so.cache", "/etc/alternatives"})
    arguments.insert(arguments.end(), {"--ro-bind-try", place, place});
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

std::string_view protection_sentence() {
  if (bubblewrap_works()) return "Your listing is compiled and run shut off from your files and the network.";
  return bubblewrap().empty()
             ? "Your listing runs with your rights: limits stop mistakes, not intent. Install bubblewrap "
               "to shut it off from your files and the network."
             : "Your listing runs with your rights: limits stop mistakes, not intent. bubblewrap is "
               "installed, but this system does not let it work.";
}

Launched launch_isolated(Launch what, const std::vector<std::filesystem::path>& readable, Isolation isolation,
                         const Progress* progress) {
  what.rights = LaunchRights::nobody_for_root;
  if (isolation == Isolation::limits_only || !bubblewrap_works()) return launch(what, progress);
  std::vector<std::string> command = bubblewrap_arguments();
  for (const std::filesystem::path& place : readable)
    command.insert(command.end(), {"--ro-bind", place.string(), place.string()});
  const std::string folder = what.folder.string();
  command.insert(command.end(), {"--bind", folder, folder, "--chdir", folder});
  command.insert(command.end(), what.command.begin(), what.command.end());
  what.command = std::move(command);
  Launched launched = launch(what, progress);
  if (launched.end == LaunchEnd::exited && launched.status > signal_base) {
    launched.status -= signal_base;
    launched.end = launched.status == SIGXCPU ? LaunchEnd::processor_time : LaunchEnd::signalled;
  }
  return launched;
}

}  // namespace ps
