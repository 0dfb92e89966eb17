#include "gui/panels/studies/chart_tab.h"
#include "image/file.h"

namespace ps::gui {
namespace {

/// A point without its picture, which is large.
ChartPoint light(const ChartPoint& point) {
  ChartPoint copy;
  copy.number = point.number;
  copy.what = point.what;
  copy.standing = point.standing;
  copy.left_out = point.left_out;
  copy.samples_ms = point.samples_ms;
  copy.uploads_ms = point.uploads_ms;
  copy.time_ms = point.time_ms;
  copy.upload_ms = point.upload_ms;
  copy.prepare_ms = point.prepare_ms;
  copy.memory_mb = point.memory_mb;
  copy.comparison = point.comparison;
  copy.compared = point.compared;
  copy.error = point.error;
  copy.counters = point.counters;
  copy.work = point.work;
  copy.on_front = point.on_front;
  copy.tie = point.tie;
  return copy;
}

ChartFound next_state(const Chart& chart, const ChartFound& before, const std::filesystem::path& folder) {
  ChartFound next;
  next.chart.identity = chart.identity;
  next.chart.machine = chart.machine;
  next.chart.metric = chart.metric;
  next.chart.across = chart.across;
  next.chart.reference_halves = chart.reference_halves;
  next.chart.absent = chart.absent;
  next.chart.damage = chart.damage;
  next.pictures = before.pictures;
  for (const ChartPoint& point : chart.points) {
    next.chart.points.push_back(light(point));
    if (point.picture && !next.pictures.contains(point.number))
      next.pictures[point.number] = std::make_shared<const Image<Rgb8>>(*point.picture);
  }
  next.reference = before.reference;
  if (!next.reference) next.reference = std::make_shared<const Image<Rgb8>>(load_levels(folder / "reference.png"));
  return next;
}

}  // namespace

void run_chart_study(const ChartRequest& request, StudyControl& control,
                     const std::function<void(const StudyStatus&, std::shared_ptr<const ChartFound>)>& report) {
  auto newest = std::make_shared<const ChartFound>();
  run_chart(request, control, [&](const Chart& chart, const StudyStatus& status) {
    newest = std::make_shared<const ChartFound>(next_state(chart, *newest, request.folder));
    report(status, newest);
  });
}

}  // namespace ps::gui
