#include "study/chart_log.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/check.h"
#include "image/file.h"
#include "options/option.h"
#include "render/provenance.h"
#include "study/comparison_json.h"
#include "study/counted_work.h"

namespace ps {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* log_name = "runs.jsonl";

Json identity_json(const ChartIdentity& id) {
  return {{"scene", id.scene},   {"size", {id.width, id.height}}, {"values", id.values},
          {"region", id.region}, {"reference", id.reference},     {"base", id.base},
          {"points", id.points}, {"machinery", id.machinery},     {"fingerprint", id.fingerprint}};
}

ChartIdentity identity_from(const Json& json) {
  return {json.at("scene"),  json.at("size").at(0),        json.at("size").at(1), json.at("values"),
          json.at("region"), json.at("reference"),         json.at("base"),       json.value("machinery", ""),
          json.at("points"), json.value("fingerprint", "")};
}

Json head_json(const Chart& chart) {
  Json json{{"chart", identity_json(chart.identity)},
            {"machine",
             {{"version", chart.machine.version},
              {"processor", chart.machine.processor},
              {"simd", chart.machine.simd},
              {"threads", chart.machine.threads}}}};
  if (chart.reference_halves) json["reference-halves"] = comparison_json(*chart.reference_halves);
  return json;
}

void read_head(const Json& json, Chart& chart) {
  chart.identity = identity_from(json.at("chart"));
  const Json& machine = json.at("machine");
  chart.machine = {machine.at("version"), machine.at("processor"), machine.at("simd"), machine.at("threads")};
  if (json.contains("reference-halves")) chart.reference_halves = comparison_from_json(json.at("reference-halves"));
}

Json picture_json(const ChartPoint& point) {
  Json json{{"picture", point.number},         {"label", point.what.label},
            {"settings", point.what.settings}, {"comparison", comparison_json(point.comparison)},
            {"memory_mb", point.memory_mb},    {"prepare_ms", point.prepare_ms}};
  std::vector<std::string> all;
  for (const Option& option : option_table())
    if (option.get(point.what.value) != option.default_value())
      all.push_back(fmt::format("{}={}", option.key, option_text(option, point.what.value)));
  json["all-settings"] = all;
  for (std::size_t i = 0; i < counter_count; ++i)
    if (point.counters.values[i] > 0)
      json["counters"][std::string(counter_key(static_cast<Counter>(i)))] = point.counters.values[i];
  return json;
}

void read_picture(const Json& json, const std::filesystem::path& folder, ChartPoint& point) {
  point.number = json.at("picture");
  point.what.label = json.at("label");
  point.what.settings = json.at("settings");
  point.what.value = Settings{};
  for (const std::string assignment : json.at("all-settings")) parse_assignment(assignment, point.what.value);
  point.comparison = comparison_from_json(json.at("comparison"));
  point.memory_mb = json.at("memory_mb");
  point.prepare_ms = json.at("prepare_ms");
  for (std::size_t i = 0; i < counter_count; ++i) {
    const std::string key(counter_key(static_cast<Counter>(i)));
    if (json.contains("counters") && json.at("counters").contains(key))
      point.counters.values[i] = json.at("counters").at(key);
  }
  point.work = counted_work(point.counters);
  point.picture = load_levels(folder / picture_name(point));
}

/// All whole lines; the last one may have been cut off.
std::vector<Json> read_lines(const std::filesystem::path& path) {
  std::vector<Json> lines;
  std::istringstream text(read_whole_file(path));
  for (std::string line; std::getline(text, line);) {
    Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded() || !json.is_object()) break;
    lines.push_back(std::move(json));
  }
  return lines;
}

ChartPoint* find_point(Chart& chart, int number) {
  const auto found =
      std::find_if(chart.points.begin(), chart.points.end(), [&](const ChartPoint& p) { return p.number == number; });
  return found == chart.points.end() ? nullptr : &*found;
}

[[noreturn]] void refuse_other_chart(const std::filesystem::path& folder) {
  throw InputError(folder.string() + ": holds another chart; choose another folder or empty this one");
}

/// Puts pictures and samples into the points of `chart` that are there; with `add`, adds those that are not. What is
/// there must be of the same settings.
enum class Missing { ignore, add };
void apply(const std::vector<Json>& lines, const std::filesystem::path& folder, Chart& chart, Missing missing) {
  for (const Json& line : lines) {
    if (line.contains("picture")) {
      ChartPoint* point = find_point(chart, line.at("picture"));
      if (point && line.at("settings") != point->what.settings) refuse_other_chart(folder);
      if (!point && missing == Missing::add) point = &chart.points.emplace_back();
      if (point) read_picture(line, folder, *point);
    } else if (line.contains("sample")) {
      if (ChartPoint* point = find_point(chart, line.at("sample"))) point->samples_ms.push_back(line.at("time_ms"));
    }
  }
}

}  // namespace

std::string picture_name(const ChartPoint& point) { return fmt::format("picture-{}.png", point.number); }

ChartLog::ChartLog(const std::filesystem::path& folder, Chart& chart, const Image<Rgb8>& reference) : folder_(folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) throw InputError(folder.string() + ": cannot be made a folder");
  const auto path = folder / log_name;
  std::string kept = head_json(chart).dump() + "\n";
  if (std::filesystem::exists(path)) {
    const std::vector<Json> lines = read_lines(path);
    if (!lines.empty() && lines.front().contains("chart")) {
      try {
        Chart there;
        read_head(lines.front(), there);
        if (!(there.identity == chart.identity)) refuse_other_chart(folder);
        apply(lines, folder, chart, Missing::ignore);
      } catch (const nlohmann::json::exception& e) {
        throw InputError(path.string() + ": damaged: " + e.what());
      }
      for (std::size_t i = 1; i < lines.size(); ++i) kept += lines[i].dump() + "\n";
    }
  }
  write_file_atomically(path, kept);  // without a last line that was cut off
  Provenance made = provenance_of(chart.machine, chart.identity.base);
  made.more = {{"reference", chart.identity.reference}};
  save_image(folder / "reference.png", reference, {image_texts(made)});
  file_.open(path, std::ios::app);
  if (!file_) throw InputError(path.string() + ": cannot be written");
}

void ChartLog::add_picture(const ChartPoint& point) {
  save_image(folder_ / picture_name(point), *point.picture, {image_texts(provenance_of(point.what.value))});
  write(picture_json(point).dump());
}

void ChartLog::add_sample(const ChartPoint& point, double milliseconds) {
  write(Json{{"sample", point.number}, {"time_ms", milliseconds}}.dump());
}

void ChartLog::write(const std::string& line) {
  file_ << line << '\n' << std::flush;
  if (!file_) throw InputError((folder_ / log_name).string() + ": cannot be written");
}

Chart read_chart_log(const std::filesystem::path& folder) {
  const auto path = folder / log_name;
  const std::vector<Json> lines = read_lines(path);
  if (lines.empty() || !lines.front().contains("chart"))
    throw InputError(path.string() + ": found no chart, expected what 'chart --out' wrote");
  Chart chart;
  try {
    read_head(lines.front(), chart);
    apply(lines, folder, chart, Missing::add);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(path.string() + ": damaged: " + error.what());
  }
  return chart;
}

}  // namespace ps
