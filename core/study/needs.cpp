#include "study/needs.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "frame/display_frame.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "study/needs_truth.h"
#include "study/same_machinery.h"
#include "study/study_frame.h"
#include "study/timing.h"
#include "study/worst_tile.h"

namespace ps {
namespace {

struct Tried {
  Settings settings;
  std::shared_ptr<const Image<Rgb8>> picture;
  std::vector<double> tiles;  // tile_flips() against the truth
  double error = 0;           // the largest of them
  double increase = 0;        // over where the search started
  std::uint64_t work = 0;
};

class Search {
 public:
  Search(const NeedsRequest& request, StudyControl& control,
         const std::function<void(const Needs&, const StudyStatus&)>& update)
      : request_(request), control_(control), update_(update), traits_(scene_traits(request.scene)) {}

  Needs run() {
    const NeedsTruth truth = needs_truth(request_.base, traits_, request_.view);
    take_reference(truth.plan);
    needs_.tolerance = request_.tolerance;
    needs_.meshes = bytes_of_meshes(request_.scene);
    Tried start = try_out(request_.base);
    start_ = start.tiles;
    needs_.default_error = start.error;
    needs_.default_work = start.work;
    needs_.picture = start.picture;
    measure_features(start);
    if (const auto better = better_start(start, truth.exact)) {
      needs_.within_tolerance = false;
      start = *better;
      start_ = start.tiles;
    }
    const Tried found = descend(start);
    needs_.advice = found.settings;
    needs_.error = found.error;
    needs_.increase = found.increase;
    needs_.work = found.work;
    measure_times();
    return std::move(needs_);
  }

 private:
  void take_reference(const ReferencePlan& plan) {
    control_.wait_here();
    const Reference made = make_reference(request_.scene, request_.view, plan, {}, {ErrorMetric::flip, {}, {}},
                                          request_.priority, control_.progress());
    reference_ = made.picture.levels;
    needs_.truth = made.description;
    needs_.uncertainty = reference_noise(made, ErrorMetric::flip).value_or(0);
  }

  /// The exact settings, where they come closer to the truth by more than the tolerance and lose as much nowhere.
  std::optional<Tried> better_start(const Tried& start, const Settings& exact) {
    if (exact == start.settings) return {};
    Tried better = try_out(exact);
    const double gain = worst_increase(better.tiles, start.tiles), loss = better.increase;
    if (gain <= request_.tolerance || loss > request_.tolerance) return {};
    better.increase = 0;  // it is what the search compares with
    return better;
  }

  struct Rendered {
    Image<Rgb8> levels;
    std::uint64_t work = 0;
  };

  Rendered picture_of(const Settings& settings) {
    const Frame frame = study_frame(request_.scene, request_.view, settings, control_, request_.priority, prepared_);
    const auto work = counted_work(frame.counters);
    if (!work)
      throw InputError(fmt::format("renderer: found {}, which counts no work; expected one whose work can be compared",
                                   renderer_kind(settings.renderer).key));
    return {display_frame(frame, settings), *work};
  }

  Tried try_out(const Settings& settings) {
    Rendered rendered = picture_of(counted_settings(settings, traits_));
    ++status_.done;
    status_.total = std::max(status_.total, status_.done);
    if (update_) update_(needs_, status_);
    Tried tried;
    tried.settings = settings;
    tried.tiles = tile_flips(reference_, rendered.levels);
    tried.error = *std::max_element(tried.tiles.begin(), tried.tiles.end());
    if (!start_.empty()) tried.increase = worst_increase(start_, tried.tiles);
    tried.picture = std::make_shared<const Image<Rgb8>>(std::move(rendered.levels));
    tried.work = rendered.work;
    return tried;
  }

  void measure_features(const Tried& start) {
    for (const Feature& feature : features()) {
      FeatureShare share;
      share.feature = feature;
      if (const auto reason = unused_reason(feature, request_.base, traits_)) {
        share.reason = reason;
        share.absent = never_used(feature, traits_);
      } else {
        share.used = true;
        const Tried tried = try_out(without(feature, request_.base));
        share.error_without = tried.error;
        share.increase = tried.increase;
        share.picture = tried.picture;
        if (start.work > 0) share.work_share = 1 - static_cast<double>(tried.work) / static_cast<double>(start.work);
      }
      needs_.shares.push_back(std::move(share));
    }
  }

