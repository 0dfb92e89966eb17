// Files of the user that the window reads at its start, good and bad, and what is there after it was ended from
// outside.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "gui/input/bindings_file.h"
#include "gui/platform/state_file.h"
#include "gui/program.h"
#include "support/golden.h"

namespace ps::gui::window_state_test {
namespace {

using namespace std::chrono_literals;

std::filesystem::path state_folder(const std::string& name) {
  auto folder = std::filesystem::absolute(fresh_output_folder("gui-state-" + name));
  std::filesystem::create_directories(folder / "pixelscope");
  return folder;
}

void write(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }

/// Starts the window with this state folder, plays commands and ends it.
test::WindowRun start(const std::filesystem::path& state, const std::string& commands) {
  write(state / "play.script", "wait idle\n" + commands);
  return test::run_window("--script " + (state / "play.script").string() + " --window-size 1366x768",
                          "timeout 60 env XDG_STATE_HOME=" + state.string());
}

TEST(WindowState, WhatCannotBeReadIsIgnoredWithAWord) {
  const auto folder = state_folder("bad");
  const auto file = folder / "pixelscope" / "window.json";
  struct Bad {
    std::string content, complaint;
  };
  int kept = 0;
  for (const Bad& bad :
       {Bad{R"({"window/scale":"nan"})", "window/scale: found 'nan', expected a number from 0.75 to 4"},
        Bad{R"({"window/scale":"1e300"})", "window/scale: found '1e300'"},
        Bad{R"({"window/scale":2})", "window/scale: found number, expected text"},
        Bad{R"(["window/scale"])", "found array, expected an object"}, Bad{R"({"window/sc)", "found no JSON"},
        Bad{"", "found no JSON"},
        Bad{R"({"format":0,"window/scale":"2"})", "found format 0 of an older version, expected 1"},
        Bad{R"({"format":7,"window/scale":"2"})", "found format 7 of another version, expected 1"},
        Bad{R"({"format":"x","window/scale":"2"})", "found format \"x\" of another version, expected 1"},
        Bad{std::string(2 << 20, ' '), "bytes, expected at most"}}) {
    write(file, bad.content);
    StateFile state(file);
    EXPECT_EQ(state.number("window/scale", 0.75, 4), 0);
    ASSERT_EQ(state.complaints().size(), 1u) << bad.content.substr(0, 40);
    EXPECT_NE(state.complaints()[0].find(file.string()), std::string::npos);
    EXPECT_NE(state.complaints()[0].find(bad.complaint), std::string::npos) << state.complaints()[0];
    // Nothing is lost by what is written now.
    state.set("window/theme", "dark");
    state.save();
    EXPECT_EQ(StateFile(file).get("window/theme"), "dark");
    if (state.complaints()[0].find("kept as") == std::string::npos) continue;
    ++kept;
    const bool other_version = bad.content.starts_with(R"({"format")");
    EXPECT_EQ(test::read_file(file.string() + (other_version ? ".old" : ".damaged")), bad.content);
  }
  EXPECT_EQ(kept, 7) << "all but those with one bad value";
  EXPECT_EQ(StateFile(folder / "none.json").complaints().size(), 0u);
}

/// A complaint shows the beginning of a value, and one complaint stands for many of a kind.
TEST(WindowState, ComplaintsAreShortWhateverTheFileHolds) {
  const auto folder = state_folder("long");
  const auto file = folder / "pixelscope" / "window.json";
  std::string lines;
  for (int i = 0; i < 5000; ++i) lines += "a\\tb\\n";
  write(file, R"({"window/size":")" + lines + R"(","window/scale":")" + lines + R"("})");
  StateFile state(file);
  EXPECT_EQ(state.number("window/scale", 0.75, 4), 0);
  ASSERT_EQ(state.complaints().size(), 1u);
  EXPECT_LT(state.complaints()[0].size(), 400 + file.string().size());
  std::string numbers = "{\"" + std::string(2000, 'a') + "\":1";
  for (int i = 0; i < 300; ++i) numbers += ",\"k" + std::to_string(i) + "\":2";
  write(file, numbers + "}");
  const StateFile other(file);
  ASSERT_EQ(other.complaints().size(), 1u);
  EXPECT_NE(other.complaints()[0].find("and 300 more such"), std::string::npos) << other.complaints()[0];
  EXPECT_LT(other.complaints()[0].size(), 400 + file.string().size());
}

TEST(WindowState, WhatIsNoFileIsNeitherReadNorReplaced) {
  const auto folder = state_folder("no-file");
  std::filesystem::create_directories(folder / "folder");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const char* name : {"folder", "pipe"}) {
    StateFile state(folder / name);
    EXPECT_FALSE(state.remembers());
    EXPECT_EQ(state.complaints().size(), 1u);
    state.set("window/theme", "dark");
    state.save();
    EXPECT_FALSE(std::filesystem::is_regular_file(folder / name));
  }
}

TEST(WindowState, KeysThatCannotBeReadStayAsTheyAre) {
  const auto folder = state_folder("keys");
  Actions actions;
  actions.add({.name = "quit", .label = "Quit", .group = "Window", .keys = "Ctrl+Q", .run = [] {}});
  std::filesystem::create_directories(folder / "folder");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  write(folder / "huge", std::string(1 << 20, '#'));
  write(folder / "unknown", "quit = F4\nno-such = F5\n");
  for (const char* name : {"folder", "pipe", "huge", "unknown"}) {
    const std::string complaint = load_bindings(folder / name, actions);
    EXPECT_NE(complaint.find((folder / name).string()), std::string::npos) << complaint;
    EXPECT_EQ(actions.key_text("quit"), "Ctrl+Q");
  }
  EXPECT_EQ(load_bindings(folder / "none", actions), "");
  write(folder / "good", "quit = F4\n");
  EXPECT_EQ(load_bindings(folder / "good", actions), "");
  EXPECT_EQ(actions.key_text("quit"), "F4");
}

TEST(WindowState, TheWindowStartsAndSaysWhatItIgnores) {
  const auto folder = state_folder("starts");
  const auto file = folder / "pixelscope" / "window.json";
  write(file, R"({"window/scale":"nan","window/size":"big"})");
  auto result = start(folder, "expect messages 1\nexpect message contains window/scale\nexpect window/scale 1\n");
  EXPECT_EQ(result.status, 0) << result.errors;
  write(file, R"({"format":0,"window/scale":"2"})");
  result = start(folder, "expect messages 1\nexpect message contains \"an older version\"\nexpect window/scale 1\n");
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_TRUE(std::filesystem::exists(file.string() + ".old"));
  std::filesystem::remove(file);
  std::filesystem::create_directories(file);
  result = start(folder, "expect messages 1\nexpect message contains \"not a regular file\"\n");
  EXPECT_EQ(result.status, 0) << result.errors;
}

// The one that closes last adds what the other has opened.
TEST(WindowState, TwoWindowsKeepBothListsOfRecentFiles) {
  const auto file = state_folder("recent") / "pixelscope" / "window.json";
  StateFile before(file);
  before.set_lines("recent", "old\nolder\n");
  before.save();
  StateFile first(file), second(file);
  first.set_lines("recent", "one\nold\nolder\n");
  first.set("theme", "dark");
  second.set_lines("recent", "two\nold\nolder\n");
  second.set("scale", "2");
  first.save();
  second.save();
  const StateFile after(file);
  EXPECT_EQ(after.get("recent"), "two\none\nold\nolder\n");
  EXPECT_EQ(after.get("theme"), "dark");
  EXPECT_EQ(after.get("scale"), "2");
  const auto names = [&] {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
      all.push_back(entry.path().filename());
    std::sort(all.begin(), all.end());
    return all;
  }();
  EXPECT_EQ(names, (std::vector<std::string>{"window.json", "window.json.lock"})) << "no temporary file is left";
}

// Without a lock, one that reads before the other has written replaces what the other writes.
TEST(WindowState, WindowsThatCloseAtOnceLoseNothing) {
  constexpr int windows = 8, rounds = 4;
  const auto file = state_folder("at-once") / "pixelscope" / "window.json";
  for (int round = 0; round < rounds; ++round) {
    std::atomic<int> ready{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < windows; ++i)
      threads.emplace_back([&, i] {
        const std::string name = std::to_string(round) + "-" + std::to_string(i);
        StateFile state(file);
        state.set("key-" + name, name);
        state.set_lines("recent", name + "\n" + state.get("recent"));
        ++ready;
        while (ready < windows) std::this_thread::yield();
        state.save();
      });
    for (std::thread& thread : threads) thread.join();
  }
  const StateFile after(file);
  EXPECT_TRUE(after.complaints().empty());
  const std::string recent = "\n" + after.get("recent");
  for (int round = 0; round < rounds; ++round)
    for (int i = 0; i < windows; ++i) {
      const std::string name = std::to_string(round) + "-" + std::to_string(i);
      EXPECT_EQ(after.get("key-" + name), name);
      EXPECT_NE(recent.find("\n" + name + "\n"), std::string::npos) << name;
    }
}

/// Whether a file of the state folder with this beginning of its name holds the text by and by.
bool appears(const std::filesystem::path& folder, const std::string& beginning, const std::string& text) {
  for (int i = 0; i < 6000; ++i) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "pixelscope", error))
      if (entry.path().filename().string().starts_with(beginning) &&
          test::read_file(entry.path()).find(text) != std::string::npos)
        return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

