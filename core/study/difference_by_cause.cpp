#include "study/difference_by_cause.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <map>
#include <numeric>
#include <random>

#include "frame/display_frame.h"
#include "options/option.h"

namespace ps {
namespace {

using Mask = std::uint64_t;
constexpr std::size_t most_for_every_order = 6;
constexpr std::size_t most_options = 63;

class Ablation {
 public:
  Ablation(const CauseRequest& request, StudyControl& control, const std::function<void(const StudyStatus&)>& update)
      : request_(request), control_(control), update_(update) {}

  DifferenceByCause run() {
    collect_options();
    reference_ = picture_of(request_.a);
    known_[0] = 0;
    const std::size_t count = measured_.size();
    const Mask all = (Mask{1} << count) - 1;
    std::vector<double> shares(count, 0);
    result_.every_order = count <= most_for_every_order;
    status_.total = result_.every_order ? 1 << count : static_cast<int>(2 * count + 2 * count * orders());
    if (result_.every_order)
      every_order(shares);
    else
      random_orders(shares);
    result_.total = error(all);
    for (std::size_t i = 0; i < count; ++i) {
      CauseShare& cause = result_.causes[measured_[i].place];
      cause.share = shares[i];
      cause.alone = error(Mask{1} << i);
      cause.without = error(all & ~(Mask{1} << i));
    }
    std::stable_sort(result_.causes.begin(), result_.causes.end(),
                     [](const CauseShare& x, const CauseShare& y) { return x.share > y.share; });
    result_.metric = std::string(error_metric(metric()).label);
    return std::move(result_);
  }

 private:
  struct Measured {
    const Option* option;
    std::size_t place;  // in result_.causes
  };

  void collect_options() {
    for (const Option& option : option_table()) {
      if (option.get(request_.a) == option.get(request_.b)) continue;
      CauseShare cause;
      cause.option = std::string(option.key);
      cause.from = option_text(option, request_.a);
      cause.to = option_text(option, request_.b);
      if (option.effect == OptionEffect::speed)
        cause.note = "only speed changes";
      else if (measured_.size() < most_options)
        measured_.push_back({&option, result_.causes.size()});
      result_.causes.push_back(std::move(cause));
    }
  }

  std::size_t orders() const { return static_cast<std::size_t>(std::max(1, request_.orders)); }

  /// The Shapley value as a sum over the sets that may come before an option.
  void every_order(std::vector<double>& shares) {
    const std::size_t count = measured_.size();
    std::vector<double> factorial(count + 1, 1);
    for (std::size_t i = 1; i <= count; ++i) factorial[i] = factorial[i - 1] * static_cast<double>(i);
    for (std::size_t i = 0; i < count; ++i)
      for (Mask set = 0; set < Mask{1} << count; ++set) {
        if ((set >> i & 1) != 0) continue;
        const auto before = static_cast<std::size_t>(std::popcount(set));
        const double weight = factorial[before] * factorial[count - before - 1] / factorial[count];
        shares[i] += weight * (error(set | Mask{1} << i) - error(set));
      }
  }

  void random_orders(std::vector<double>& shares) {
    std::mt19937_64 random(request_.seed);
    std::vector<std::size_t> order(measured_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t round = 0; round < orders(); ++round) {
      for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
      for (int way = 0; way < 2; ++way) {
        Mask set = 0;
        for (const std::size_t i : order) {
          shares[i] += (error(set | Mask{1} << i) - error(set)) / (2 * static_cast<double>(orders()));
          set |= Mask{1} << i;
        }
        std::reverse(order.begin(), order.end());
      }
    }
  }

  ErrorMetric metric() const {
    return request_.error.metric == ErrorMetric::psnr ? ErrorMetric::rmse : request_.error.metric;
  }

  /// Of A with the options of `set` taken from B, against A.
  double error(Mask set) {
    if (const auto found = known_.find(set); found != known_.end()) return found->second;
    Settings mixed = request_.a;
    for (std::size_t i = 0; i < measured_.size(); ++i)
      if ((set >> i & 1) != 0) measured_[i].option->set(mixed, measured_[i].option->get(request_.b));
    ErrorOptions how = request_.error;
    how.metric = metric();
    const double value = error_of(compare_pictures(reference_, picture_of(mixed), how), how.metric);
    return known_[set] = how.metric == ErrorMetric::ssim ? 1 - value : value;
  }

  MeasuredPicture picture_of(const Settings& settings) {
    control_.wait_here();
    RenderRequest how;
    how.priority = request_.priority;
    const Frame frame = render(request_.scene, request_.view, settings, how, prepared_, control_.progress());
    ++result_.renders;
    status_.done = result_.renders;
    if (update_) {
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
      status_.seconds_left = seconds / status_.done * std::max(0, status_.total - status_.done);
      update_(status_);
    }
    return {display_frame(frame, settings), frame.colour};
  }

  const CauseRequest& request_;
  StudyControl& control_;
  const std::function<void(const StudyStatus&)>& update_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  Prepared prepared_;
  MeasuredPicture reference_;
  std::vector<Measured> measured_;
  std::map<Mask, double> known_;
  DifferenceByCause result_;
  StudyStatus status_;
};

}  // namespace

DifferenceByCause difference_by_cause(const CauseRequest& request, StudyControl& control,
                                      const std::function<void(const StudyStatus&)>& update) {
  return Ablation(request, control, update).run();
}

}  // namespace ps
