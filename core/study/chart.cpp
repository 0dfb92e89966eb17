#include "study/chart.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "base/check.h"
#include "base/memory_size.h"
#include "base/number_text.h"
#include "frame/display_frame.h"
#include "options/option.h"
#include "options/scene_settings.h"
#include "render/left_out.h"
#include "study/chart_front.h"
#include "study/chart_log.h"
#include "study/counted_work.h"
#include "study/model/reduce.h"
#include "study/pareto.h"

namespace ps {
namespace {

/// Products of all points are kept between rounds up to this many bytes together; beyond, they are built again.
constexpr std::size_t most_prepared_bytes = std::size_t{1} << 30;

std::size_t frame_bytes(const Frame& frame) {
  return frame.colour.pixels().size_bytes() + frame.colour_double.pixels().size_bytes() +
         frame.depth.pixels().size_bytes() + frame.ids.pixels().size_bytes();
}

/// The Fowler-Noll-Vo hash of bytes, as FNV-1a.
class Fingerprint {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

std::string fingerprint_of(const ChartRequest& request, const Image<Rgb8>& reference) {
  Fingerprint all;
  for (const Rgb8& pixel : reference.pixels()) all.add({reinterpret_cast<const char*>(&pixel), sizeof pixel});
  const Camera& camera = request.view.camera;
  for (const Vec3d& v : {camera.position, camera.right, camera.up, camera.forward})
    all.add(fmt::format("{},{},{};", v.x, v.y, v.z));
  all.add(fmt::format("{},{},{};", camera.viewport_width, camera.viewport_height, camera.projection_plane_d));
  for (const SweepPoint& point : request.points) {
    all.add(point.settings + "\n");
    if (point.scene) all.add(point.label + "\n");
  }
  return all.text();
}

ChartIdentity identity_of(const ChartRequest& request, const Reference& reference, const TimedSettings& timed) {
  ChartIdentity identity;
  identity.scene = request.scene.name;
  identity.width = request.view.width;
  identity.height = request.view.height;
  identity.values = request.error.values == ErrorValues::display ? "display" : "linear";
  identity.region = "all";
  if (const auto& r = request.error.region)
    identity.region = fmt::format("{},{},{},{}", r->x0, r->y0, r->width(), r->height());
  identity.reference = reference.description;
  identity.base = fmt::format("{}", fmt::join(changed_options(request.base), ";"));
  identity.machinery = timed.reason;
  identity.points = static_cast<int>(request.points.size());
  identity.fingerprint = fingerprint_of(request, reference.picture.levels);
  return identity;
}

/// Carries one chart out.
class Runner {
 public:
  Runner(const ChartRequest& request, StudyControl& control, const ChartUpdate& update, const Clock& clock)
      : request_(request), control_(control), update_(update), clock_(clock), traits_(scene_traits(request.scene)) {}

  Chart run() {
    const ReferencePlan plan =
        plan_reference(request_.points, request_.base, traits_, request_.view, request_.reference);
    reference_ = make_reference(request_.scene, request_.view, plan, request_.reference, request_.error,
                                request_.priority, control_.progress());
    const TimedSettings timed = timed_settings();
    chart_.identity = identity_of(request_, reference_, timed);
    chart_.machine = this_machine();
    chart_.absent = request_.absent;
    chart_.metric = request_.error.metric;
    chart_.across = request_.across;
    chart_.reference_halves = reference_.halves;
    const std::vector<Standing> standing = request_.reference.file.empty()
                                               ? standings(request_.points, plan, traits_)
                                               : std::vector(request_.points.size(), Standing::compared);
    for (std::size_t i = 0; i < request_.points.size(); ++i)
      if (static_cast<int>(i) % request_.shard.count == request_.shard.index) {
        ChartPoint point;
        point.number = static_cast<int>(i);
        point.what = request_.points[i];
        point.standing = standing[i];
        for (const LeftOut& left : left_out(traits_, timed.settings[i])) point.left_out.push_back(left.brief);
        chart_.points.push_back(std::move(point));
        drawn_with_.push_back(timed.settings[i]);
      }
    prepared_.resize(chart_.points.size());
    calls_.assign(chart_.points.size(), 0);
    if (!request_.folder.empty()) log_.emplace(request_.folder, chart_, reference_.picture.levels);
    report();
    for (int round = 0; round < request_.repeats; ++round)
      for (std::size_t i = 0; i < chart_.points.size(); ++i)
        if (!chart_.points[i].compared || static_cast<int>(chart_.points[i].samples_ms.size()) <= round) run_once(i);
    summarise(chart_, request_.error.metric);
    return std::move(chart_);
  }

