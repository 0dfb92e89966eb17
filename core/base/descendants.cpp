#include "base/descendants.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unordered_map>

namespace ps {
namespace {

struct ProcessRow {
  pid_t process = 0, parent = 0;
  char state = '?';
  std::uint64_t pages = 0;  ///< resident
  bool below = false;       ///< a descendant of the process that is asked about
};

/// Reads /proc/PROCESS/stat: "PROCESS (NAME) STATE PARENT ...". The name may hold anything, brackets too. Answers
/// whether the process is still there.
bool read_row(const char* process, ProcessRow& row) {
  char path[64], text[1024];
  std::snprintf(path, sizeof path, "/proc/%s/stat", process);
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const ssize_t size = read(file, text, sizeof text - 1);
  close(file);
  if (size <= 0) return false;
  text[size] = '\0';
  const char* after_name = std::strrchr(text, ')');
  if (!after_name) return false;
  int parent = 0;
  unsigned long pages = 0;
  const int fields = std::sscanf(
      after_name + 1, " %c %d %*d %*d %*d %*d %*u %*u %*u %*u %*u %*u %*u %*d %*d %*d %*d %*d %*d %*u %*u %lu",
      &row.state, &parent, &pages);
  row.process = static_cast<pid_t>(std::atoi(process));
  row.parent = parent;
  row.pages = pages;
  return fields == 3;
}

std::vector<ProcessRow> all_processes() {
  std::vector<ProcessRow> rows;
  DIR* folder = opendir("/proc");
  if (!folder) return rows;
  while (const dirent* entry = readdir(folder)) {
    ProcessRow row;
    if (entry->d_name[0] >= '1' && entry->d_name[0] <= '9' && read_row(entry->d_name, row)) rows.push_back(row);
  }
  closedir(folder);
  return rows;
}

/// Marks the rows of all that began below `root`. Children may have smaller numbers than their parents, for
/// numbers are used again.
void mark_below(std::vector<ProcessRow>& rows, pid_t root) {
  std::unordered_map<pid_t, std::vector<ProcessRow*>> children;
  for (ProcessRow& row : rows) children[row.parent].push_back(&row);
  std::vector<pid_t> parents{root};
  while (!parents.empty()) {
    const auto found = children.find(parents.back());
    parents.pop_back();
    if (found == children.end()) continue;
    for (ProcessRow* row : found->second) {
      row->below = true;
      parents.push_back(row->process);
    }
    children.erase(found);
  }
}

}  // namespace

Descendants descendants(pid_t root) {
  std::vector<ProcessRow> rows = all_processes();
  mark_below(rows, root);
  Descendants all;
  const auto page = static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  for (const ProcessRow& row : rows) {
    if (!row.below || row.state == 'Z') continue;
    all.processes.push_back(row.process);
    all.resident += row.pages * page;
  }
  return all;
}

bool end_descendants(pid_t root, pid_t group) {
  constexpr int most_rounds = 2000;
  const bool own = root == getpid();
  for (int round = 0; round < most_rounds; ++round) {
    if (group > 0) kill(-group, SIGKILL);  // all of the group at once: none of them can start another in between
    const std::vector<pid_t> running = descendants(root).processes;
    for (const pid_t process : running) kill(process, SIGKILL);
    pid_t ended = own ? 1 : 0;
    while (own && ended > 0) ended = waitpid(-1, nullptr, WNOHANG);
    if (own ? ended < 0 && errno == ECHILD : running.empty()) return true;
    usleep(1000);
  }
  return false;
}

}  // namespace ps
