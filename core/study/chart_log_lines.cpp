#include "study/chart_log_lines.h"

#include <limits>

#include <fmt/format.h>

#include "base/check.h"
#include "base/enumerators.h"
#include "options/option.h"
#include "study/comparison_json.h"
#include "study/counted_work.h"
#include "study/json_log.h"

namespace ps {
namespace {

using ChartJson = nlohmann::ordered_json;

constexpr int most_chart_points = 1000000, largest_chart_side = 1000000;
constexpr double largest_chart_memory_mb = 1e9;

ChartJson identity_json(const ChartIdentity& id) {
  return {{"scene", id.scene},   {"size", {id.width, id.height}}, {"values", id.values},
          {"region", id.region}, {"reference", id.reference},     {"base", id.base},
          {"points", id.points}, {"machinery", id.machinery},     {"fingerprint", id.fingerprint}};
}

ChartIdentity identity_from(const ChartJson& json) {
  const ChartJson size{{"width", json.at("size").at(0)}, {"height", json.at("size").at(1)}};
  ChartIdentity id;
  id.scene = json.at("scene");
  id.width = json_integer(size, "width", 1, largest_chart_side);
  id.height = json_integer(size, "height", 1, largest_chart_side);
  id.values = json.at("values");
  id.region = json.at("region");
  id.reference = json.at("reference");
  id.base = json.at("base");
  id.machinery = json.value("machinery", "");
  id.points = json_integer(json, "points", 0, most_chart_points);
  id.fingerprint = json.value("fingerprint", "");
  return id;
}

Counters counters_from(const ChartJson& json) {
  Counters counters;
  counters.given = {};
  for (std::size_t i = 0; i < counter_count; ++i) {
    const std::string key(counter_key(static_cast<Counter>(i)));
    if (!json.contains(key)) continue;
    if (!json.at(key).is_number_unsigned())
      throw InputError(fmt::format("found {} = {}, expected a count", key, json.at(key).type_name()));
    counters.values[i] = json.at(key);
    counters.given.insert(static_cast<Counter>(i));
  }
  return counters;
}

}  // namespace

ChartJson chart_head_json(const Chart& chart) {
  ChartJson json{{"chart", identity_json(chart.identity)},
                 {"machine",
                  {{"version", chart.machine.version},
                   {"processor", chart.machine.processor},
                   {"simd", chart.machine.simd},
                   {"threads", chart.machine.threads}}}};
  if (!chart.absent.empty()) json["absent"] = chart.absent;
  if (chart.reference_halves) json["reference-halves"] = comparison_json(*chart.reference_halves);
  return json;
}

void read_chart_head(const ChartJson& json, Chart& chart) {
  chart.identity = identity_from(json.at("chart"));
  const ChartJson& machine = json.at("machine");
  chart.machine = {machine.at("version"), machine.at("processor"), machine.at("simd"),
                   json_integer(machine, "threads", 0, std::numeric_limits<int>::max())};
  if (json.contains("absent")) chart.absent = json.at("absent").get<std::vector<std::string>>();
  if (json.contains("reference-halves")) chart.reference_halves = comparison_from_json(json.at("reference-halves"));
}

ChartJson chart_picture_json(const ChartPoint& point) {
  ChartJson json{{"picture", point.number},         {"label", point.what.label},
                 {"settings", point.what.settings}, {"comparison", comparison_json(point.comparison)},
                 {"memory_mb", point.memory_mb},    {"prepare_ms", point.prepare_ms}};
  json["name"] = point.what.name;
  if (point.standing != Standing::compared) json["standing"] = enumerator_key(point.standing);
  for (const LeftOutBrief& left : point.left_out)
    json["left-out"].push_back({{"verb", enumerator_key(left.verb)}, {"words", left.words}});
  json["all-settings"] = changed_options(point.what.value);
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);  // missing: the renderer cannot give it
    if (const auto count = point.counters.get(counter)) json["counters"][std::string(counter_key(counter))] = *count;
  }
  return json;
}

ChartPoint chart_picture_from(const ChartJson& json, int points) {
  ChartPoint point;
  point.number = json_integer(json, "picture", 0, points - 1);
  point.what.label = json.at("label");
  point.what.name = json.value("name", point.what.label);
  point.what.settings = json.at("settings");
  if (json.contains("standing"))
    point.standing = parse_enumerator<Standing>("standing", json.at("standing").get<std::string>());
  for (const ChartJson& left : json.value("left-out", ChartJson::array()))
    point.left_out.push_back(
        left.is_string()  // logs before the verb stood apart have the whole text
            ? LeftOutBrief{BriefVerb::own, left}
            : LeftOutBrief{parse_enumerator<BriefVerb>("verb", left.at("verb").get<std::string>()), left.at("words")});
  for (const std::string assignment : json.at("all-settings")) parse_assignment(assignment, point.what.value);
  point.comparison = comparison_from_json(json.at("comparison"));
  point.memory_mb = json_number(json, "memory_mb", 0, largest_chart_memory_mb);
  point.prepare_ms = json_number(json, "prepare_ms", 0, longest_sample_ms);
  point.counters = counters_from(json.value("counters", ChartJson::object()));
  point.work = counted_work(point.counters);
  point.compared = true;
  return point;
}

ChartJson chart_sample_json(const ChartPoint& point, double milliseconds) {
  ChartJson json{{"sample", point.number}, {"time_ms", milliseconds}};
  if (!point.uploads_ms.empty()) json["upload_ms"] = point.uploads_ms.back();
  return json;
}

ChartSample chart_sample_from(const ChartJson& json, int points) {
  ChartSample sample{
      json_integer(json, "sample", 0, points - 1), json_number(json, "time_ms", 0, longest_sample_ms), {}};
  if (json.contains("upload_ms")) sample.upload_ms = json_number(json, "upload_ms", 0, longest_sample_ms);
  return sample;
}

}  // namespace ps
