// What a power cut may leave of a written file: its bytes are on the disk before it takes the name, and the name is
// before the function returns. The system call is watched by a function of its name, which stands before the library's.
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "support/run_cli.h"

namespace {

std::string watched_name;         // empty: nothing is watched
std::vector<std::string> synced;  // in order: what was brought to the disk, and what the name held then

}  // namespace

extern "C" int fsync(int file) {
  struct stat found {};
  if (!watched_name.empty() && fstat(file, &found) == 0)
    synced.push_back((S_ISDIR(found.st_mode) ? std::string("folder") : std::to_string(found.st_size) + " bytes") +
                     " while the name holds " + ps::read_whole_file(watched_name));
  return static_cast<int>(syscall(SYS_fsync, file));
}

namespace {

TEST(SyncedFile, BytesBeforeTheNameAndTheNameBeforeTheEnd) {
  const ps::test::ScratchFolder folder;
  const std::string file = folder.write("file", "old");
  watched_name = file;
  synced.clear();
  ps::write_file_atomically(file, "the new content");
  EXPECT_EQ(synced, (std::vector<std::string>{"15 bytes while the name holds old",
                                              "folder while the name holds the new content"}));
  synced.clear();
  ps::write_file_atomically(file, "quick", ps::Durability::quick);
  EXPECT_TRUE(synced.empty()) << "what the window writes while something is dragged does not wait for the disk";
  watched_name.clear();
}

}  // namespace
