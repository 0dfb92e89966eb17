#include "study/stability_log.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/machine.h"

namespace ps {
namespace {

using StabilityJson = nlohmann::ordered_json;

std::filesystem::path stability_log_path(const StabilityRequest& request) { return request.folder / "runs.jsonl"; }

/// Results with another head do not mix.
StabilityJson stability_head(const StabilityRequest& request) {
  const Machine machine = this_machine();
  return {{"stability", {{"seed", request.seed}, {"effort", request.effort}}},
          {"machine", {{"version", machine.version}, {"processor", machine.processor}, {"simd", machine.simd}}}};
}

/// JSON has no word for what is not a finite number.
StabilityJson number_or_word(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}
double number_from(const StabilityJson& json) {
  return json.is_string() ? std::stod(json.get<std::string>()) : json.get<double>();
}

StabilityJson row_json(const std::string& experiment, const StabilityRow& row) {
  return {{"experiment", experiment},           {"knob", number_or_word(row.knob)},     {"series", row.series},
          {"naive", number_or_word(row.naive)}, {"robust", number_or_word(row.robust)}, {"unit", row.unit}};
}

void apply_line(const StabilityJson& line, std::vector<MeasuredExperiment>& all) {
  const std::string key = line.at("experiment");
  auto found = std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.key == key; });
  if (line.contains("begin")) {
    if (found == all.end()) found = all.insert(all.end(), MeasuredExperiment{});
    *found = {key, {}, 0, false};
  } else if (found != all.end() && line.contains("seconds")) {
    found->seconds = line.at("seconds");
    found->complete = true;
  } else if (found != all.end()) {
    found->rows.push_back({number_from(line.at("knob")), line.at("series"), number_from(line.at("naive")),
                           number_from(line.at("robust")), line.at("unit")});
  }
}

}  // namespace

std::vector<MeasuredExperiment> read_stability(const StabilityRequest& request) {
  std::vector<MeasuredExperiment> all;
  const auto path = stability_log_path(request);
  std::error_code error;
  if (request.folder.empty() || !std::filesystem::exists(path, error)) return all;
  std::istringstream text(read_whole_file(path));
  bool head = true;
  for (std::string line; std::getline(text, line);) {
    const StabilityJson json = StabilityJson::parse(line, nullptr, false);
    if (!json.is_object()) break;
    if (head && json != stability_head(request)) break;
    try {
      if (!head) apply_line(json, all);
    } catch (const std::exception&) {
      break;  // damaged: what stands before it is good
    }
    head = false;
  }
  return all;
}

StabilityLog::StabilityLog(const StabilityRequest& request) : path_(stability_log_path(request)) {
  std::error_code error;
  std::filesystem::create_directories(request.folder, error);
  if (!std::filesystem::is_directory(request.folder))
    throw InputError(request.folder.string() + ": cannot be made a folder");
  const std::vector<MeasuredExperiment> kept = read_stability(request);
  write_file_atomically(path_, stability_head(request).dump() + "\n");  // without what is damaged or was done twice
  file_.open(path_, std::ios::app);
  for (const MeasuredExperiment& experiment : kept) {
    begin(experiment.key);
    for (const StabilityRow& row : experiment.rows) add(experiment.key, row);
    if (experiment.complete) complete(experiment);
  }
}

void StabilityLog::begin(const std::string& experiment) {
  write(StabilityJson{{"experiment", experiment}, {"begin", true}}.dump());
}

void StabilityLog::add(const std::string& experiment, const StabilityRow& row) {
  write(row_json(experiment, row).dump());
}

void StabilityLog::complete(const MeasuredExperiment& experiment) {
  write(StabilityJson{{"experiment", experiment.key}, {"seconds", experiment.seconds}}.dump());
}

void StabilityLog::write(const std::string& line) {
  file_ << line << '\n' << std::flush;
  if (!file_) throw InputError(path_.string() + ": cannot be written");
}

}  // namespace ps
