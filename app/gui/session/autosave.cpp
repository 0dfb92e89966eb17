#include "gui/session/autosave.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/check.h"

namespace ps::gui {
namespace {

constexpr std::string_view prefix = "open-";
constexpr const char* saved_ending = ".permalink";
constexpr const char* lock_ending = ".lock";
constexpr std::uintmax_t largest = 1 << 20;
constexpr std::string_view restored_mark = "restored\n", outside_mark = "ended from outside\n";  // in lock files

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// This computer's name as part of a file name.
std::string host_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "host";
  std::string text = name.data();
  for (char& c : text)
    if (c == '/' || c == '-') c = '_';
  return text.empty() ? "host" : text;
}

bool process_runs(const std::string& number) {
  std::error_code error;
  return std::filesystem::exists("/proc/" + number, error);
}

/// An autosave file of some program.
struct SavedFile {
  std::filesystem::path path;
  std::string owner;  ///< the name between prefix and ending: HOST-PROCESS, with -N behind it for the N-th of that name
};

std::optional<SavedFile> saved_file(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (!name.starts_with(prefix) || path.extension() != saved_ending) return {};
  return SavedFile{path, path.stem().string().substr(prefix.size())};
}

/// Where the file system has no locks: a process of this computer that runs, or one of another computer.
bool may_run(const std::string& owner) {
  const std::size_t dash = owner.find('-');
  if (dash == std::string::npos || owner.substr(0, dash) != host_name()) return true;
  const std::string process = owner.substr(dash + 1);
  return process_runs(process.substr(0, process.find('-')));
}

/// A lock on the files of a program that has ended; nothing for one that runs, and for what no autosave wrote.
struct Ended {
  std::optional<FileLock> lock;
  std::filesystem::path lock_file;
  std::string mark;  ///< what the lock file says
};
std::string mark_in(const std::filesystem::path& lock_file) {
  try {
    return read_whole_file(lock_file, largest);
  } catch (const InputError&) {
    return {};
  }
}
std::optional<Ended> ended(const SavedFile& saved) {
  auto lock_file = saved.path;
  lock_file.replace_extension(lock_ending);
  std::error_code error;
  if (!std::filesystem::exists(lock_file, error)) {
    // Versions without lock files had the process number alone in the name.
    if (!is_digits(saved.owner) || process_runs(saved.owner)) return {};
    return Ended{};
  }
  try {
    auto lock = FileLock::try_lock(lock_file);
    if (!lock || (!lock->guards() && may_run(saved.owner))) return {};
    return Ended{std::move(lock), lock_file, mark_in(lock_file)};
  } catch (const InputError&) {
    return {};
  }
}

/// "2026-11-23-1405", when the file was written last.
std::string date_of(const std::filesystem::path& path) {
  struct stat found {};
  stat(path.c_str(), &found);
  std::tm parts{};
  localtime_r(&found.st_mtime, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d-%H%M", &parts);
  return text.data();
}

/// Moves a file to a name that nothing has yet; where it cannot be moved it stays.
std::filesystem::path moved_aside(const std::filesystem::path& path) {
  std::error_code error;
  const std::string date = date_of(path);
  for (int number = 1; number < 1000; ++number) {
    const auto name = path.parent_path() / fmt::format("left-behind-{}{}{}", date,
                                                       number == 1 ? "" : fmt::format("-{}", number), saved_ending);
    if (std::filesystem::exists(name, error)) continue;
    std::filesystem::rename(path, name, error);
    return error ? path : name;
  }
  return path;
}

}  // namespace

Autosave::Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

Autosave::~Autosave() {
  if (name_.empty() || keep_) return;
  std::error_code ignored;
  std::filesystem::remove(with_ending(saved_ending), ignored);
  std::filesystem::remove(with_ending(lock_ending), ignored);
}

std::filesystem::path Autosave::with_ending(const char* ending) const { return folder_ / (name_ + ending); }

std::vector<LeftBehind> Autosave::take_left_behind() {
  std::vector<LeftBehind> found;
  if (folder_.empty()) return found;
  std::error_code error;
  std::vector<SavedFile> files;
  for (auto entry = std::filesystem::directory_iterator(folder_, error);
       !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
    if (auto file = saved_file(entry->path())) files.push_back(std::move(*file));
  for (const SavedFile& file : files) {
    const auto owner = ended(file);
    if (!owner || !std::filesystem::exists(file.path, error)) continue;  // another window may have been faster
    LeftBehind session;
    session.saved = std::filesystem::last_write_time(file.path, error);
    session.file = moved_aside(file.path);
    session.ended_at_once = owner->mark == restored_mark;
    session.ended_from_outside = owner->mark == outside_mark;
    if (!owner->lock_file.empty()) std::filesystem::remove(owner->lock_file, error);
    try {
      session.text = read_whole_file(session.file, largest);
      if (session.text.empty()) session.problem = session.file.string() + ": is empty";
    } catch (const InputError& problem) {
      session.problem = problem.what();
    }
    found.push_back(std::move(session));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const LeftBehind& a, const LeftBehind& b) { return a.saved > b.saved; });
  return found;
}

/// A name that neither a program that runs nor one that was left behind has. Answers whether there is one.
bool Autosave::find_own_name() {
  std::error_code error;
  for (int number = 1; number < 100; ++number) {
    name_ = fmt::format("{}{}-{}{}", prefix, host_name(), getpid(), number == 1 ? "" : fmt::format("-{}", number));
    lock_ = FileLock::try_lock(with_ending(lock_ending));
    if (lock_ && !std::filesystem::exists(with_ending(saved_ending), error)) return true;
  }
  name_.clear();
  return false;
}

void Autosave::outlived_start() {
  if (!std::exchange(marked_, false) || name_.empty()) return;
  std::ofstream(with_ending(lock_ending)).flush();  // empties it; the lock stays
}

void Autosave::end_from_outside() {
  keep();
  if (!name_.empty()) std::ofstream(with_ending(lock_ending)) << outside_mark;
}

void Autosave::save(const std::string& text) {
  if (folder_.empty() || text.empty() || text == saved_) return;
  std::error_code ignored;
  std::filesystem::create_directories(folder_, ignored);
  try {
    if (name_.empty()) {
      if (!find_own_name()) throw InputError(folder_.string() + ": no name is free");
      if (marked_) std::ofstream(with_ending(lock_ending)) << restored_mark;
    }
    write_file_atomically(with_ending(saved_ending), text, Durability::quick);
    saved_ = text;
    problem_.clear();
    if (!restored_.empty()) std::filesystem::remove(std::exchange(restored_, {}), ignored);
  } catch (const InputError& error) {
    problem_ = error.what();
    if (!saved_.empty()) return;
    lock_.reset();
    if (!name_.empty()) std::filesystem::remove(with_ending(lock_ending), ignored);  // it guards nothing
    name_.clear();
  }
}

}  // namespace ps::gui
