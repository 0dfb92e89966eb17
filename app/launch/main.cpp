// pixelscope-launch: starts a program with limits and ends it, with everything that it started, when it is done,
// exceeds one of them, or the caller goes away. It links nothing of Pixelscope but one small file, so that it
// starts in a millisecond and its memory holds nothing worth reading.
//
//   pixelscope-launch FOLDER PROCESSOR-MS MS MEMORY PROCESSES FILE-BYTES USER PROGRAM ARGUMENT...
//
// Descriptors 0 to 3 go to the program. 4 is a socket of the caller: when that closes all is ended, and before its own
// end this program writes one line there: "exited STATUS", "signalled SIGNAL", "time", "memory", "processes", "files"
// or "failed WHY".
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/descendants.h"
#include "launch/folder_size.h"
#include "launch/limits.h"

namespace {

using Clock = std::chrono::steady_clock;

constexpr int control = 4;
constexpr int own_arguments = 8;            // the program's name and seven more
constexpr int milliseconds_of_a_look = 20;  // between two looks at what runs

void close_from(int first) {
#ifdef SYS_close_range
  if (syscall(SYS_close_range, static_cast<unsigned>(first), ~0U, 0U) == 0) return;
#endif
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  for (int file = first; file < static_cast<int>(files.rlim_cur < 65536 ? files.rlim_cur : 65536); ++file) close(file);
}

[[noreturn]] void answer(const char* word, int number) {
  char line[128];
  const int size = std::snprintf(line, sizeof line, "%s %d\n", word, number);
  static_cast<void>(!write(control, line, static_cast<std::size_t>(size)));
  _exit(0);
}

/// Becomes the program; in the child.
[[noreturn]] void become(char** command, const launch::Limits& limits, pid_t launcher) {
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (!launch::limit_this_process(limits)) answer("failed", errno);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // another user's rights would end it
  if (getppid() != launcher) _exit(127);
  const int kept = 9;  // the only way to report that the program cannot be started; closed when it is
  dup3(control, kept, O_CLOEXEC);
  close(control);
  execv(command[0], command);
  const int reason = errno;
  dup2(kept, control);
  answer("failed", reason);
}

/// Waits until the child has ended, a limit is exceeded, or the caller is gone.
[[noreturn]] void watch(pid_t child, const launch::Limits& limits, int children) {
  const auto end = Clock::now() + std::chrono::milliseconds(limits.milliseconds);
  for (;;) {
    pollfd waiting[] = {{control, POLLIN, 0}, {children, POLLIN, 0}};
    poll(waiting, 2, milliseconds_of_a_look);
    if (waiting[0].revents != 0) {  // nothing is ever sent this way: the caller is gone or wants an end
      ps::end_descendants(getpid(), child);
      _exit(0);
    }
    if (waiting[1].revents != 0) {
      signalfd_siginfo news;
      static_cast<void>(!read(children, &news, sizeof news));
    }
    int status = 0;
    for (pid_t ended = 0; (ended = waitpid(-1, &status, WNOHANG)) > 0;) {
      if (ended != child) continue;
      ps::end_descendants(getpid(), child);
      if (WIFSIGNALED(status)) answer("signalled", WTERMSIG(status));
      answer("exited", WEXITSTATUS(status));
    }
    const char* exceeded = nullptr;
    if (Clock::now() >= end) exceeded = "time";
    const ps::Descendants running = ps::descendants(getpid());
    if (running.resident > limits.memory) exceeded = "memory";
    if (running.processes.size() > limits.processes) exceeded = "processes";
    if (launch::holds_more_than(".", limits.file_bytes)) exceeded = "files";
    if (!exceeded) continue;
    ps::end_descendants(getpid(), child);
    answer(exceeded, 0);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc <= own_arguments) {
    std::fprintf(stderr,
                 "usage: pixelscope-launch FOLDER PROCESSOR-MS MS MEMORY PROCESSES FILE-BYTES USER PROGRAM...\n");
    return 2;
  }
  close_from(control + 1);
  const auto number = [&](int index) { return std::strtoull(argv[index], nullptr, 10); };
  const launch::Limits limits{number(2), number(3), number(4), number(5), number(6), number(7)};
  if (chdir(argv[1]) != 0) answer("failed", errno);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  signal(SIGPIPE, SIG_IGN);
  sigset_t child_ended;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  sigprocmask(SIG_BLOCK, &child_ended, nullptr);
  const int children = signalfd(-1, &child_ended, SFD_CLOEXEC);
  const pid_t launcher = getpid();
  const pid_t child = fork();
  if (child < 0) answer("failed", errno);
  if (child == 0) {
    signal(SIGPIPE, SIG_DFL);
    become(argv + own_arguments, limits, launcher);
  }
  setpgid(child, child);                                   // here as well: whichever of the two comes first
  for (int file = 0; file < control; ++file) close(file);  // only the program holds them open
  watch(child, limits, children);
}
