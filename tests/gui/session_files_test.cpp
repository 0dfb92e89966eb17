// What happens to files behind the window's back, and what is left behind by a crash.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "gui/app/autosave.h"
#include "gui/app/file_watch.h"

namespace ps::gui {
namespace {

using namespace std::chrono_literals;

class SessionFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("pixelscope-session-files-" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }

  std::filesystem::path folder_;
};

bool becomes_true(const std::function<bool()>& condition) {
  for (int i = 0; i < 3000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

TEST_F(SessionFiles, WatchTellsOfAWriteOnce) {
  write("a.scene", "one");
  std::atomic<int> wakes{0};
  FileWatch watch([&] { ++wakes; });
  watch.watch({folder_ / "a.scene", folder_ / "missing.obj"});
  EXPECT_FALSE(watch.take_changed());
  write("a.scene", "another length");
  ASSERT_TRUE(becomes_true([&] { return watch.take_changed(); }));
  EXPECT_GE(wakes, 1);
  std::this_thread::sleep_for(700ms);
  EXPECT_FALSE(watch.take_changed()) << "nothing was written since";
}

TEST_F(SessionFiles, WatchSeesAFileThatIsReplaced) {
  write("a.scene", "one");
  FileWatch watch({});
  watch.watch({folder_ / "a.scene"});
  std::filesystem::remove(folder_ / "a.scene");  // as editors do
  std::this_thread::sleep_for(400ms);
  write("new", "two!");
  std::filesystem::rename(folder_ / "new", folder_ / "a.scene");
  EXPECT_TRUE(becomes_true([&] { return watch.take_changed(); }));
}

TEST_F(SessionFiles, AutosaveIsGoneAfterAProperEnd) {
  {
    Autosave autosave(folder_);
    autosave.save("scene=cgfs/shadows");
    EXPECT_FALSE(std::filesystem::is_empty(folder_));
    Autosave second(folder_);
    EXPECT_FALSE(second.take_left_behind()) << "its program still runs";
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(SessionFiles, AutosaveOfACrashedProgramIsFoundOnce) {
  write("open-999999999.permalink", "scene=cgfs/shadows");  // no process has this number
  write("open-x.permalink", "not one of ours");
  Autosave autosave(folder_);
  EXPECT_EQ(autosave.take_left_behind(), "scene=cgfs/shadows");
  EXPECT_EQ(autosave.take_left_behind(), std::nullopt);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "open-x.permalink"));
}

TEST_F(SessionFiles, AutosaveIntoAFolderThatCannotBeMadeIsSilent) {
  write("file", "");
  Autosave autosave(folder_ / "file" / "below");
  autosave.save("scene=cgfs/shadows");
  EXPECT_FALSE(autosave.take_left_behind());
}

}  // namespace
}  // namespace ps::gui
