// What happens to files behind the window's back, and what is left behind by a crash.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "gui/session/autosave.h"
#include "gui/work/file_watch.h"

namespace ps::gui::session_files_test {
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

TEST_F(SessionFiles, WatchReportsAWriteOnce) {
  write("a.scene", "one");
  std::atomic<int> wakes{0};
  FileWatch watch([&] { ++wakes; });
  watch.watch({folder_ / "a.scene", folder_ / "missing.obj"});
  EXPECT_TRUE(watch.take_changed().empty());
  write("a.scene", "another length");
  std::vector<std::filesystem::path> changed;
  ASSERT_TRUE(becomes_true([&] { return !(changed = watch.take_changed()).empty(); }));
  EXPECT_EQ(changed, std::vector{folder_ / "a.scene"});
  EXPECT_GE(wakes, 1);
  std::this_thread::sleep_for(700ms);
  EXPECT_TRUE(watch.take_changed().empty()) << "nothing was written since";
}

TEST_F(SessionFiles, WatchSeesAFileThatIsReplaced) {
  write("a.scene", "one");
  FileWatch watch({});
  watch.watch({folder_ / "a.scene"});
  std::filesystem::remove(folder_ / "a.scene");  // as editors do
  std::this_thread::sleep_for(400ms);
  write("new", "two!");
  std::filesystem::rename(folder_ / "new", folder_ / "a.scene");
  EXPECT_TRUE(becomes_true([&] { return !watch.take_changed().empty(); }));
}

TEST_F(SessionFiles, AutosaveIsGoneAfterAProperEnd) {
  {
    Autosave autosave(folder_);
    autosave.save("scene=cgfs/shadows");
    EXPECT_FALSE(std::filesystem::is_empty(folder_));
    Autosave second(folder_);
    EXPECT_TRUE(second.take_left_behind().empty()) << "its program still runs";
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

// A file in the folder's place fails as a full disk does, also for root.
TEST_F(SessionFiles, AutosaveSaysThatItFailsAndTriesAgain) {
  const std::filesystem::path folder = folder_ / "state";
  Autosave autosave(folder);
  autosave.save("scene=cgfs/shadows");
  EXPECT_EQ(autosave.problem(), "");
  for (int times = 0; times < 2; ++times) {
    std::filesystem::remove_all(folder);
    std::ofstream(folder) << "in the way";
    autosave.save("scene=cgfs/lens");
    EXPECT_NE(autosave.problem(), "");
    autosave.save("scene=cgfs/lens");
    EXPECT_NE(autosave.problem(), "") << "it fails as often as it is tried";
    std::filesystem::remove(folder);
    autosave.save("scene=cgfs/lens");
    EXPECT_EQ(autosave.problem(), "");
    autosave.save("scene=cgfs/crates");
  }
  Autosave never(folder_ / "other");
  std::ofstream(folder_ / "other") << "in the way from the start";
  never.save("scene=cgfs/lens");
  EXPECT_NE(never.problem(), "");
  std::filesystem::remove(folder_ / "other");
  never.save("scene=cgfs/lens");
  EXPECT_EQ(never.problem(), "");
}

/// As a program leaves its files that does not end properly.
void leave_behind(const std::filesystem::path& folder, const std::string& text) {
  Autosave autosave(folder);
  autosave.save(text);
  autosave.keep();
}

std::string only_text(const std::vector<LeftBehind>& found) {
  return found.size() == 1 && found[0].problem.empty() ? found[0].text : "not one good session";
}

TEST_F(SessionFiles, AutosaveOfACrashedProgramIsFoundOnce) {
  write("open-999999999.permalink", "scene=cgfs/shadows");  // as earlier versions named it; no process has this number
  write("open-x.permalink", "not one of ours");
  Autosave autosave(folder_);
  EXPECT_EQ(only_text(autosave.take_left_behind()), "scene=cgfs/shadows");
  EXPECT_TRUE(autosave.take_left_behind().empty());
  EXPECT_TRUE(std::filesystem::exists(folder_ / "open-x.permalink"));
  leave_behind(folder_, "scene=cgfs/lens");
  EXPECT_EQ(only_text(autosave.take_left_behind()), "scene=cgfs/lens");
}

// The lock decides, not a process number, which another computer or container gives again.
TEST_F(SessionFiles, AutosaveOfAProgramElsewhereIsLeftAlone) {
  write("open-elsewhere-999999999.permalink", "scene=cgfs/shadows");
  {
    const auto running = FileLock::try_lock(folder_ / "open-elsewhere-999999999.lock");
    EXPECT_TRUE(Autosave(folder_).take_left_behind().empty());
    EXPECT_TRUE(std::filesystem::exists(folder_ / "open-elsewhere-999999999.permalink"));
  }
  EXPECT_EQ(only_text(Autosave(folder_).take_left_behind()), "scene=cgfs/shadows");
}

TEST_F(SessionFiles, OfTwoSessionsTheNewestComesFirstAndBothStayOnDisk) {
  leave_behind(folder_, "scene=cgfs/lens");
  leave_behind(folder_, "scene=cgfs/shadows");
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    std::ifstream file(entry.path());
    std::string text;
    std::getline(file, text);
    if (text == "scene=cgfs/shadows")
      std::filesystem::last_write_time(entry.path(), std::filesystem::last_write_time(entry.path()) - 1h);
  }
  Autosave autosave(folder_);
  const auto found = autosave.take_left_behind();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].text, "scene=cgfs/lens");
  EXPECT_EQ(found[1].text, "scene=cgfs/shadows");
  EXPECT_TRUE(std::filesystem::exists(found[0].file));
  autosave.restore(found[0]);
  EXPECT_TRUE(std::filesystem::exists(found[0].file)) << "until it is saved as the own one";
  autosave.save("scene=cgfs/lens");
  EXPECT_FALSE(std::filesystem::exists(found[0].file));
  EXPECT_TRUE(std::filesystem::exists(found[1].file));
}

