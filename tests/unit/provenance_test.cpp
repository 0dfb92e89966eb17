// Every file that the program writes says what made it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/atomic_file.h"
#include "base/machine.h"
#include "image/file.h"
#include "render/provenance.h"
#include "support/run_cli.h"

namespace ps::provenance_test {
namespace {

using nlohmann::json;
using test::run_cli;
using test::run_cli_well;
using test::ScratchFolder;

const std::vector<std::string>& traced_lens() {
  static const std::vector<std::string> arguments{"cgfs/lens", "--size",    "9x9",   "--set",    "gamma=1.5",
                                                  "--set",     "threads=3", "--set", "simd=sse4"};
  return arguments;
}

std::vector<std::string> lens_command(const std::string& name, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{name};
  arguments.insert(arguments.end(), traced_lens().begin(), traced_lens().end());
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Reads the processor's name where this program does not: the first such line of the system's list.
std::string system_processor() {
  std::ifstream list("/proc/cpuinfo");
  for (std::string line; std::getline(list, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

/// A text that names program, processor, settings and SIMD target. Their places and the number of threads are checked
/// format by format.
void expect_everything(const std::string& text, const std::string& where, const std::string& simd = "SSE4") {
  const Machine machine = this_machine();
  EXPECT_NE(text.find("pixelscope " + machine.version), std::string::npos) << where;
  EXPECT_NE(text.find(system_processor()), std::string::npos) << where;
  EXPECT_NE(text.find("gamma=1.5"), std::string::npos) << where;
  if (machine.simd != "none") {
    EXPECT_NE(text.find(simd), std::string::npos) << where;
  }
}

TEST(Provenance, OfSettings) {
  Settings settings;
  settings.threads = 5;
  settings.simd = Simd::off;
  const Provenance made = provenance_of(settings);
  EXPECT_EQ(made.simd, "none");
  EXPECT_EQ(made.threads, 5);
  EXPECT_EQ(made.settings, "threads=5;simd=off");
  EXPECT_EQ(made.processor, system_processor());
  settings = {};
  EXPECT_EQ(provenance_of(settings, Machinery::clear).simd, "none") << "scalar code drew it";
  EXPECT_EQ(provenance_of(settings, Machinery::whole_frame).simd, this_machine().simd);
}

TEST(Provenance, PicturesAndTheirStatistics) {
  const ScratchFolder folder;
  const std::string png = folder.file("a.png"), ppm = folder.file("a.ppm"), stats = folder.file("a.json");
  ASSERT_EQ(run_cli(lens_command("render", {"--out", png, "--stats", stats})).status, 0);
  std::map<std::string, std::string> texts;
  for (const ImageText& text : load_texts(png)) texts[text.key] = text.value;
  const json numbers = json::parse(read_whole_file(stats));
  EXPECT_EQ(texts["Software"], "pixelscope " + this_machine().version);
  EXPECT_EQ(texts["processor"], system_processor());
  EXPECT_EQ(texts["threads"], "3");
  EXPECT_EQ(numbers["simd"], texts["simd"]);
  EXPECT_EQ(texts["settings"], "threads=3;simd=sse4;gamma=1.5");
  EXPECT_EQ(numbers["machinery"]["path"], texts["machinery"]);
  EXPECT_EQ(texts["scene"], "cgfs/lens");
  EXPECT_EQ(numbers["permalink"], texts["permalink"]);
  EXPECT_EQ(numbers["processor"], system_processor());
  ASSERT_EQ(run_cli(lens_command("render", {"--out", ppm})).status, 0);
  for (const auto& [key, value] : texts)
    EXPECT_NE(read_whole_file(ppm).find("# " + key + ": " + value + "\n"), std::string::npos) << key;
  const std::string other = folder.file("b.png");
  for (const auto& arguments :
       {lens_command("precision", {"--out", other}), std::vector<std::string>{"compare", png, ppm, "--diff", other},
        std::vector<std::string>{"stability", "reflection-self-hit", "--strip", other}}) {
    ASSERT_EQ(run_cli(arguments).status, 0) << arguments.front();
    const auto found = load_texts(other);
    EXPECT_TRUE(std::count(found.begin(), found.end(), ImageText{"processor", system_processor()}))
        << arguments.front();
  }
}

TEST(Provenance, StoriesAndDrawings) {
  for (const std::vector<std::string>& form : std::vector<std::vector<std::string>>{
           {"--json"}, {"--csv"}, {"--markdown"}, {"--svg", "space"}, {"--svg", "microscope"}}) {
    std::vector<std::string> more{"--pixel", "4,4"};
    more.insert(more.end(), form.begin(), form.end());
    const auto result = run_cli_well(lens_command("inspect", more));
    expect_everything(result.out, form.back());
    EXPECT_NE(result.out.find("scene=cgfs/lens"), std::string::npos) << "the permalink, " << form.back();
  }
  const auto table = run_cli(lens_command("inspect", {"--pixel", "4,4", "--csv"})).out;
  EXPECT_TRUE(table.starts_with("part,index,parent,kind,name,value\n"));
  const json story = json::parse(run_cli(lens_command("inspect", {"--pixel", "4,4", "--json"})).out);
  EXPECT_EQ(story["provenance"]["threads"], 3);
}

/// The lines of a table, without the quotation marks.
std::vector<std::string> csv_lines(const std::string& csv) {
  std::vector<std::string> lines;
  std::istringstream text(csv);
  for (std::string line; std::getline(text, line);) {
    std::erase(line, '"');
    lines.push_back(line);
  }
  return lines;
}

TEST(Provenance, StudiesKeepTheirColumnsFirst) {
  const ScratchFolder folder;
  const std::string chart = folder.file("chart");
  ASSERT_EQ(
      run_cli(lens_command("chart", {"--sweep", "samples-per-pixel=1,2", "--repeats", "1", "--out", chart})).status, 0);
  const auto rows = csv_lines(read_whole_file(chart + "/points.csv"));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0],
            "label,renderer,settings,time_ms,time_q1_ms,time_q3_ms,error,memory_mb,on_front,work,machinery,truth,"
            "program,processor,simd,threads,base_settings,tie,upload_ms,standing,left_out");
  const Machine machine = this_machine();
  const std::string made = "pixelscope " + machine.version + "," + system_processor() + "," + machine.simd + "," +
                           std::to_string(machine.threads) + ",threads=3;simd=sse4;gamma=1.5";
  for (const std::size_t i : {1u, 2u}) EXPECT_NE(rows[i].find(made + ","), std::string::npos) << rows[i];
  for (const char* file : {"/points.json", "/chart.svg", "/reference.png"})
    expect_everything(read_whole_file(chart + file), file, machine.simd);
  expect_everything(read_whole_file(chart + "/picture-0.png"), "the picture of a point names its own SIMD target");
  EXPECT_NE(read_whole_file(chart + "/chart.svg").find("<metadata>"), std::string::npos);

  const auto needs = run_cli(lens_command("needs", {"--repeats", "1", "--json"}));
  EXPECT_EQ(json::parse(needs.out)["base-settings"], "threads=3;simd=sse4;gamma=1.5");
  expect_everything(needs.out, "needs --json");

  ASSERT_EQ(run_cli({"stability", "epsilon-unit", "--effort", "0.01", "--out", folder.path().string()}).status, 0);
  const auto table = csv_lines(read_whole_file(folder.file("epsilon-unit.csv")));
  EXPECT_EQ(table[0],
            "knob,series,naive,robust,unit,program,processor,simd,threads,settings,quantity,quantity_unit,better,"
            "knob_title,knob_name");
  for (std::size_t i = 1; i < table.size(); ++i)
    EXPECT_NE(table[i].find(std::to_string(machine.threads) + ",seed=1;effort=0.01,"), std::string::npos) << table[i];
  for (const char* study : {"precision", "causes"}) {
    auto arguments = lens_command(study, {"--json"});
    if (arguments.front() == "causes") arguments.insert(arguments.end(), {"--set-b", "reflection-depth=0"});
    expect_everything(run_cli(arguments).out, study);
  }
}

TEST(Provenance, TableWithQuotationMarks) {
  const Provenance made{"p", "a \"b\", c", "none", 1, "x=1", {}};
  EXPECT_EQ(csv_with_provenance("k\n1\n2", made),
            "k,program,processor,simd,threads,settings\n1,p,\"a \"\"b\"\", c\",none,1,x=1\n"
            "2,p,\"a \"\"b\"\", c\",none,1,x=1\n");
  EXPECT_EQ(svg_with_provenance("<svg></svg>\n", {"<p>", "&", "none", 1, "", {}}),
            "<svg><metadata>\nprogram: &lt;p&gt;\nprocessor: &amp;\nsimd: none\nthreads: 1\nsettings: \n</metadata>\n"
            "</svg>\n");
}

}  // namespace
}  // namespace ps::provenance_test
