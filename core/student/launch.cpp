#include "student/launch.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>

#include "base/descendants.h"
#include "base/foreign_text.h"
#include "base/number_text.h"
#include "base/resources.h"
#include "base/timer.h"
#include "student/descriptors.h"
#include "student/last_words.h"

namespace ps {
namespace {

constexpr std::size_t most_text_kept = 64 << 10;
constexpr int milliseconds_between_looks = 20;   // whether to stop
constexpr int milliseconds_after_the_end = 500;  // for what is still in the pipes
constexpr int milliseconds_of_grace = 2000;      // for the launcher to end what has had its time
constexpr int milliseconds_to_leave = 1000;      // for the launcher to end all when it is asked to

constexpr uid_t nobody = 65534;

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  all.reserve(texts.size() + 1);
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

std::string milliseconds_text(double seconds) { return std::to_string(std::llround(seconds * 1000)); }

/// The launcher's process. Ends all that it started, and waits for that, when it goes. A program without isolation can
/// stop the launcher as it can stop any process of this user, so each wait for it here has a limit.
class LauncherProcess {
 public:
  explicit LauncherProcess(const Launch& what) {
    const LaunchLimits& limits = what.limits;
    std::vector<std::string> arguments{launcher_program().string(),
                                       what.folder.string(),
                                       milliseconds_text(limits.processor_seconds),
                                       milliseconds_text(limits.seconds),
                                       std::to_string(limits.memory),
                                       std::to_string(limits.processes),
                                       std::to_string(limits.file_bytes),
                                       std::to_string(what.rights == LaunchRights::own ? 0 : nobody)};
    arguments.insert(arguments.end(), what.command.begin(), what.command.end());
    std::vector<std::string> environment = what.environment;
    const Descriptor input(open(what.input.empty() ? "/dev/null" : what.input.c_str(), O_RDONLY | O_CLOEXEC));

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    const std::array given{input.number(), text.in.number(), text.in.number(), result.in.number(),
                           control.theirs.number()};
    for (std::size_t i = 0; i < given.size(); ++i)
      posix_spawn_file_actions_adddup2(&files, given[i], static_cast<int>(i));
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    const int error = posix_spawn(&process_, arguments[0].c_str(), &files, &attributes, pointers(arguments).data(),
                                  pointers(environment).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) {
      process_ = -1;
      throw InputError(fmt::format("{} cannot be started: {}", arguments[0], std::strerror(error)));
    }
    text.in.close();
    result.in.close();
    control.theirs.close();
  }
  ~LauncherProcess() {
    control.ours.close();
    if (process_ < 0) return;
    for (const Timer waited; waited.milliseconds() < milliseconds_to_leave;) {
      const pid_t ended = waitpid(process_, nullptr, WNOHANG);
      if (ended == process_ || (ended < 0 && errno != EINTR)) return;
      poll(nullptr, 0, 1);
    }
    end_descendants(process_);  // before their launcher, which keeps hold of those that lost their parent
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  LauncherProcess(const LauncherProcess&) = delete;
  LauncherProcess& operator=(const LauncherProcess&) = delete;

  Pipe text, result;
  SocketPair control;

 private:
  pid_t process_ = -1;
};

/// Appends what can be read now; closes at the end. Answers whether anything came.
bool read_some(Descriptor& from, std::string& to) {
  std::array<char, 65536> bytes;
  if (from.number() < 0) return false;
  const ssize_t size = read(from.number(), bytes.data(), bytes.size());
  if (size > 0) {
    to.append(bytes.data(), static_cast<std::size_t>(size));
    return true;
  }
  if (size == 0 || (errno != EAGAIN && errno != EINTR)) from.close();
  return false;
}

/// The launcher's last line: "exited 3".
void read_verdict(const std::string& line, const Launch& what, Launched& launched) {
  const std::size_t blank = line.find(' ');
  const std::string word = line.substr(0, blank);
  std::string_view behind = blank == std::string::npos ? std::string_view{} : std::string_view(line).substr(blank + 1);
  const int number = take_integer<int>(behind).value_or(0);  // a line end follows
  launched.status = number;
  if (word == "exited")
    launched.end = LaunchEnd::exited;
  else if (word == "signalled")
    launched.end = number == SIGXCPU ? LaunchEnd::processor_time : LaunchEnd::signalled;
  else if (word == "time")
    launched.end = LaunchEnd::time;
  else if (word == "memory")
    launched.end = LaunchEnd::memory;
  else if (word == "processes")
    launched.end = LaunchEnd::processes;
  else if (word == "files")
    launched.end = LaunchEnd::files;
  else if (word == "failed")
    throw InputError(fmt::format("{} cannot be started: {}{}", what.command[0], std::strerror(number),
                                 number == EACCES ? folder_hint : ""));
  else {
    const std::string words = last_words(foreign_text(launched.text));
    throw InputError(fmt::format("{} ended {}", launcher_program().string(),
                                 words.empty() ? "without a word" : "with the words: " + words));
  }
}

/// All that comes from the program until it has ended or has written too much.
class LaunchedOutput {
 public:
  LaunchedOutput(const LaunchLimits& limits, Launched& launched) : limits_(limits), launched_(launched) {}

