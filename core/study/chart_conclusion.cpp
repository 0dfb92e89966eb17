#include "study/chart_conclusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/enumerators.h"
#include "base/sentence.h"
#include "render/left_out.h"
#include "study/chart_front.h"
#include "study/chart_style.h"

namespace ps {
namespace {

using Points = std::vector<const ChartPoint*>;
using Kind = ChartClaim::Kind;

constexpr std::size_t most_named = 3;  ///< points of a list; more are counted
/// What is left of the whole gain in exactness where a point has nearly all of it.
constexpr double rest_of_a_gain = 0.01;

enum class Compared { with_one, alone };

/// "2.3 times the time of" or "2.3 times the time"; "4 % more work than" where "1 times" would say nothing.
std::string times_text(double ratio, std::string_view cost, Compared compared) {
  const bool alone = compared == Compared::alone;
  if (ratio < least_time_ratio) return fmt::format("{:.2g} % more {}{}", 100 * (ratio - 1), cost, alone ? "" : " than");
  const std::string factor = ratio < 10 ? fmt::format("{:.2g}", ratio) : fmt::format("{:.0f}", ratio);
  return fmt::format("{} times the {}{}", factor, cost, alone ? "" : " of");
}

/// Beginnings of labels that a sentence cannot take without quotation marks: "from of the triangle to ...".
constexpr std::array function_words{"the ", "of ", "to ", "by ", "in ", "as ", "one "};

bool needs_quotes(const std::string& name) {
  return name.find(',') != std::string::npos || std::any_of(function_words.begin(), function_words.end(),
                                                            [&](const char* word) { return name.starts_with(word); });
}

/// Writes the sentence of one chart. Every order that it states goes through claim().
class Writer {
 public:
  explicit Writer(const Chart& chart) : chart_(chart), names_(chart_names(chart)) {
    for (const ChartPoint& point : chart.points)
      if (point.placed() && !std::isnan(point.error)) of_standing(point.standing).push_back(&point);
  }

  ChartConclusion write() {
    if (points_.empty() && truths_.empty() && others_.empty()) return {};
    std::string sentence = measured();
    const bool partial = std::any_of(chart_.points.begin(), chart_.points.end(),
                                     [](const ChartPoint& point) { return !point.measured(); });
    std::string start = partial ? "So far" : "";
    if (!names_.common.empty()) start += (start.empty() ? "" : ", ") + names_.common;
    made_.sentence = start.empty() ? begun_large(sentence) : fmt::format("{}: {}", start, sentence);
    made_.sentence += what_is_not_compared() + what_is_left_out();
    return std::move(made_);
  }

 private:
  Points& of_standing(Standing standing) {
    switch (standing) {
    case Standing::compared:
      return points_;
    case Standing::truth:
      return truths_;
    case Standing::other_picture:
      return others_;
    }
    return points_;
  }

  std::string measured() {
    if (points_.size() == 1 && truths_.size() == 1) return against_the_truth(*points_.front(), *truths_.front());
    if (points_.size() == 1) return "only one point is measured, so there is nothing to compare.";
    if (points_.empty() && truths_.empty())
      return "each value shows another picture on purpose, so none is more exact than another.";
    if (points_.empty()) return "no point has an error of its own.";
    const bool costs_tie = none([&](auto& a, auto& b) { return cheaper(a, b); });
    const bool errors_tie = none([&](auto& a, auto& b) { return more_exact(a, b); });
    if (costs_tie && errors_tie)
      return fmt::format("none of the {} points is better than another; {}, and {}.", points_.size(), cost_tie(),
                         error_tie());
    if (errors_tie) return only_costs();
    if (costs_tie) return only_errors();
    return both();
  }

  std::string only_costs() {
    const Points first = those_without([&](auto& other, auto& point) { return cheaper(other, point); });
    if (first.size() > 1)
      return fmt::format("the {} is one of {}, which no point surely beats; {}.",
                         time() ? "fastest" : fmt::format("one with the least {}", cost()), list(first, "and"),
                         error_tie());
    const ChartPoint& slowest = *largest(points_, [](auto& point) { return point.cost.median; });
    claim_all(Kind::cheaper, *first.front());
    return fmt::format("{} {} {} {}; {}.", name(slowest), time() ? "takes" : "needs",
                       times_text(slowest.cost.median / first.front()->cost.median, cost(), Compared::with_one),
                       name(*first.front()), error_tie());
  }