/// Sends a signal to a window that plays the commands, once appears() finds the text. Gives its wait status.
int window_ended_by(int number, const std::filesystem::path& folder, const std::string& commands,
                    const std::string& beginning, const std::string& text) {
  write(folder / "wait.script", commands + "wait 600000\n");
  const std::string script = folder / "wait.script";
  const std::string variable = "XDG_STATE_HOME=" + folder.string();
  const pid_t window = fork();
  if (window < 0) {
    ADD_FAILURE() << "no process";
    return -1;
  }
  if (window == 0) {
    std::signal(SIGHUP, SIG_DFL);
    execlp("env", "env", variable.c_str(), PIXELSCOPE_BIN_DIR "/pixelscope", "--script", script.c_str(),
           "--window-size", "800x600", nullptr);
    _exit(127);
  }
  EXPECT_TRUE(appears(folder, beginning, text));
  kill(window, number);
  int status = 0;
  waitpid(window, &status, 0);
  return status;
}

// The first end may have any cause; the second one, right after the restoring, has the screen for its cause.
TEST(WindowState, AScreenThatEndsEachProgramIsRestoredOnce) {
  const auto folder = state_folder("crash-loop");
  window_ended_by(SIGKILL, folder, "wait idle\nset exposure=2\nwait idle\n", "open-", "exposure=2");
  const std::string shot = (folder / "pixelscope" / "shot.png").string();
  window_ended_by(SIGKILL, folder, "wait idle\nexpect a/option/exposure 2\nscreenshot " + shot + "\n", "shot", "PNG");
  const auto third = start(folder, "expect a/option/exposure 1\nexpect message contains \"ended right after\"\n");
  EXPECT_EQ(third.status, 0) << third.errors;
  EXPECT_TRUE(appears(folder, "left-behind-", "exposure=2")) << "put aside, not lost";
  const auto fourth = start(folder, "expect messages 0\n");
  EXPECT_EQ(fourth.status, 0) << fourth.errors;
}

