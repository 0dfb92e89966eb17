#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "gui/platform/state_file.h"
#include "gui/program.h"
#include "support/golden.h"

namespace ps::test {

inline constexpr const char* small_scene = "cgfs/spheres --size 64x64";

/// A folder in which the window remembers its state from one start to the next.
struct Home {
  explicit Home(const std::string& name)
      : folder(std::filesystem::absolute(fresh_output_folder("gui-placement-" + name))) {}
  std::string environment() const { return "env XDG_STATE_HOME=" + folder.string(); }
  std::filesystem::path file() const { return folder / "pixelscope" / "window.json"; }
  std::string remembered(const std::string& key) const { return gui::StateFile(file()).get(key); }
  void remember(const std::string& key, const std::string& value) const {
    gui::StateFile state(file());
    state.set(key, value);
    state.save();
  }
  void plays(const std::string& commands, const std::string& hand = {}) const {
    const auto result = play_by_hand("wait idle\n" + commands, hand, folder, small_scene, environment());
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    output = result.output;
  }
  std::filesystem::path folder;
  mutable std::string output;
};

/// Place and size of a window as the X server has them, appended to the file.
inline std::string geometry_into(const std::filesystem::path& file) {
  return "xdotool getwindowgeometry --shell $window | grep -E '^(X|Y|WIDTH|HEIGHT)=' | tr '\n' ' ' >>" + file.string() +
         "\n";
}

/// Shell commands for the same: waits until the window has that width, at most 20 s.
inline std::string wait_for_width(int width) {
  return "for i in $(seq 200); do xdotool getwindowgeometry --shell $window | grep -qx WIDTH=" + std::to_string(width) +
         " && break; sleep 0.1; done\n";
}

inline bool have_xdotool() { return std::system("command -v xdotool >/dev/null 2>&1") == 0; }

}  // namespace ps::test
