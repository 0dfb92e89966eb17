// pixelscope-bench [FILTER] [--json FILE] [--list] [--repeats N] [--budget SECONDS] [--processor-time]

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <exception>

#include "added_renderers.h"
#include "base/check.h"
#include "bench/report.h"
#include "number_option.h"

namespace {

using namespace ps::bench;

bool chosen(const Bench& bench, const std::string& filter) {
  return bench.name.find(filter) != std::string::npos || bench.yardstick_name.find(filter) != std::string::npos;
}

/// Seconds that all threads together have worked. Says how much work there is, also beside other programs.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Whether all benches that match did the work they should.
bool run(const std::string& filter, const MeasureOptions& options, const ps::Clock& clock, std::vector<Row>& rows) {
  bool agreed = true;
  for (const Bench& bench : all_benches()) {
    if (!chosen(bench, filter)) continue;
    const Job job = bench.prepare();
    if (const std::string difference = job.check ? job.check() : ""; !difference.empty()) {
      fmt::print("{:<44} not timed, the two sides differ: {}\n", bench.name, difference);
      agreed = false;
      continue;
    }
    rows.push_back(make_row(bench, job, measure(job.ours, job.yardstick, options, clock)));
    print_row(rows.back());
  }
  return agreed;
}

}  // namespace

int main(int argc, char** argv) {
  ps::add_renderers();
  CLI::App app("Times Pixelscope beside other programs that do the same work.", "pixelscope-bench");
  std::string filter, json;
  bool list = false, processor_time = false;
  MeasureOptions options;
  app.add_option("filter", filter, "only benches whose name or yardstick contains this");
  app.add_option("--json", json, "write the results to this file");
  app.add_flag("--list", list, "print the names of the benches and end");
  app.add_option("--repeats", options.repeats, "runs of each side")->check(ps::whole_number_from(1, 1000));
  app.add_option("--budget", options.budget, "seconds for one bench")->check(ps::number_from(0, 3600));
  app.add_flag("--processor-time", processor_time, "measure the processor time of all threads instead of time");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    const Benches benches = all_benches();
    if (std::none_of(benches.begin(), benches.end(), [&](const Bench& bench) { return chosen(bench, filter); }))
      throw ps::InputError(fmt::format("no bench matches '{}'; --list names them", filter));
    if (list) {
      for (const Bench& bench : benches)
        if (chosen(bench, filter)) fmt::print("{:<44} {:>8}  {}\n", bench.name, bench.unit, bench.yardstick_name);
      return 0;
    }
    const ps::Machine machine = ps::this_machine();
    std::vector<Row> rows;
    print_header(machine, options, processor_time ? "processor time of all threads" : "time");
    const bool agreed = run(filter, options, processor_time ? processor_seconds : ps::steady_seconds, rows);
    print_summary(rows);
    if (!json.empty()) write_json(json, rows, machine);
    return agreed ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "pixelscope-bench: {}\n", error.what());
    return 2;
  }
}
