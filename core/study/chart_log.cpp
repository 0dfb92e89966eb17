#include "study/chart_log.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/check.h"
#include "image/file.h"
#include "render/provenance.h"
#include "study/chart_log_lines.h"
#include "study/json_log.h"

namespace ps {
namespace {

constexpr const char* log_name = "runs.jsonl";

[[noreturn]] void refuse_other_chart(const std::filesystem::path& folder) {
  throw InputError(folder.string() + ": holds another chart; choose another folder or empty this one");
}

/// Identity, machine and halves from the first line. Without it the conditions of the other lines are unknown.
Chart read_head(const std::filesystem::path& path, const JsonLog& log) {
  const bool first_is_damaged =
      !log.damaged.empty() && (log.lines.empty() || log.damaged.front().number < log.lines.front().number);
  if (first_is_damaged) throw InputError(damage_text(path, log.damaged.front()));
  if (log.lines.empty() || !log.lines.front().json.contains("chart"))
    throw InputError(path.string() + ": found no chart, expected what 'chart --out' wrote");
  Chart chart;
  try {
    read_chart_head(log.lines.front().json, chart);
  } catch (const std::exception& error) {
    throw InputError(fmt::format("{}:{}: {}", path.string(), log.lines.front().number, error.what()));
  }
  return chart;
}

/// Whether points are added that the chart does not have, or those of other shards passed over.
enum class OtherPoints { add, pass_over };

/// Puts what the lines of a log hold into the points of a chart.
class LogReader {
 public:
  LogReader(const std::filesystem::path& folder, Chart& chart, OtherPoints others)
      : folder_(folder), chart_(chart), others_(others) {}

  /// Lines that cannot be taken go from `lines` to `damaged`.
  void take(JsonLog& log) {
    std::vector<JsonLogLine> good;
    for (JsonLogLine& line : log.lines) {
      try {
        take_line(line.json);
        good.push_back(std::move(line));
      } catch (const std::exception& error) {  // InputError and what nlohmann throws
        log.damaged.push_back({line.number, std::move(line.text), error.what()});
      }
    }
    if (other_chart_) refuse_other_chart(folder_);
    log.lines = std::move(good);
    std::stable_sort(log.damaged.begin(), log.damaged.end(),
                     [](const DamagedLine& a, const DamagedLine& b) { return a.number < b.number; });
  }

 private:
  void take_line(const nlohmann::ordered_json& json) {
    const int points = chart_.identity.points;
    if (json.contains("picture")) {
      take_picture(chart_picture_from(json, points));
    } else if (json.contains("sample")) {
      const ChartSample sample = chart_sample_from(json, points);
      if (ChartPoint* point = point_of(sample.number)) {
        point->samples_ms.push_back(sample.milliseconds);
        if (sample.upload_ms) point->uploads_ms.push_back(*sample.upload_ms);
      }
    } else if (json.contains("chart")) {
      Chart again;
      read_chart_head(json, again);
      other_chart_ = other_chart_ || again.identity != chart_.identity;
    } else {
      throw InputError("found an object of another kind, expected a picture or a sample");
    }
  }

  void take_picture(ChartPoint read) {
    ChartPoint* point = point_of(read.number);
    if (!point) return;
    const bool planned = others_ == OtherPoints::pass_over || point->compared;
    if (planned && read.what.settings != point->what.settings) {
      other_chart_ = true;
      return;
    }
    read.samples_ms = std::move(point->samples_ms);
    read.uploads_ms = std::move(point->uploads_ms);
    try {
      read.picture = load_levels(folder_ / picture_name(read));
    } catch (const InputError& error) {
      // Its numbers are good without it; a chart that goes on draws it again.
      chart_.damage.emplace_back(error.what());
      if (others_ == OtherPoints::pass_over) read.compared = false;
    }
    *point = std::move(read);
  }

  ChartPoint* point_of(int number) {
    const auto found = std::find_if(chart_.points.begin(), chart_.points.end(),
                                    [&](const ChartPoint& p) { return p.number == number; });
    if (found != chart_.points.end()) return &*found;
    if (others_ == OtherPoints::pass_over) return nullptr;
    chart_.points.emplace_back().number = number;
    return &chart_.points.back();
  }

  const std::filesystem::path& folder_;
  Chart& chart_;
  OtherPoints others_;
  bool other_chart_ = false;
};

}  // namespace

std::string picture_name(const ChartPoint& point) { return fmt::format("picture-{}.png", point.number); }

ChartLog::ChartLog(const std::filesystem::path& folder, Chart& chart, const Image<Rgb8>& reference) : folder_(folder) {
  lock_ = lock_log_folder(folder, "measuring a chart");
  const auto path = folder / log_name;
  std::string kept = chart_head_json(chart).dump() + "\n";
  if (std::filesystem::exists(path)) kept += take_up(path, chart);
  write_file_atomically(path, kept);
  Provenance made = provenance_of(chart.machine, chart.identity.base);
  made.more = {{"reference", chart.identity.reference}};
  save_image(folder / "reference.png", reference, {image_texts(made)});
  file_.open(path, std::ios::app);
  if (!file_) throw InputError(path.string() + ": cannot be written");
}

std::string ChartLog::take_up(const std::filesystem::path& path, Chart& chart) const {
  JsonLog log = read_json_log(path);
  if (log.lines.empty() && log.damaged.empty()) return "";
  if (read_head(path, log).identity != chart.identity) refuse_other_chart(folder_);
  LogReader(folder_, chart, OtherPoints::pass_over).take(log);
  if (!log.damaged.empty()) {
    std::vector<std::string> texts;
    for (const DamagedLine& line : log.damaged) texts.push_back(line.text);
    const auto aside = keep_aside(path, texts, ".damaged");
    for (const DamagedLine& line : log.damaged)
      chart.damage.push_back(
          fmt::format("{}; the line is kept in {}", damage_text(path, line), aside.filename().string()));
  }
  std::string kept;
  for (std::size_t i = 1; i < log.lines.size(); ++i) kept += log.lines[i].text + "\n";
  return kept;
}

void ChartLog::add_picture(const ChartPoint& point) {
  save_image(folder_ / picture_name(point), *point.picture, {image_texts(provenance_of(point.what.value))});
  write(chart_picture_json(point).dump());
}

void ChartLog::add_sample(const ChartPoint& point, double milliseconds) {
  write(chart_sample_json(point, milliseconds).dump());
}

void ChartLog::write(const std::string& line) {
  file_ << line << '\n' << std::flush;
  if (!file_) throw InputError((folder_ / log_name).string() + ": cannot be written");
}

Chart read_chart_log(const std::filesystem::path& folder) {
  const auto path = folder / log_name;
  JsonLog log = read_json_log(path);
  Chart chart = read_head(path, log);
  LogReader(folder, chart, OtherPoints::add).take(log);
  for (const DamagedLine& line : log.damaged)
    chart.damage.push_back(damage_text(path, line) + "; the line is left out");
  return chart;
}

}  // namespace ps
