#pragma once
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/counters.h"
#include "base/machine.h"
#include "frame/left_out.h"
#include "study/control.h"
#include "study/reference.h"
#include "study/same_machinery.h"
#include "study/standing.h"
#include "study/sweep.h"
#include "study/timing.h"

namespace ps {

/// What a chart shows along its horizontal axis.
enum class ChartAcross {
  time,    ///< milliseconds of one picture, median and quartiles
  work,    ///< counted_work(): the same on every machine
  memory,  ///< ChartPoint::memory_mb
};

/// One point of the chart of time or work against error.
struct ChartPoint {
  int number = 0;  ///< in the whole sweep, from 0; shards keep the numbers of the whole
  SweepPoint what;
  Standing standing = Standing::compared;
  std::vector<LeftOutBrief> left_out;  ///< what its renderer cannot show
  /// One for each repeat: wall time of one render, everything prepared; of a graphics driver, DriverTimes::draw_ms.
  std::vector<double> samples_ms;
  Quartiles time_ms;
  /// Of a picture that a graphics driver draws, whose times are those of its draw calls: what uploading the whole scene
  /// takes beside them; one for each repeat.
  std::vector<double> uploads_ms;
  std::optional<Quartiles> upload_ms;
  Quartiles cost;         ///< on the chart's horizontal axis: time_ms, or work without any spread; NaN: not counted
  double prepare_ms = 0;  ///< the first render, with building trees, mips and tessellations, minus the median time
  double memory_mb = 0;   ///< Prepared and Frame, in 10^6 bytes; where the model varies, with its own bytes
  Comparison comparison;
  bool compared = false;  ///< comparison, memory, counters and work are known
  double error = 0;       ///< the chosen metric; of the truth itself that of equal pictures
  Counters counters;
  std::optional<std::uint64_t> work;   ///< counted_work() of the counters, which are the same on every processor
  bool on_front = false;               ///< by the measured numbers: no other point is as good in both and better in one
  bool tie = false;                    ///< whether it lies on the front is decided by noise (FrontPlace::tie)
  std::optional<Image<Rgb8>> picture;  ///< for thumbnails and differences

  bool measured() const { return compared && !samples_ms.empty(); }
  /// Has a place on the chart. A renderer that counts no work has none where work is the horizontal axis.
  bool placed() const { return measured() && !std::isnan(cost.median); }
  /// Can it be better or worse than others? What shows another picture on purpose cannot.
  bool ranked() const { return placed() && standing != Standing::other_picture; }
};

/// What decides the numbers of a chart besides the points and the machine; results with another identity do not mix.
struct ChartIdentity {
  std::string scene;
  int width = 0, height = 0;
  std::string values;     ///< "display" or "linear"
  std::string region;     ///< "X,Y,W,H", or "all"
  std::string reference;  ///< its description
  std::string base;       ///< the settings under the sweep: "K=V;K=V"
  std::string machinery;  ///< which code was timed, and why: TimedSettings::reason
  int points = 0;         ///< of the whole sweep
  /// Of the reference's pixels, the camera and the settings of all points: distinguishes sweeps, views and edited
  /// scenes.
  std::string fingerprint;
  bool operator==(const ChartIdentity&) const = default;
};

struct Chart {
  ChartIdentity identity;
  Machine machine;
  ErrorMetric metric = ErrorMetric::rmse;
  ChartAcross across = ChartAcross::time;
  std::optional<Comparison> reference_halves;  ///< how far two halves of the reference's samples are apart
  std::vector<ChartPoint> points;              ///< in the order of the sweep; some may not be measured yet
  std::vector<std::string> absent;  ///< what the sweep would have as well on another machine, with the reason
  /// What the folder's log has lost: its damaged lines and missing pictures, each with file and line.
  std::vector<std::string> damage;
};

/// Part `index` of `count` of a sweep: every count-th point. The parts together are the whole.
struct Shard {
  int index = 0, count = 1;
};
/// Reads "i/n". i counts from 1 to n; taken modulo n, so that counting from 0 gives the same parts. Throws InputError.
Shard parse_shard(std::string_view text);

struct ChartRequest {
  Scene scene;
  View view;
  Settings base;
  std::vector<SweepPoint> points;   ///< of the whole sweep
  std::vector<std::string> absent;  ///< Chart::absent
  Shard shard;
  ErrorOptions error;
  ReferenceOptions reference;
  MachineryRule machinery = MachineryRule::same;
  ChartAcross across = ChartAcross::time;
  int repeats = 5;
  double shortest_sample = 0.005;  ///< seconds; shorter renders are repeated within one sample
  WorkerPriority priority = WorkerPriority::normal;
  /// Where results are kept as they arrive, and found again when the same chart is asked for; empty = nowhere.
  std::filesystem::path folder;
};

/// Called after each run, on the thread that runs the chart.
using ChartUpdate = std::function<void(const Chart&, const StudyStatus&)>;

/// Measures all points of the shard: the picture, its error and its memory first, then `repeats` timed runs of each,
/// interleaved so that a drift of the machine hits all alike, each after an untimed run. A cancelled chart throws
/// Cancelled; what is in the folder then is taken up by the next call. Throws InputError if the folder holds another
/// chart.
Chart run_chart(const ChartRequest& request, StudyControl& control, const ChartUpdate& update = {},
                const Clock& clock = steady_seconds);

/// Brings quartiles, costs along Chart::across, errors in `metric` and the front up to date with the samples.
void summarise(Chart& chart, ErrorMetric metric);

/// Reads the charts kept in several folders and makes one of them; Chart::damage names what could not be read, and
/// missing_points() what is lacking. Throws InputError unless all are parts of the same chart.
Chart merge_charts(const std::vector<std::filesystem::path>& folders, ErrorMetric metric);

}  // namespace ps
