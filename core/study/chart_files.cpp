#include "study/chart_files.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "base/check.h"
#include "base/csv.h"
#include "base/enumerators.h"
#include "options/choice_key.h"
#include "render/provenance.h"
#include "study/chart_conclusion.h"
#include "study/comparison_json.h"
#include "study/counted_work.h"
#include "study/missing_points.h"

namespace ps {
namespace {

using Json = nlohmann::ordered_json;

std::string_view renderer_key(const Settings& settings) { return choice_key<&Settings::renderer>(settings.renderer); }

/// The shortest text that reads back exactly. Unlike exact_number_text(), which people read, it has "nan" and "inf", as
/// programs that read tables expect.
std::string shortest_text(double value) { return fmt::format("{}", value); }

Json point_json(const ChartPoint& point) {
  Json json{{"label", point.what.label},
            {"renderer", renderer_key(point.what.value)},
            {"settings", point.what.settings},
            {"time_ms", point.time_ms.median},
            {"time_q1_ms", point.time_ms.q1},
            {"time_q3_ms", point.time_ms.q3},
            {"samples_ms", point.samples_ms},
            {"prepare_ms", point.prepare_ms},
            {"memory_mb", point.memory_mb},
            {"on_front", point.on_front},
            {"name", point.what.name},
            {"tie", point.tie},
            {"standing", enumerator_key(point.standing)},
            {"left_out", brief_texts(point.left_out)}};
  if (point.upload_ms) {
    json["upload_ms"] = point.upload_ms->median;
    json["uploads_ms"] = point.uploads_ms;
  }
  json["work"] = point.work ? Json(*point.work) : Json();  // null: the renderer counts none
  if (std::isfinite(point.error) && point.standing != Standing::truth)
    json["error"] = point.error;
  else
    json["error"] = nullptr;
  json["comparison"] = comparison_json(point.comparison);
  for (std::size_t i = 0; i < counter_count; ++i) {
    const auto counter = static_cast<Counter>(i);  // missing: the renderer cannot give it
    if (const auto count = point.counters.get(counter)) json["counters"][std::string(counter_key(counter))] = *count;
  }
  return json;
}

Provenance chart_machine_provenance(const Chart& chart) { return provenance_of(chart.machine, chart.identity.base); }

}  // namespace

std::string chart_csv(const Chart& chart) {
  std::vector<const ChartPoint*> measured;
  for (const ChartPoint& point : chart.points)
    if (point.measured()) measured.push_back(&point);
  std::string text = csv_row({"label", "renderer", "settings", "time_ms", "time_q1_ms", "time_q3_ms", "error",
                              "memory_mb", "on_front", "work", "machinery", "truth"});
  for (const ChartPoint* point : measured)
    text += csv_row({point->what.label, std::string(renderer_key(point->what.value)), point->what.settings,
                     shortest_text(point->time_ms.median), shortest_text(point->time_ms.q1),
                     shortest_text(point->time_ms.q3),
                     point->standing == Standing::truth ? "" : shortest_text(point->error),
                     shortest_text(point->memory_mb), point->on_front ? "1" : "0",
                     point->work ? work_text(point->work) : "", chart.identity.machinery, chart.identity.reference});
  return csv_with_columns(csv_with_provenance(text, chart_machine_provenance(chart), "base_settings"),
                          {"tie", "upload_ms", "standing", "left_out"}, [&](std::size_t i) {
                            PS_ASSERT(i < measured.size(), "each line of the table is a point");
                            const ChartPoint& point = *measured[i];
                            return std::vector<std::string>{
                                point.tie ? "1" : "0", point.upload_ms ? shortest_text(point.upload_ms->median) : "",
                                std::string(enumerator_key(point.standing)),
                                fmt::format("{}", fmt::join(brief_texts(point.left_out), "; "))};
                          });
}

std::string chart_json(const Chart& chart) {
  const ChartIdentity& id = chart.identity;
  const Provenance made = chart_machine_provenance(chart);
  Json json{{"program", made.program},
            {"processor", made.processor},
            {"simd", made.simd},
            {"threads", made.threads},
            {"scene", id.scene},
            {"size", {id.width, id.height}},
            {"base-settings", id.base},
            {"metric", error_metric(chart.metric).key},
            {"values", id.values},
            {"region", id.region},
            {"reference", id.reference},
            {"machinery", id.machinery},
            {"across", enumerator_key(chart.across)},
            {"conclusion", chart_conclusion(chart).sentence}};
  if (chart.reference_halves) json["reference-halves"] = comparison_json(*chart.reference_halves);
  json["points"] = Json::array();
  for (const ChartPoint& point : chart.points)
    if (point.measured()) json["points"].push_back(point_json(point));
  for (const MissingPoint& point : missing_points(chart))
    json["missing"].push_back({{"number", point.number}, {"label", point.label}, {"reason", point.reason}});
  if (!chart.absent.empty()) json["absent"] = chart.absent;
  if (!chart.damage.empty()) json["damaged"] = chart.damage;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_chart(const std::filesystem::path& folder, const Chart& chart) {
  write_file_atomically(folder / "points.csv", chart_csv(chart));
  write_file_atomically(folder / "points.json", chart_json(chart));
  write_file_atomically(folder / "chart.svg", chart_svg(chart));
}

}  // namespace ps
