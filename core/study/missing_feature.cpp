#include "study/missing_feature.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <set>
#include <tuple>

#include "base/check.h"
#include "image/difference.h"
#include "render/render.h"

#include <fmt/format.h>

namespace ps {
namespace {

constexpr double found_share = 0.98, found_of_difference = 0.9;
constexpr double settled_share = 0.998, settled_of_difference = 0.97;  // then the search ends
constexpr double least_gain = 0.25, least_gain_of_all = 0.002;         // of one more change
constexpr std::size_t starts_kept = 3;

/// A match with all that is needed to go on from it.
struct Attempt {
  MissingMatch match;
  std::vector<std::size_t> changes;
};

/// From 0 to 2: exact equality and nearness count alike, so that a way of rounding counts too.
double score(const MissingMatch& match) { return match.equal_share() + match.near_share(); }

bool nearer(const MissingMatch& a, const MissingMatch& b) {
  return score(a) != score(b) ? score(a) > score(b) : a.mean < b.mean;
}

/// The part of the pixels wrong in A that are right with the changes.
double explained(double before, double after) { return before >= 1 ? 0 : (after - before) / (1 - before); }

bool makes_the_file(const MissingMatch& match, const MissingMatch& as_is) {
  const auto by = [](double before, double after) {
    return after >= found_share && explained(before, after) >= found_of_difference;
  };
  return by(as_is.near_share(), match.near_share()) || by(as_is.equal_share(), match.equal_share());
}

bool settled(const MissingMatch& match, const MissingMatch& as_is) {
  return match.equal_share() >= settled_share &&
         explained(as_is.equal_share(), match.equal_share()) >= settled_of_difference;
}

bool worth_adding(const MissingMatch& more, const MissingMatch& before) {
  const double gain = score(more) - score(before);
  return gain >= least_gain_of_all && gain >= least_gain * (2 - score(before));
}

class MissingSearch {
 public:
  MissingSearch(const MissingRequest& request, StudyControl& control,
                const std::function<void(const StudyStatus&)>& update)
      : request_(request), control_(control), update_(update),
        candidates_(missing_candidates(request.scene, request.settings)) {}

  MissingFeature run() {
    if (request_.file.width() != request_.view.width || request_.file.height() != request_.view.height)
      throw InputError(fmt::format("the file has {} x {} pixels, expected {} x {}", request_.file.width(),
                                   request_.file.height(), request_.view.width, request_.view.height));
    result_.candidates = candidates_.size();
    status_.total = 1 + static_cast<int>(candidates_.size());
    result_.as_is = result_.best = *try_changes({});
    if (result_.as_is.equal == result_.as_is.pixels) return with(MissingFeature::Verdict::nothing_missing);
    std::vector<Attempt> singles;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (auto match = try_changes({i})) singles.push_back({std::move(*match), {i}});
    sort(singles);
    for (const Attempt& attempt : singles) result_.single.push_back(attempt.match);
    combine(singles);
    if (makes_the_file(result_.best, result_.as_is)) return with(MissingFeature::Verdict::found);
    if (result_.as_is.near == result_.as_is.pixels) return with(MissingFeature::Verdict::nothing_missing);
    return with(MissingFeature::Verdict::unexplained);
  }

 private:
  MissingFeature with(MissingFeature::Verdict verdict) {
    result_.verdict = verdict;
    return std::move(result_);
  }

  static void sort(std::vector<Attempt>& attempts) {
    std::stable_sort(attempts.begin(), attempts.end(),
                     [](const Attempt& a, const Attempt& b) { return nearer(a.match, b.match); });
  }

  void combine(const std::vector<Attempt>& singles) {
    if (singles.empty()) return;
    Attempt best{result_.as_is, {}};
    if (worth_adding(singles.front().match, best.match)) best = singles.front();
    std::vector<Attempt> starts = first_of(singles);
    for (int size = 2; size <= request_.most_changes && !settled(best.match, result_.as_is); ++size) {
      status_.total += static_cast<int>(starts.size() * singles.size());
      std::vector<Attempt> larger;
      for (const Attempt& start : starts)
        for (const Attempt& single : singles)
          if (auto attempt = both(start, single)) larger.push_back(std::move(*attempt));
      sort(larger);
      if (larger.empty() || !worth_adding(larger.front().match, best.match)) break;
      best = larger.front();
      starts = {best};
    }
    result_.best = best.match;
  }

  /// The nearest by pixels, and by the mean difference where that is another: a curve over all levels makes no pixel
  /// equal before the rest is right.
  static std::vector<Attempt> first_of(const std::vector<Attempt>& singles) {
    std::vector<Attempt> starts(singles.begin(),
                                singles.begin() + static_cast<std::ptrdiff_t>(std::min(starts_kept, singles.size())));
    const auto nearest = std::min_element(
        singles.begin(), singles.end(), [](const Attempt& a, const Attempt& b) { return a.match.mean < b.match.mean; });
    if (nearest - singles.begin() >= static_cast<std::ptrdiff_t>(starts.size())) starts.back() = *nearest;
    return starts;
  }

  std::optional<Attempt> both(const Attempt& start, const Attempt& single) {
    const std::size_t more = single.changes.front();
    for (const std::size_t change : start.changes)
      if (candidates_[change].subject == candidates_[more].subject) {
        step();
        return {};
      }
    Attempt attempt{{}, start.changes};
    attempt.changes.push_back(more);
    // Changes of the finished picture come last, whichever was found first.
    std::stable_partition(attempt.changes.begin(), attempt.changes.end(),
                          [&](std::size_t i) { return !candidates_[i].stored; });
    auto match = try_changes(attempt.changes);
    if (!match) return {};
    attempt.match = std::move(*match);
    return attempt;
  }