 private:
  TimedSettings timed_settings() const {
    std::vector<Settings> settings;
    std::vector<std::string> labels;
    for (const SweepPoint& point : request_.points) {
      settings.push_back(point.value);
      labels.push_back(point.label);
    }
    return on_same_machinery(settings, labels, traits_, request_.machinery);
  }

  Frame picture_of(std::size_t i, Prepared& prepared, DriverMemory driver_memory = DriverMemory::kept) {
    RenderRequest how;
    how.priority = request_.priority;
    how.driver_memory = driver_memory;
    return render(scene_of(i), request_.view, drawn_with_[i], how, prepared, control_.progress());
  }

  const Scene& scene_of(std::size_t i) const {
    const auto& own = chart_.points[i].what.scene;
    return own ? *own : request_.scene;
  }

  void run_once(std::size_t i) {
    control_.wait_here();
    ChartPoint& point = chart_.points[i];
    if (!prepared_[i]) prepared_[i] = std::make_shared<Prepared>();
    const std::shared_ptr<Prepared> prepared = prepared_[i];
    const bool known = point.compared;
    const double start = clock_();
    if (!known) first_picture(i, *prepared);
    const double first_ms = 1e3 * (clock_() - start);
    measure_upload(i, *prepared);
    double drawn_ms = 0;  // as a driver says
    const auto call = [&] {
      const Frame frame = picture_of(i, *prepared);
      if (frame.driver) drawn_ms += frame.driver->draw_ms;
    };
    if (calls_[i] == 0)
      calls_[i] = calls_per_sample(call, request_.shortest_sample, clock_);
    else
      call();  // the others have filled the caches since
    drawn_ms = 0;
    const double wall_ms = sample_milliseconds(call, calls_[i], clock_);
    const double sample = by_driver(i) ? drawn_ms / calls_[i] : wall_ms;
    point.samples_ms.push_back(sample);
    if (!known) point.prepare_ms = std::max(0.0, first_ms - sample);
    if (log_) {
      if (!known) log_->add_picture(point);
      log_->add_sample(point, sample);
    }
    forget_if_large(i);
    summarise(chart_, request_.error.metric);
    report();
  }

  bool by_driver(std::size_t i) const {
    return fast_path(drawn_with_[i], traits_, Channel::none).machinery == Machinery::driver;
  }

  /// Of the whole scene, as if the driver had never seen it.
  void measure_upload(std::size_t i, Prepared& prepared) {
    if (!by_driver(i)) return;
    const Frame frame = picture_of(i, prepared, DriverMemory::emptied);
    if (frame.driver) chart_.points[i].uploads_ms.push_back(frame.driver->upload_ms);
  }

  void first_picture(std::size_t i, Prepared& prepared) {
    ChartPoint& point = chart_.points[i];
    const Frame frame = picture_of(i, prepared);
    MeasuredPicture picture{display_frame(frame, point.what.value), frame.colour};
    point.comparison = compare_pictures(reference_.picture, picture, request_.error);
    const bool model_varies = std::any_of(request_.points.begin(), request_.points.end(),
                                          [](const SweepPoint& p) { return p.scene != nullptr; });
    const std::size_t model = model_varies ? model::model_bytes(scene_of(i)) : 0;
    point.memory_mb = 1e-6 * static_cast<double>(prepared.bytes() + frame_bytes(frame) + model);
    point.counters = counters_of(i, frame);
    point.work = counted_work(point.counters);
    point.picture = std::move(picture.levels);
    point.compared = true;
  }

  /// What does not depend on the processor: of another picture, if need be.
  Counters counters_of(std::size_t i, const Frame& frame) {
    const Settings counted = counted_settings(drawn_with_[i], traits_);
    if (counted == drawn_with_[i]) return frame.counters;
    RenderRequest how;
    how.priority = request_.priority;
    Prepared prepared;
    return render(scene_of(i), request_.view, counted, how, prepared, control_.progress()).counters;
  }

  void forget_if_large(std::size_t i) {
    std::size_t bytes = 0;
    for (const auto& prepared : prepared_)
      if (prepared) bytes += prepared->bytes();
    if (bytes > most_prepared_bytes) prepared_[i].reset();
  }