  /// Of one point beside the truth itself.
  std::string against_the_truth(const ChartPoint& point, const ChartPoint& truth) {
    const double rounding = error_of(truth.comparison, chart_.metric);
    std::string text = better_error(chart_.metric, rounding, point.error)
                           ? fmt::format("the {} of {} is {}{} against {}, which is the truth itself", quantity(),
                                         name(point), number(point.error), unit(), name(truth))
                           : fmt::format("{} is as exact as {}, which is the truth itself", name(point), name(truth));
    truths_.clear();  // it is said
    if (!cheaper(point, truth) && !cheaper(truth, point)) return fmt::format("{}; {}.", text, cost_tie());
    const ChartPoint &fast = cheaper(point, truth) ? point : truth, &slow = &fast == &point ? truth : point;
    claim(Kind::cheaper, fast, slow);
    return fmt::format("{}; {} {} {} {}.", text, name(slow), time() ? "takes" : "needs",
                       times_text(slow.cost.median / fast.cost.median, cost(), Compared::with_one), name(fast));
  }

  std::string what_is_not_compared() const {
    std::string text;
    if (!truths_.empty())
      text += fmt::format(" {} {} the truth itself.", begun_large(list(truths_, "and")),
                          truths_.size() == 1 ? "is" : "are");
    if (!others_.empty() && !points_.empty())
      text += fmt::format(" {} {} another picture on purpose, so the difference is not an error.",
                          begun_large(list(others_, "and")), others_.size() == 1 ? "shows" : "show");
    return text;
  }

  /// Points that leave out the same share a sentence.
  std::string what_is_left_out() const {
    std::vector<std::pair<std::string, Points>> all;
    for (const ChartPoint& point : chart_.points) {
      if (point.left_out.empty() || !point.placed()) continue;
      const std::string words = fmt::format("{}", fmt::join(briefs_together(point.left_out), " and "));
      auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == words; });
      if (found == all.end()) found = all.insert(found, {words, {}});
      found->second.push_back(&point);
    }
    std::string text;
    for (const auto& [words, points] : all)
      text += points.size() == 1 ? fmt::format(" {} {}.", begun_large(name(*points.front())), words)
                                 : fmt::format(" Of {}, each {}.", list(points, "and"), words);
    return text;
  }

  std::string only_errors() {
    const Points best = those_without([&](auto& other, auto& point) { return more_exact(other, point); });
    if (best.size() > 1)
      return fmt::format("the most exact is one of {}, which no point surely beats; {}.", list(best, "and"),
                         cost_tie());
    claim_all(Kind::more_exact, *best.front());
    return fmt::format("{} is the most exact ({} {}{}); {}.", name(*best.front()), quantity(),
                       number(best.front()->error), unit(), cost_tie());
  }

  std::string both() {
    const Points cheapest = those_without([&](auto& other, auto& point) { return cheaper(other, point); });
    const Points best = those_without([&](auto& other, auto& point) { return more_exact(other, point); });
    Points ideal;
    for (const ChartPoint* point : cheapest)
      if (std::find(best.begin(), best.end(), point) != best.end()) ideal.push_back(point);
    if (!ideal.empty())
      return fmt::format("no point is surely {} or more exact than {}.", time() ? "faster" : "cheaper",
                         list(ideal, "or"));
    const ChartPoint *from = nullptr, *to = nullptr;
    for (const ChartPoint* a : cheapest)
      for (const ChartPoint* b : best) {
        if (!cheaper(*a, *b) || !more_exact(*b, *a)) continue;
        if (from && !(to == b ? better_error(chart_.metric, a->error, from->error) : less_work(*b, *to))) continue;
        from = a;
        to = b;
      }
    if (!from) return "times and errors overlap too much for an order of the points.";
    to = first_with_the_gain(*from, *to);
    claim(Kind::cheaper, *from, *to);
    claim(Kind::more_exact, *to, *from);
    return fmt::format("from {} to {}, the {} for {}{}.", name(*from), name(*to), change(*from, *to),
                       times_text(to->cost.median / from->cost.median, cost(), Compared::alone), no_gain(*to));
  }

  /// Which of two points does less, by what is counted, so that noise does not choose between them.
  static bool less_work(const ChartPoint& a, const ChartPoint& b) {
    if (a.work && b.work && *a.work != *b.work) return *a.work < *b.work;
    if (a.work && b.work) return a.number < b.number;
    return a.cost.median < b.cost.median;
  }

  /// The point with the least work that has all of the gain in exactness from `from` to `best`, or nearly all of it.
  const ChartPoint* first_with_the_gain(const ChartPoint& from, const ChartPoint& best) const {
    const ChartPoint* first = &best;
    const double gain = std::abs(from.error - best.error);
    for (const ChartPoint* point : points_) {
      const bool has_it = point->error == best.error || better_error(chart_.metric, point->error, best.error) ||
                          std::abs(point->error - best.error) <= rest_of_a_gain * gain;
      if (has_it && cheaper(from, *point) && more_exact(*point, from) && less_work(*point, *first)) first = point;
    }
    return first;
  }