  /// An error must be paid for in work, and by more than noise. A fragment and a test do not cost the same, so only
  /// half the count makes the other renderer surely the cheaper one.
  bool worth_it(const Tried& now, const Tried& then, const Saving& saving) const {
    const Option& option = *find_option(saving.option);
    const bool as_asked = option.get(now.settings) == option.get(request_.base);
    if (!as_asked) return then.work < now.work;  // back from the exact value towards the one asked about
    if (then.settings.renderer != now.settings.renderer) return 2 * then.work <= now.work;
    if (then.settings.precision != now.settings.precision) return then.work <= now.work;  // numbers of half the size
    if (switches_off(saving) && worst_increase(now.tiles, then.tiles) == 0) return then.work <= now.work;
    return static_cast<double>(then.work) <= (1 - least_saving) * static_cast<double>(now.work);
  }

  static bool is_off(const Feature& feature, const Saving& saving) {
    return feature.option == saving.option && feature.off == saving.value;
  }
  static bool switches_off(const Saving& saving) {
    return std::any_of(features().begin(), features().end(),
                       [&](const Feature& feature) { return is_off(feature, saving); });
  }
  bool drops_what_is_needed(const Saving& saving) const {
    return std::any_of(needs_.shares.begin(), needs_.shares.end(), [&](const FeatureShare& share) {
      return is_needed(share, request_.tolerance) && is_off(share.feature, saving);
    });
  }

  /// Steepest descent in counted work.
  Tried descend(Tried now) {
    while (true) {
      std::optional<Tried> next;
      std::size_t next_step = 0;
      for (const Saving& saving : savings(now.settings, traits_)) {
        if (drops_what_is_needed(saving)) continue;
        Settings settings = now.settings;
        parse_option(*find_option(saving.option), saving.value, settings);
        const Tried tried = try_out(settings);
        needs_.trail.push_back(
            {fmt::format("{}={}", saving.option, saving.value), tried.error, tried.increase, tried.work, false});
        // At equal work the first is kept: savings() lists whole features before their cheaper forms.
        const bool allowed = tried.increase <= request_.tolerance && worth_it(now, tried, saving);
        if (!allowed || (next && tried.work >= next->work)) continue;
        next = tried;
        next_step = needs_.trail.size() - 1;
      }
      if (!next) return now;
      needs_.trail[next_step].accepted = true;
      now = *next;
    }
  }

  void measure_times() {
    std::vector<Settings> all{request_.base, needs_.advice};
    std::vector<std::string> labels{"the current settings", "the advice"};
    std::vector<FeatureShare*> measured;
    for (FeatureShare& share : needs_.shares)
      if (share.used) {
        all.push_back(without(share.feature, request_.base));
        labels.push_back(fmt::format("without {}", share.feature.label));
        measured.push_back(&share);
      }
    const TimedSettings timed = on_same_machinery(all, labels, traits_);
    const std::vector<Settings>& variants = timed.settings;
    needs_.machinery = timed.reason;
    std::vector<std::vector<double>> samples(variants.size());
    for (int round = 0; round < request_.repeats; ++round)
      for (std::size_t i = 0; i < variants.size(); ++i) {
        picture_of(variants[i]);
        samples[i].push_back(sample_milliseconds([&] { picture_of(variants[i]); }, 1, steady_seconds));
      }
    const Quartiles base = quartiles(samples[0]), advice = quartiles(samples[1]);
    needs_.default_time_ms = base.median;
    needs_.time_ms = advice.median;
    needs_.time_differs = !within_noise(base, advice);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      const Quartiles less = quartiles(samples[i + 2]);
      measured[i]->cost_share = 1 - less.median / base.median;
      measured[i]->cost_differs = !within_noise(base, less);
    }
  }

  const NeedsRequest& request_;
  StudyControl& control_;
  const std::function<void(const Needs&, const StudyStatus&)>& update_;
  SceneTraits traits_;
  Prepared prepared_;
  Image<Rgb8> reference_;
  std::vector<double> start_;  ///< tile_flips() of the picture from which the search starts
  Needs needs_;
  StudyStatus status_;
};

}  // namespace

Needs find_needs(const NeedsRequest& request, StudyControl& control,
                 const std::function<void(const Needs&, const StudyStatus&)>& update) {
  return Search(request, control, update).run();
}

}  // namespace ps
