#pragma once
#include <filesystem>
#include <string>

#include "study/chart.h"

namespace ps {

/// The measured points as a table with a heading: label, renderer, settings, time_ms, time_q1_ms, time_q3_ms, error,
/// memory_mb, on_front, work, machinery, truth, the provenance: program, processor, simd, threads, base_settings,
/// tie, upload_ms (ChartPoint::upload_ms, empty where there is none), standing ("compared", "truth" or "other-picture")
/// and left_out. The error of the truth itself is empty.
std::string chart_csv(const Chart& chart);
/// Everything: the sentence ("conclusion"), identity, machine, the reference's noise, all metrics and samples of each
/// point.
std::string chart_json(const Chart& chart);
/// A picture of the chart, 1000 x 700, with the sentence that it supports.
std::string chart_svg(const Chart& chart);

/// Writes points.csv, points.json and chart.svg into a folder that exists.
void write_chart(const std::filesystem::path& folder, const Chart& chart);

}  // namespace ps
