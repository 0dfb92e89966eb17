#include "bench/report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
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
  row.size = job.size;
  row.milliseconds = timing.ours.median;
  return row;
}

void print_header(const Machine& machine, const MeasureOptions& options, const std::string& time) {
  fmt::print("Pixelscope {}, {}, SIMD {}, {} threads; {}, medians of up to {} runs, quartiles in brackets; "
             "ratio above 1 = ours is faster\n",
             machine.version, machine.processor, machine.simd, machine.threads, time, options.repeats);
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

namespace {

/// Between one point of a curve and the next, the power of what grows that the time follows: 1 = linear.
void print_curves(const std::vector<Row>& rows) {
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const auto curve_of = [](const Row& row) { return row.size > 0 ? row.name.substr(0, row.name.rfind('/')) : ""; };
    const std::string curve = curve_of(rows[i]);
    if (curve.empty() || (i > 0 && curve_of(rows[i - 1]) == curve)) continue;
    fmt::print("{}: from point to point the time grows with the power", curve);
    for (std::size_t k = i; k + 1 < rows.size() && curve_of(rows[k + 1]) == curve; ++k)
      fmt::print(" {:.2f}",
                 std::log(rows[k + 1].milliseconds / rows[k].milliseconds) / std::log(rows[k + 1].size / rows[k].size));
    fmt::print("\n");
  }
}

}  // namespace

void print_summary(const std::vector<Row>& rows) {
  std::map<std::string, std::vector<double>> ratios;
  for (const Row& row : rows)
    if (row.ratio > 0) ratios[row.yardstick_name].push_back(row.ratio);
  for (const auto& [yardstick, all] : ratios)
    fmt::print("{}: geometric mean of {} ratios {:.2f}, smallest {:.2f}\n", yardstick, all.size(), geometric_mean(all),
               *std::min_element(all.begin(), all.end()));
  print_curves(rows);
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
  write_file_atomically(path, out.dump(1) + "\n");
}

}  // namespace ps::bench
