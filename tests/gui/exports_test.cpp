// Every kind of file that the window saves says what made it, in the way of its format.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/machine.h"
#include "gui/program.h"
#include "image/file.h"
#include "support/golden.h"

namespace exports_test {
namespace {

using Facts = std::map<std::string, std::string>;

const std::vector<std::string>& wanted() {
  static const std::vector<std::string> keys{"program", "processor", "simd", "threads", "settings"};
  return keys;
}

Facts facts_of_picture(const std::filesystem::path& path) {
  Facts facts;
  for (const ps::ImageText& text : ps::load_texts(path))
    facts[text.key == "Software" ? "program" : text.key] = text.value;
  return facts;
}

/// Of lines "BEFORE key MIDDLE value AFTER".
Facts facts_of_lines(const std::string& text, const std::string& before, const std::string& middle,
                     const std::string& after) {
  Facts facts;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    while (line.ends_with('\r')) line.pop_back();
    const auto at = line.find(middle, before.size());
    if (!line.starts_with(before) || !line.ends_with(after) || at == std::string::npos) continue;
    const auto begin = at + middle.size();
    if (line.size() < begin + after.size()) continue;
    facts.emplace(line.substr(before.size(), at - before.size()),
                  line.substr(begin, line.size() - begin - after.size()));
  }
  return facts;
}

Facts facts_of_json(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  const auto& made = json.contains("provenance") ? json["provenance"] : json;
  Facts facts;
  for (const std::string& key : wanted()) {
    const auto found = made.find(key == "settings" && !made.contains(key) ? "base-settings" : key);
    if (found != made.end()) facts[key] = found->is_string() ? found->get<std::string>() : found->dump();
  }
  return facts;
}

/// The fields of a line; none of those looked at holds a comma.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line)
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields.emplace_back();
    else if (c != '\r')
      fields.back() += c;
  return fields;
}

/// A chart's table has them in columns, the same in each row.
Facts facts_of_columns(const std::string& text) {
  std::istringstream lines(text);
  std::string heading, row;
  std::getline(lines, heading);
  std::getline(lines, row);
  const auto keys = fields_of(heading), values = fields_of(row);
  EXPECT_EQ(keys.size(), values.size());
  Facts facts;
  for (std::size_t i = 0; i < std::min(keys.size(), values.size()); ++i)
    if (keys[i] != "settings") facts[keys[i] == "base_settings" ? "settings" : keys[i]] = values[i];
  return facts;
}

Facts facts_of(const std::filesystem::path& path) {
  const std::string type = path.extension();
  if (type == ".png") return facts_of_picture(path);
  const std::string text = ps::test::read_file(path);
  if (type == ".svg") {
    EXPECT_NE(text.find("<metadata>"), std::string::npos);
    return facts_of_lines(text.substr(text.find("<metadata>")), "", ": ", "");
  }
  if (type == ".md") return facts_of_lines(text, "- ", ": `", "`");
  if (type == ".json") return facts_of_json(text);
  return text.starts_with("part,") ? facts_of_lines(text, "provenance,,,,", ",", "") : facts_of_columns(text);
}

/// The processor's name where this program does not read it: the first such line of the system's list.
std::string system_processor() {
  std::ifstream list("/proc/cpuinfo");
  for (std::string line; std::getline(list, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

/// The file of a folder that ends so.
std::filesystem::path only_file(const std::filesystem::path& folder, const std::string& ending) {
  std::filesystem::path found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename().string().ends_with(ending)) {
      EXPECT_TRUE(found.empty()) << found << " and " << entry.path();
      found = entry.path();
    }
  EXPECT_FALSE(found.empty()) << ending;
  return found;
}

std::string answer_with(const std::filesystem::path& file) {
  return "wait frames 3\ntype " + file.string() + "\nkey Enter\nwait idle\nexpect status/news contains Saved\n";
}

// A and B have different settings, so that a file with those of the other picture fails. A chart is measured by the
// whole machine; its points set their own options on top of those of A.
TEST(Exports, SayWhatMadeThem) {
  const auto out = std::filesystem::absolute(ps::fresh_output_folder("gui-exports"));
  const auto shots = out / "shots";
  std::filesystem::create_directories(shots);
  std::string script = "wait idle\nset threads=3\nset simd=sse4\nset gamma=1.5\nset-b threads=1\nset-b gamma=1.5\n"
                       "wait idle\nkey D\nwait idle\n";
  script += "key P\n" + answer_with(out / "saved.png");
  script += "key Shift+P\nwait idle\nkey Ctrl+P\nwait frames 8\nwait idle\nkey D\nclick-pixel A 20,30\nwait idle\n";
  for (const char* name : {"story.md", "story.csv", "story.json"})
    script += "click menu/scene\nclick save-story\n" + answer_with(out / name);
  for (const std::string tool : {"space", "microscope"})
    script += "click bottom/" + tool + "\nwait idle\nclick " + tool + "/svg\n" + answer_with(out / (tool + ".svg"));
  script += "click bottom/chart\nchoose chart/sweep samples\nclick chart/measure\nwait idle\n";
  for (const std::string type : {"csv", "json", "svg"})
    script += "click chart/export\nclick chart/" + type + "\n" + answer_with(out / ("chart." + type));
  std::ofstream(out / "play.script") << script << "quit\n";
  const auto result = ps::test::run_window(
      "cgfs/shadows --size 60x60 --window-size 1366x768 --script " + (out / "play.script").string(),
      "env XDG_STATE_HOME=" + (out / "state").string() + " XDG_PICTURES_DIR=" + shots.string());
  ASSERT_EQ(result.status, 0) << result.errors;

  const ps::Machine machine = ps::this_machine();
  const std::string program = "pixelscope " + machine.version, sse4 = machine.simd == "none" ? "none" : "SSE4",
                    settings = "threads=3;simd=sse4;gamma=1.5";
  const Facts of_a{{"program", program},
                   {"processor", system_processor()},
                   {"simd", sse4},
                   {"threads", "3"},
                   {"settings", settings}};
  Facts of_b = of_a, of_chart = of_a;
  of_b["simd"] = of_chart["simd"] = machine.simd;
  of_b["threads"] = "1";
  of_b["settings"] = "renderer=rasterizer;threads=1;gamma=1.5";
  of_chart["threads"] = std::to_string(machine.threads);
  std::map<std::filesystem::path, Facts> files{
      {only_file(shots, "-window.png"), of_a}, {only_file(shots, "-a.png"), of_a}, {only_file(shots, "-b.png"), of_b}};
  for (const char* name :
       {"saved-a.png", "saved-difference.png", "story.md", "story.csv", "story.json", "space.svg", "microscope.svg"})
    files[out / name] = of_a;
  files[out / "saved-b.png"] = of_b;
  for (const char* name : {"chart.csv", "chart.json", "chart.svg"}) files[out / name] = of_chart;
  EXPECT_EQ(files.size(), 14u);
  for (const auto& [path, expected] : files) {
    ASSERT_TRUE(std::filesystem::exists(path)) << path;
    Facts found = facts_of(path);
    for (const std::string& key : wanted()) EXPECT_EQ(found[key], expected.at(key)) << path << ", " << key;
  }
}

}  // namespace
}  // namespace exports_test
