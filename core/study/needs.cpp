#include "study/needs.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "frame/display_frame.h"
#include "options/option.h"
#include "options/renderer_kind.h"
#include "study/reference.h"
#include "study/same_machinery.h"
#include "study/timing.h"
#include "study/worst_tile.h"

namespace ps {
namespace {

struct Tried {
  Settings settings;
  std::shared_ptr<const Image<Rgb8>> picture;
  double error = 0;
  std::uint64_t work = 0;
};

class Search {
 public:
  Search(const NeedsRequest& request, StudyControl& control,
         const std::function<void(const Needs&, const StudyStatus&)>& update)
      : request_(request), control_(control), update_(update), traits_(scene_traits(request.scene)) {}

  Needs run() {
    Settings best = reference_settings(request_.base, traits_);
    // Whether a line goes through one pixel or its neighbour is a tie more often than not: there is no better truth.
    if (request_.base.draw != Draw::filled) best.precision = request_.base.precision;
    // Fragments cannot trace shadows: who asks them to has asked for none.
    if (draws_fragments(request_.base.renderer) && request_.base.shadows == Shadows::traced)
      best.shadows = Shadows::none;
    best.samples_per_pixel = request_.base.samples_per_pixel;
    best.sample_pattern = request_.base.sample_pattern;
    // Bounces that no mirror makes are nothing to advise.
    if (inactive_reason(*find_option("reflection-depth"), best, traits_))
      best.reflection_depth = request_.base.reflection_depth;
    reference_ = picture_of(best).levels;
    needs_.tolerance = request_.tolerance;
    const Tried start = try_out(request_.base);
    needs_.default_error = start.error;
    needs_.default_work = start.work;
    needs_.picture = start.picture;
    needs_.within_tolerance = start.error <= request_.tolerance;
    measure_features(start);
    // Where the settings themselves stray too far, what costs less strays as well: the search comes from the truth.
    const Tried found = descend(needs_.within_tolerance ? start : cheapest_truth(best));
    needs_.advice = found.settings;
    needs_.error = found.error;
    needs_.work = found.work;
    measure_times();
    return std::move(needs_);
  }

 private:
  /// The reference's settings, in the numbers of the settings asked about if that is within the tolerance. Rounding
  /// makes a few rays more or less, and the search would not pay one ray for numbers of half the size.
  Tried cheapest_truth(const Settings& best) {
    Settings plain = best;
    plain.precision = request_.base.precision;
    const Tried tried = try_out(plain);
    return tried.error <= request_.tolerance || plain.precision == best.precision ? tried : try_out(best);
  }

  struct Rendered {
    Image<Rgb8> levels;
    std::uint64_t work = 0;
  };

  Rendered picture_of(const Settings& settings) {
    control_.wait_here();
    RenderRequest how;
    how.priority = request_.priority;
    const Frame frame = render(request_.scene, request_.view, settings, how, prepared_, control_.progress());
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
    const double error = worst_tile_flip(reference_, rendered.levels);
    return {settings, std::make_shared<const Image<Rgb8>>(std::move(rendered.levels)), error, rendered.work};
  }

  void measure_features(const Tried& start) {
    for (const Feature& feature : features()) {
      FeatureShare share;
      share.feature = feature;
      if (const auto reason = unused_reason(feature, request_.base, traits_)) {
        share.reason = std::string(*reason);
        share.absent = never_used(feature, traits_);
      } else {
        share.used = true;
        const Tried tried = try_out(without(feature, request_.base));
        share.error_without = tried.error;
        share.picture = tried.picture;
        if (start.work > 0) share.work_share = 1 - static_cast<double>(tried.work) / static_cast<double>(start.work);
      }
      needs_.shares.push_back(std::move(share));
    }
  }

  /// An error must be paid for in work. A fragment and a test do not cost the same, so only half the count makes the
  /// other renderer surely the cheaper one.
  static bool worth_it(const Tried& now, const Tried& then) {
    if (then.settings.renderer != now.settings.renderer) return 2 * then.work <= now.work;
    if (then.settings.precision != now.settings.precision) return then.work <= now.work;  // numbers of half the size
    return then.work < now.work || (then.work == now.work && then.error <= now.error);
  }

  /// Steepest descent in counted work.
  Tried descend(Tried now) {
    while (true) {
      std::optional<Tried> next;
      std::size_t next_step = 0;
      for (const Saving& saving : savings(now.settings, traits_)) {
        Settings settings = now.settings;
        parse_option(*find_option(saving.option), saving.value, settings);
        const Tried tried = try_out(settings);
        needs_.trail.push_back({fmt::format("{}={}", saving.option, saving.value), tried.error, tried.work, false});
        // At equal work the first is kept: savings() lists whole features before their cheaper forms.
        const bool allowed = tried.error <= request_.tolerance && worth_it(now, tried);
        if (!allowed || (next && tried.work >= next->work)) continue;
        next = tried;
        next_step = needs_.trail.size() - 1;
      }
      if (!next) return now;
      needs_.trail[next_step].accepted = true;
      now = *next;
    }
  }

  static bool lie_apart(const Quartiles& a, const Quartiles& b) { return a.q3 < b.q1 || b.q3 < a.q1; }

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
    needs_.time_differs = lie_apart(base, advice);
    for (std::size_t i = 0; i < measured.size(); ++i) {
      const Quartiles less = quartiles(samples[i + 2]);
      measured[i]->cost_share = 1 - less.median / base.median;
      measured[i]->cost_differs = lie_apart(base, less);
    }
  }

  const NeedsRequest& request_;
  StudyControl& control_;
  const std::function<void(const Needs&, const StudyStatus&)>& update_;
  SceneTraits traits_;
  Prepared prepared_;
  Image<Rgb8> reference_;
  Needs needs_;
  StudyStatus status_;
};

}  // namespace

std::string needs_free_sentence(const FeatureShare& share) {
  const bool asks = share.reason.starts_with("needs ");
  return fmt::format("{} can be left out at no loss: {}{}.", share.feature.label, asks ? "the option " : "",
                     share.reason);
}

Needs find_needs(const NeedsRequest& request, StudyControl& control,
                 const std::function<void(const Needs&, const StudyStatus&)>& update) {
  return Search(request, control, update).run();
}

}  // namespace ps
