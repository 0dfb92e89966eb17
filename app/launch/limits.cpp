#include "launch/limits.h"

#include <dirent.h>
#include <grp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

namespace launch {
namespace {

bool limit(int resource, std::uint64_t soft, std::uint64_t hard) {
  rlimit now{};
  if (getrlimit(static_cast<__rlimit_resource_t>(resource), &now) != 0) return false;
  const auto at_most = [&](std::uint64_t wanted) { return wanted < now.rlim_max ? wanted : now.rlim_max; };
  const rlimit wanted{at_most(soft), at_most(hard)};
  return setrlimit(static_cast<__rlimit_resource_t>(resource), &wanted) == 0;
}

/// How many threads this user's processes have now: RLIMIT_NPROC counts them all, the window's too.
std::uint64_t threads_of_user() {
  std::uint64_t count = 0;
  DIR* folder = opendir("/proc");
  if (!folder) return 0;
  while (const dirent* entry = readdir(folder)) {
    if (entry->d_name[0] < '1' || entry->d_name[0] > '9') continue;
    char path[300];
    struct stat status {};
    std::snprintf(path, sizeof path, "/proc/%s/task", entry->d_name);
    if (stat(path, &status) != 0 || status.st_uid != getuid()) continue;
    count += status.st_nlink > 2 ? status.st_nlink - 2 : 1;  // a folder for each thread
  }
  closedir(folder);
  return count;
}

}  // namespace

bool limit_this_process(const Limits& limits) {
  if (limits.user > 0 && geteuid() == 0) {
    const auto user = static_cast<uid_t>(limits.user);
    if (setgroups(0, nullptr) != 0 || setgid(user) != 0 || setuid(user) != 0) return false;
  }
  const std::uint64_t seconds = (limits.processor_milliseconds + 999) / 1000;
  const std::uint64_t tasks = threads_of_user() + limits.processes;
  return limit(RLIMIT_CPU, seconds, seconds + 1) && limit(RLIMIT_AS, limits.memory, limits.memory) &&
         limit(RLIMIT_FSIZE, limits.file_bytes, limits.file_bytes) && limit(RLIMIT_CORE, 0, 0) &&
         limit(RLIMIT_NPROC, tasks, tasks) && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0;
}

}  // namespace launch
