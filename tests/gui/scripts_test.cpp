// Every script of tests/gui/scripts in the real window, at the sizes of a small and of a common screen. A line
// "# arguments: ..." gives arguments for the program, "# renderer: KEY" skips the script in builds without that
// renderer. A line "# size: WxH" is for scripts that wait for measurements, or are about other things than the
// arrangement of the window: they are played at this size alone. OUT/ stands for a folder for screenshots; none may be
// blank.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>

#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"
#include "support/option_contexts.h"

namespace scripts_test {
namespace {

using Case = std::tuple<std::string, std::string>;  // script, size

std::vector<std::string> scripts() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator("tests/gui/scripts"))
    if (entry.path().extension() == ".script") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// A window that was not drawn, or lost its text, has few colours.
void expect_drawn(const std::filesystem::path& path) {
  constexpr std::size_t few_colours = 40;
  const auto picture = ps::load_levels(path);
  std::set<int> colours;
  std::array<std::size_t, 4> quarters{};
  const ps::Rgb8 first = picture.at(0, 0);
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const ps::Rgb8 p = picture.at(x, y);
      if (colours.size() <= few_colours) colours.insert(p.r << 16 | p.g << 8 | p.b);
      const int row = y * 2 / picture.height(), column = x * 2 / picture.width();
      if (!(p == first)) ++quarters[2 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
    }
  EXPECT_GT(colours.size(), few_colours) << path;
  EXPECT_GT(*std::max_element(quarters.begin(), quarters.end()), 100u) << path;
}

std::string text_of(const std::string& script) {
  return ps::test::read_file("tests/gui/scripts/" + script + ".script");
}

/// What stands behind "# NAME: " in a line of its own; empty where there is no such line.
std::string note_of(const std::string& text, const std::string& name) {
  const std::string mark = "\n# " + name + ": ", lines = "\n" + text;
  const auto at = lines.find(mark);
  if (at == std::string::npos) return {};
  const auto begin = at + mark.size();
  return lines.substr(begin, lines.find('\n', begin) - begin);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::string& script : scripts()) {
    const std::string only = note_of(text_of(script), "size");
    for (const std::string size : {"1366x768", "1920x1080"})
      if (only.empty() || only == size) all.emplace_back(script, size);
  }
  return all;
}

class Script : public testing::TestWithParam<Case> {};

TEST_P(Script, Plays) {
  const auto& [name, size] = GetParam();
  const auto folder = ps::fresh_output_folder("gui-" + name + "-" + size);
  std::string commands = text_of(name);
  ASSERT_FALSE(commands.empty());
  const std::string renderer = note_of(commands, "renderer");
  if (!renderer.empty() && !ps::test::has_renderer(renderer)) GTEST_SKIP() << "this build has no renderer " << renderer;
  const std::string arguments = note_of(commands, "arguments");
  // Absolute, since the window begins in the folder of the last file.
  replace_all(commands, "OUT/", std::filesystem::absolute(folder).string() + "/");
  const auto result = ps::test::play(commands, folder, size, arguments);
  EXPECT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_EQ(result.errors, "");
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".png") expect_drawn(entry.path());
}

std::string test_name(const testing::TestParamInfo<Case>& info) {
  std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Window, Script, testing::ValuesIn(cases()), test_name);

}  // namespace
}  // namespace scripts_test