  /// Answers whether it has written too much.
  bool take(LauncherProcess& process) {
    for (bool more = true; more;) {
      std::string text;
      more = read_some(process.text.out, text);
      written_ += text.size();
      const std::size_t room = most_text_kept - launched_.text.size();
      launched_.text.append(text, 0, room);
      launched_.text_cut = launched_.text_cut || text.size() > room;
      more = read_some(process.result.out, launched_.result) || more;
      if (written_ > limits_.text_bytes) return exceeded(LaunchEnd::text);
      if (launched_.result.size() > limits_.result_bytes) return exceeded(LaunchEnd::result);
    }
    return false;
  }

 private:
  bool exceeded(LaunchEnd end) {
    launched_.end = end;
    return true;
  }
  const LaunchLimits& limits_;
  Launched& launched_;
  std::uint64_t written_ = 0;
};

}  // namespace

void give_to_nobody(const std::filesystem::path& folder) {
  if (geteuid() != 0) return;
  const auto give = [](const std::filesystem::path& place) {
    if (lchown(place.c_str(), nobody, nobody) != 0)
      throw InputError(fmt::format("{} cannot be given to another user: {}", place.string(), std::strerror(errno)));
  };
  give(folder);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) give(entry.path());
}

Launched launch(const Launch& what, const Progress* progress) {
  const Timer timer;
  Launched launched;
  LauncherProcess process(what);
  LaunchedOutput output(what.limits, launched);
  std::string verdict;
  while (process.control.ours.number() >= 0) {
    if (progress) progress->check();
    if (timer.milliseconds() > what.limits.seconds * 1000 + milliseconds_of_grace) {
      launched.end = LaunchEnd::time;
      launched.seconds = timer.milliseconds() / 1000;
      return launched;
    }
    std::array<pollfd, 3> waiting{{{process.control.ours.number(), POLLIN, 0},
                                   {process.text.out.number(), POLLIN, 0},
                                   {process.result.out.number(), POLLIN, 0}}};
    poll(waiting.data(), waiting.size(), milliseconds_between_looks);
    if (output.take(process)) return launched;
    read_some(process.control.ours, verdict);
  }
  // Everything below the launcher has ended; what it left in the pipes ends with a closed end of them.
  for (const Timer after; after.milliseconds() < milliseconds_after_the_end &&
                          (process.text.out.number() >= 0 || process.result.out.number() >= 0);) {
    if (output.take(process)) return launched;
    std::array<pollfd, 2> waiting{{{process.text.out.number(), POLLIN, 0}, {process.result.out.number(), POLLIN, 0}}};
    poll(waiting.data(), waiting.size(), milliseconds_between_looks);
  }
  read_verdict(verdict, what, launched);
  launched.seconds = timer.milliseconds() / 1000;
  return launched;
}

}  // namespace ps
