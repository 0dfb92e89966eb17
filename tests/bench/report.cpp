#include "bench/report.h"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/check.h"

namespace ps::bench {

Row make_row(const Bench& bench, const Job& job, const Timing& timing) {
  Row row{.name = bench.name, .unit = bench.unit, .yardstick_name = bench.yardstick_name, .note = job.note};
  // For rates the lower quartile of the time is the upper one of the rate.
  const auto value = [&](double milliseconds) {
    return job.amount > 0 ? 1e3 * job.amount / milliseconds : milliseconds;
  };
  row.ours = value(timing.ours.median);
  row.ours_q1 = std::min(value(timing.ours.q1), value(timing.ours.q3));
  row.ours_q3 = std::max(value(timing.ours.q1), value(timing.ours.q3));
  if (job.yardstick) {
    row.yardstick = value(timing.yardstick.median);
    row.yardstick_q1 = std::min(value(timing.yardstick.q1), value(timing.yardstick.q3));
    row.yardstick_q3 = std::max(value(timing.yardstick.q1), value(timing.yardstick.q3));
    row.ratio = timing.yardstick.median / timing.ours.median;
  }
  return row;
}

void print_header(const Machine& machine, const MeasureOptions& options) {
  fmt::print("Pixelscope {}, {}, SIMD {}, {} threads; medians of up to {} runs, quartiles in brackets; "
             "ratio above 1 = ours is faster\n",
             machine.version, machine.processor, machine.simd, machine.threads, options.repeats);
  fmt::print("{:<44} {:>7} {:>28} {:>28} {:>6}  {}\n", "name", "unit", "ours", "yardstick", "ratio", "");
}

void print_row(const Row& row) {
  const auto spread = [](double median, double q1, double q3) {
    return fmt::format("{:.4g} [{:.4g} {:.4g}]", median, q1, q3);
  };
  const bool compared = row.ratio > 0;
  fmt::print("{:<44} {:>7} {:>28} {:>28} {:>6}  {}{}{}\n", row.name, row.unit,
             spread(row.ours, row.ours_q1, row.ours_q3),
             compared ? spread(row.yardstick, row.yardstick_q1, row.yardstick_q3) : "",
             compared ? fmt::format("{:.2f}", row.ratio) : "", row.yardstick_name,
             row.note.empty() || row.yardstick_name.empty() ? "" : "; ", row.note);
  std::fflush(stdout);
}

void print_summary(const std::vector<Row>& rows) {
  std::map<std::string, std::vector<double>> ratios;
  for (const Row& row : rows)
    if (row.ratio > 0) ratios[row.yardstick_name].push_back(row.ratio);
  for (const auto& [yardstick, all] : ratios)
    fmt::print("{}: geometric mean of {} ratios {:.2f}, smallest {:.2f}\n", yardstick, all.size(), geometric_mean(all),
               *std::min_element(all.begin(), all.end()));
}

void write_json(const std::filesystem::path& path, const std::vector<Row>& rows, const Machine& machine) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json entry = {{"name", row.name}, {"unit", row.unit}, {"ours", row.ours}};
    const bool compared = row.ratio > 0;
    entry["yardstick"] = compared ? nlohmann::ordered_json(row.yardstick) : nlohmann::ordered_json();
    entry["yardstick_name"] = compared ? nlohmann::ordered_json(row.yardstick_name) : nlohmann::ordered_json();
    entry["ratio"] = compared ? nlohmann::ordered_json(row.ratio) : nlohmann::ordered_json();
    entry["ours_quartiles"] = {row.ours_q1, row.ours_q3};
    if (compared) entry["yardstick_quartiles"] = {row.yardstick_q1, row.yardstick_q3};
    entry["settings"] = row.note;
    entry["version"] = machine.version;
    entry["processor"] = machine.processor;
    entry["simd"] = machine.simd;
    entry["threads"] = machine.threads;
    out.push_back(std::move(entry));
  }
  std::ofstream file(path);
  file << out.dump(1) << '\n';
  file.close();
  if (!file) throw InputError(fmt::format("cannot write {}", path.string()));
}

}  // namespace ps::bench