  /// nullopt where the same picture was tried before.
  std::optional<MissingMatch> try_changes(const std::vector<std::size_t>& changes) {
    control_.wait_here();
    PictureRecipe recipe{request_.scene, request_.settings, {}};
    MissingMatch match;
    std::vector<std::size_t> drawn;
    for (const std::size_t change : changes) {
      candidates_[change].apply(recipe);
      match.keys.push_back(candidates_[change].key);
      match.words.push_back(candidates_[change].words);
      if (!candidates_[change].stored) drawn.push_back(change);
    }
    const Image<Rgb8> levels = stored_levels(frame_of(recipe, drawn), recipe.settings, recipe.form);
    step();
    if (!seen_.insert({pixel_hash(levels), recipe.form.shift.x, recipe.form.shift.y}).second) return {};
    compare(levels, recipe.form, match);
    return match;
  }

  static std::uint64_t pixel_hash(const Image<Rgb8>& levels) {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a
    for (const Rgb8& level : levels.pixels())
      for (const std::uint8_t byte : {level.r, level.g, level.b}) hash = (hash ^ byte) * 1099511628211u;
    return hash;
  }

  /// Rendered anew only where the last one was of another recipe.
  const Frame& frame_of(const PictureRecipe& recipe, const std::vector<std::size_t>& drawn) {
    if (frame_ && drawn == drawn_) return *frame_;
    RenderRequest how;
    how.priority = request_.priority;
    frame_.emplace(render(recipe.scene, request_.view, recipe.settings, how, prepared_, control_.progress()));
    drawn_ = drawn;
    ++result_.renders;
    return *frame_;
  }

  void compare(const Image<Rgb8>& levels, const StoredForm& form, MissingMatch& match) const {
    const int left = std::max(0, form.shift.x), right = levels.width() + std::min(0, form.shift.x);
    const int top = std::max(0, form.shift.y), bottom = levels.height() + std::min(0, form.shift.y);
    std::int64_t sum = 0;
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) {
        const Rgb8 a = levels.at(x, y), b = request_.file.at(x, y);
        const int apart = largest_difference(a, b);
        ++match.pixels;
        match.equal += apart == 0 ? 1 : 0;
        match.near += apart <= 1 ? 1 : 0;
        sum += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
      }
    if (match.pixels > 0) match.mean = static_cast<double>(sum) / (3 * static_cast<double>(match.pixels));
  }

  void step() {
    ++status_.done;
    if (!update_) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    status_.seconds_left = seconds / status_.done * std::max(0, status_.total - status_.done);
    update_(status_);
  }

  using Seen = std::tuple<std::uint64_t, int, int>;  ///< the pixels' hash, and the shift

  const MissingRequest& request_;
  StudyControl& control_;
  const std::function<void(const StudyStatus&)>& update_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  const std::vector<MissingCandidate> candidates_;
  Prepared prepared_;
  std::optional<Frame> frame_;
  std::vector<std::size_t> drawn_;  ///< the changes of `frame_`
  std::set<Seen> seen_;
  MissingFeature result_;
  StudyStatus status_;
};

/// "99.8 %"; never 100 where a pixel is missing, and never 0 where there is one.
std::string share_text(std::int64_t count, std::int64_t of) {
  if (count == of) return "all pixels";
  const double percent = 100 * static_cast<double>(count) / static_cast<double>(of);
  if (percent >= 99.95) return fmt::format("all but {} of {} pixels", of - count, of);
  return fmt::format("{:.1f} % of the pixels", percent);
}

std::string how_equal(const MissingMatch& match) {
  std::string text = "in " + share_text(match.equal, match.pixels);
  if (match.near_share() - match.equal_share() >= 0.002)
    text += fmt::format(", and within one level in {}", share_text(match.near, match.pixels));
  return text;
}

}  // namespace

MissingFeature find_missing_feature(const MissingRequest& request, StudyControl& control,
                                    const std::function<void(const StudyStatus&)>& update) {
  return MissingSearch(request, control, update).run();
}

std::string missing_words(const MissingMatch& match) {
  return match.words.empty() ? "as it is" : fmt::format("{}", fmt::join(match.words, " and "));
}

std::string missing_sentence(const MissingFeature& found, std::string_view file) {
  const std::string as_is = fmt::format("A as it is equals it {}.", how_equal(found.as_is));
  switch (found.verdict) {
  case MissingFeature::Verdict::nothing_missing:
    return fmt::format("A equals {} {}: nothing is missing.", file, how_equal(found.as_is));
  case MissingFeature::Verdict::found:
    return fmt::format("A {} equals {} {}. {}", missing_words(found.best), file, how_equal(found.best), as_is);
  case MissingFeature::Verdict::unexplained:
    if (found.best.keys.empty())
      return fmt::format("None of {} changes, alone or together, makes {}, or comes nearer than A as it is. {}",
                         found.candidates, file, as_is);
    return fmt::format("None of {} changes, alone or together, makes {}. Nearest: A {} equals it {}. {}",
                       found.candidates, file, missing_words(found.best), how_equal(found.best), as_is);
  }
  return {};
}

}  // namespace ps
