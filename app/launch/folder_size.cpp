#include "launch/folder_size.h"

#include <ftw.h>
#include <sys/stat.h>

namespace launch {
namespace {

constexpr int most_files = 10000, descriptors = 16;
constexpr std::uint64_t bytes_of_a_block = 512;  // as stat(2) has it

// nftw() gives its caller no way to hand anything over.
std::uint64_t bytes_found = 0, most_bytes = 0;
int files_found = 0;

int count(const char*, const struct stat* status, int kind, FTW*) {
  if (kind == FTW_F) bytes_found += static_cast<std::uint64_t>(status->st_blocks) * bytes_of_a_block;
  return bytes_found > most_bytes || ++files_found > most_files ? 1 : 0;
}

}  // namespace

bool holds_more_than(const char* folder, std::uint64_t bytes) {
  bytes_found = 0;
  most_bytes = bytes;
  files_found = 0;
  return nftw(folder, count, descriptors, FTW_PHYS | FTW_MOUNT) == 1;
}

}  // namespace launch