TEST(WindowState, WhatWasOpenIsThereAfterALogout) {
  for (const int number : {SIGTERM, SIGHUP}) {
    const auto folder = state_folder("signal-" + std::to_string(number));
    const int status = window_ended_by(number, folder, "wait idle\nset exposure=2\nwait idle\n", "open-", "exposure=2");
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 128 + number) << status;
    EXPECT_TRUE(appears(folder, "open-", "exposure=2")) << "as after a crash";
    const auto next = start(folder, "expect a/option/exposure 2\nexpect message contains \"ended from outside\"\n");
    EXPECT_EQ(next.status, 0) << next.errors;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "pixelscope"))
      EXPECT_FALSE(entry.path().filename().string().starts_with("open-")) << entry.path();
  }
}

TEST(WindowState, ASecondSessionIsOfferedAndADamagedOneNamed) {
  const auto folder = state_folder("offered");
  const auto leave = [&](const std::string& number, const std::string& text, std::chrono::minutes age) {
    const auto path = folder / "pixelscope" / ("open-9999999" + number + ".permalink");
    write(path, text);
    std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() - age);
  };
  leave("91", "scene=cgfs/lens", 3min);
  leave("92", "scene=cgfs/shadows", 2min);
  leave("93", "nonsense", 1min);
  auto result = start(folder, "expect scene cgfs/shadows\nexpect messages 3\nexpect message contains left-behind-\n");
  EXPECT_EQ(result.status, 0) << result.errors;
  std::vector<std::string> kept;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "pixelscope"))
    if (entry.path().filename().string().starts_with("left-behind-")) kept.push_back(test::read_file(entry.path()));
  std::sort(kept.begin(), kept.end());
  EXPECT_EQ(kept, (std::vector<std::string>{"nonsense", "scene=cgfs/lens"}));
  // Offered under Recent, also by the next window.
  const StateFile state(folder / "pixelscope" / "window.json");
  const std::string recent = state.get("session/recent");
  const std::size_t from = recent.find(folder.string());
  ASSERT_NE(from, std::string::npos) << recent;
  const std::string file = recent.substr(from, recent.find('\n', from) - from);
  result = start(folder,
                 "click menu/scene\nclick menu/recent\nclick recent/" + file + "\nwait idle\nexpect scene cgfs/lens\n");
  EXPECT_EQ(result.status, 0) << result.errors;
}

}  // namespace
}  // namespace ps::gui::window_state_test