  void report() {
    if (!update_) return;
    StudyStatus status;
    double known_ms = 0, left_ms = 0;
    int known = 0;
    for (const ChartPoint& point : chart_.points)
      if (point.measured()) {
        known_ms += point.time_ms.median;
        ++known;
      }
    for (std::size_t i = 0; i < chart_.points.size(); ++i) {
      const ChartPoint& point = chart_.points[i];
      const int done = std::min(static_cast<int>(point.samples_ms.size()), request_.repeats);
      status.done += done;
      status.total += request_.repeats;
      const double run_ms = point.measured() ? point.time_ms.median : known > 0 ? known_ms / known : 0;
      const int calls = 1 + std::max(calls_[i], 1);
      left_ms += run_ms * calls * (request_.repeats - done);
    }
    if (known > 0) status.seconds_left = 1e-3 * left_ms;
    update_(chart_, status);
  }

  const ChartRequest& request_;
  StudyControl& control_;
  const ChartUpdate& update_;
  const Clock& clock_;
  SceneTraits traits_;
  Reference reference_;
  Chart chart_;
  std::vector<std::shared_ptr<Prepared>> prepared_;
  std::vector<Settings> drawn_with_;  ///< of each point: its settings, or those on the code path that all share
  std::vector<int> calls_;            ///< renders within one sample of each point; 0 = not known yet
  std::optional<ChartLog> log_;
};

}  // namespace

Shard parse_shard(std::string_view text) {
  const auto slash = text.find('/');
  const auto index = parse_integer<int>(text.substr(0, slash));
  const auto count = slash == std::string_view::npos ? std::nullopt : parse_integer<int>(text.substr(slash + 1));
  if (!index || !count || *index < 0 || *count < 1 || *index > *count)
    throw InputError(fmt::format("shard: found '{}', expected i/n with i from 1 to n", text));
  return {*index % *count, *count};
}

Chart run_chart(const ChartRequest& request, StudyControl& control, const ChartUpdate& update, const Clock& clock) {
  if (request.repeats < 1) throw InputError(fmt::format("repeats: found {}, expected at least 1", request.repeats));
  return Runner(request, control, update, clock).run();
}

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

void summarise(Chart& chart, ErrorMetric metric) {
  chart.metric = metric;
  std::vector<Tradeoff> tradeoffs;
  std::vector<ChartPoint*> measured;
  for (ChartPoint& point : chart.points) {
    point.on_front = false;
    point.tie = false;
    if (!point.measured()) continue;
    point.time_ms = quartiles(point.samples_ms);
    if (!point.uploads_ms.empty()) point.upload_ms = quartiles(point.uploads_ms);
    point.error = error_of(point.standing == Standing::truth ? Comparison{} : point.comparison, metric);
    const double sign = error_metric(metric).higher_is_better ? -1 : 1;
    if (chart.across == ChartAcross::work && !point.work) {  // has no place on this axis
      point.cost = {nowhere, nowhere, nowhere};
      continue;
    }
    const double counted =
        chart.across == ChartAcross::work ? static_cast<double>(point.work.value_or(0)) : point.memory_mb;
    point.cost = chart.across == ChartAcross::time ? point.time_ms : Quartiles{counted, counted, counted};
    if (!point.ranked()) continue;
    tradeoffs.push_back({point.cost.median, sign * point.error});
    measured.push_back(&point);
  }
  const std::vector<bool> front = pareto_front(tradeoffs);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    measured[i]->on_front = front[i];
    measured[i]->tie = front_place(chart, *measured[i]) == FrontPlace::tie;
  }
}

Chart merge_charts(const std::vector<std::filesystem::path>& folders, ErrorMetric metric) {
  Chart whole;
  for (const auto& folder : folders) {
    Chart part = read_chart_log(folder);
    if (&folder == &folders.front()) {
      whole = std::move(part);
      continue;
    }
    if (!(part.identity == whole.identity))
      throw InputError(
          fmt::format("{}: holds a part of another chart than {}", folder.string(), folders.front().string()));
    for (ChartPoint& point : part.points) {
      const auto same = std::find_if(whole.points.begin(), whole.points.end(),
                                     [&](const ChartPoint& p) { return p.number == point.number; });
      if (same == whole.points.end()) {
        whole.points.push_back(std::move(point));
        continue;
      }
      if (!same->compared) std::swap(*same, point);  // the samples below are those of the other
      same->samples_ms.insert(same->samples_ms.end(), point.samples_ms.begin(), point.samples_ms.end());
      same->uploads_ms.insert(same->uploads_ms.end(), point.uploads_ms.begin(), point.uploads_ms.end());
    }
    whole.damage.insert(whole.damage.end(), part.damage.begin(), part.damage.end());
  }
  std::sort(whole.points.begin(), whole.points.end(),
            [](const ChartPoint& a, const ChartPoint& b) { return a.number < b.number; });
  summarise(whole, metric);
  return whole;
}

}  // namespace ps