  /// "RMSE falls from 1.7 to 0.7 levels of 255"
  std::string change(const ChartPoint& from, const ChartPoint& to) const {
    return fmt::format("{} {} from {} to {}{}", quantity(), to.error > from.error ? "rises" : "falls",
                       number(from.error), number(to.error), unit());
  }

  /// What costs more than the most exact point without a gain.
  std::string no_gain(const ChartPoint& best) {
    Points more;
    for (const ChartPoint* point : points_)
      if (cheaper(best, *point) && !more_exact(*point, best)) more.push_back(point);
    if (more.empty()) return "";
    for (const ChartPoint* point : more) claim(Kind::cheaper, best, *point);
    if (more.size() > 1) return fmt::format("; {} points take more without a measurable gain", more.size());
    return fmt::format("; {} takes more without a measurable gain", name(*more.front()));
  }

  std::string cost_tie() const {
    if (!time()) return fmt::format("all need the same {}", cost());
    const bool few = std::any_of(points_.begin(), points_.end(), [](const ChartPoint* point) {
      return static_cast<int>(point->samples_ms.size()) < least_runs_for_quartiles;
    });
    return few ? fmt::format("fewer than {} runs do not order their times", least_runs_for_quartiles)
               : "their times are equal within noise";
  }

  std::string error_tie() const {
    const bool equal = std::all_of(points_.begin(), points_.end(),
                                   [&](const ChartPoint* point) { return point->error == points_.front()->error; });
    if (equal) return "their errors are equal";
    return fmt::format("their errors differ by less than the uncertainty of the reference{}", noise_text());
  }

  /// " (0.56)", where the uncertainty has the unit of the errors.
  std::string noise_text() const {
    const auto noise = chart_noise(chart_);
    const bool same_unit = chart_.metric != ErrorMetric::psnr && chart_.metric != ErrorMetric::ssim;
    return noise && same_unit ? fmt::format(" ({:.2g})", *noise) : "";
  }

  bool time() const { return chart_.across == ChartAcross::time; }
  std::string_view cost() const { return enumerator_key(chart_.across); }
  std::string quantity() const {
    return chart_.metric == ErrorMetric::psnr ? "PSNR" : std::string(error_metric(chart_.metric).label);
  }
  std::string unit() const {
    if (chart_.metric == ErrorMetric::psnr) return " dB";
    if (!error_metric(chart_.metric).in_levels) return "";
    return chart_.identity.values == "linear" ? "" : " levels of 255";
  }
  static std::string number(double value) { return std::isinf(value) ? "infinity" : fmt::format("{:.3g}", value); }

  /// In quotes if a sentence cannot take it as it is.
  std::string name(const ChartPoint& point) const {
    const std::string& text = names_.parts[static_cast<std::size_t>(&point - chart_.points.data())];
    return needs_quotes(text) ? fmt::format("\"{}\"", text) : text;
  }
  /// "A, B and C"
  std::string list(const Points& points, std::string_view last) const {
    if (points.size() > most_named) return fmt::format("{} points", points.size());
    std::vector<std::string> names;
    for (const ChartPoint* point : points) names.push_back(name(*point));
    return listed(names, last);
  }

  bool cheaper(const ChartPoint& a, const ChartPoint& b) const { return surely_cheaper(chart_, a, b); }
  bool more_exact(const ChartPoint& a, const ChartPoint& b) const { return surely_more_exact(chart_, a, b); }

  template <class Relation>
  bool none(const Relation& holds) const {
    return std::none_of(points_.begin(), points_.end(), [&](const ChartPoint* a) {
      return std::any_of(points_.begin(), points_.end(), [&](const ChartPoint* b) { return holds(*a, *b); });
    });
  }
  /// The points to which no other has the relation.
  template <class Relation>
  Points those_without(const Relation& holds) const {
    Points found;
    for (const ChartPoint* point : points_)
      if (std::none_of(points_.begin(), points_.end(), [&](const ChartPoint* other) { return holds(*other, *point); }))
        found.push_back(point);
    return found;
  }
  template <class Value>
  static const ChartPoint* largest(const Points& points, const Value& value) {
    return *std::max_element(points.begin(), points.end(),
                             [&](const ChartPoint* a, const ChartPoint* b) { return value(*a) < value(*b); });
  }

  void claim(Kind kind, const ChartPoint& first, const ChartPoint& second) {
    made_.claims.push_back({kind, first.number, second.number});
  }
  void claim_all(Kind kind, const ChartPoint& first) {
    for (const ChartPoint* point : points_)
      if (point != &first) claim(kind, first, *point);
  }

  const Chart& chart_;
  SweepNames names_;
  Points points_, truths_, others_;  ///< measured, by their standing
  ChartConclusion made_;
};

}  // namespace

ChartConclusion chart_conclusion(const Chart& chart) { return Writer(chart).write(); }

}  // namespace ps
