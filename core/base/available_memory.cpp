#include "base/available_memory.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include "base/check.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace ps {
namespace {

#ifdef __linux__
/// Parses a file of one number; nullopt for "max", and where there is no such file.
std::optional<std::uint64_t> number_in_file(const char* path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  if (file >> number) return number;
  return {};
}

std::optional<std::uint64_t> spare_of_system() {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  for (std::uint64_t kilobytes = 0; file >> name >> kilobytes; std::getline(file, unit))
    if (name == "MemAvailable:") return kilobytes * 1024;
  return {};
}

std::optional<std::uint64_t> spare_of_container(const char* limit_file, const char* used_file) {
  const auto limit = number_in_file(limit_file), used = number_in_file(used_file);
  if (!limit || !used) return {};
  return *limit - std::min(*limit, *used);
}

std::optional<std::uint64_t> spare_of_process() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return {};
  const auto pages = number_in_file("/proc/self/statm");
  if (!pages) return {};
  const std::uint64_t used = *pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return limit.rlim_cur - std::min<std::uint64_t>(limit.rlim_cur, used);
}
#endif

std::string in_gigabytes(std::uint64_t bytes) { return fmt::format("{:.3g} GB", static_cast<double>(bytes) / 1e9); }

}  // namespace

std::optional<std::uint64_t> available_memory() {
  std::optional<std::uint64_t> least;
#ifdef __linux__
  for (const auto& spare : {spare_of_system(), spare_of_process(),
                            spare_of_container("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current"),
                            spare_of_container("/sys/fs/cgroup/memory/memory.limit_in_bytes",
                                               "/sys/fs/cgroup/memory/memory.usage_in_bytes")})
    if (spare) least = std::min(*spare, least.value_or(*spare));
#endif
  return least;
}

std::uint64_t usable_part(std::uint64_t available) { return available / 4 * 3; }

void require_memory(std::uint64_t bytes, std::optional<std::uint64_t> available, std::string_view what,
                    std::string_view cure) {
  constexpr std::uint64_t always_there = 256u << 20;  // too little to refuse by an estimate
  if (!available || bytes <= always_there || bytes <= usable_part(*available)) return;
  throw InputError(fmt::format("{} need {} of memory, and this computer can spare {}: {}", what, in_gigabytes(bytes),
                               in_gigabytes(usable_part(*available)), cure));
}

}  // namespace ps