/// What a program finds that restores what is left behind and ends without a proper end, `outlived` or not.
std::vector<LeftBehind> restored_and_ended(const std::filesystem::path& folder, bool outlived) {
  Autosave autosave(folder);
  std::vector<LeftBehind> found = autosave.take_left_behind();
  if (found.size() == 1) autosave.restore(found[0]);
  autosave.save("scene=cgfs/lens");
  if (outlived) autosave.outlived_start();
  autosave.save("scene=cgfs/lens&pixel=1,2");
  autosave.keep();
  return found;
}

// A screen that ends the program whenever it is drawn must not end every start.
TEST_F(SessionFiles, ARestoredSessionThatEndsAtOnceIsKnown) {
  leave_behind(folder_, "scene=cgfs/lens");
  EXPECT_FALSE(restored_and_ended(folder_, false).at(0).ended_at_once) << "was not restored before";
  EXPECT_TRUE(restored_and_ended(folder_, true).at(0).ended_at_once);
  EXPECT_FALSE(restored_and_ended(folder_, false).at(0).ended_at_once) << "the one before it had outlived its start";
  const auto last = Autosave(folder_).take_left_behind();
  ASSERT_EQ(last.size(), 1u);
  EXPECT_TRUE(last[0].ended_at_once);
  EXPECT_EQ(last[0].text, "scene=cgfs/lens&pixel=1,2");
  EXPECT_TRUE(std::filesystem::exists(last[0].file)) << "put aside, not removed";
}

TEST_F(SessionFiles, DamagedAutosavesAreKeptAndNamed) {
  write("open-999999999.permalink", "");
  std::filesystem::create_directories(folder_ / "open-999999998.permalink");
  write("open-999999997.permalink", std::string(3 << 20, 'x'));
  Autosave autosave(folder_);
  const auto found = autosave.take_left_behind();
  ASSERT_EQ(found.size(), 3u);
  for (const LeftBehind& session : found) {
    EXPECT_NE(session.problem, "");
    EXPECT_TRUE(std::filesystem::exists(session.file)) << session.file;
  }
}

TEST_F(SessionFiles, AutosaveIntoAFolderThatCannotBeMadeIsSilent) {
  write("file", "");
  Autosave autosave(folder_ / "file" / "below");
  autosave.save("scene=cgfs/shadows");
  EXPECT_TRUE(autosave.take_left_behind().empty());
}

}  // namespace
}  // namespace ps::gui::session_files_test
