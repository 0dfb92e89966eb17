#pragma once
#include <array>
#include <vector>

namespace ps {

/// value -> round(value^(1/gamma) * highest) for value in [0, 1], by a table of the values at which the level steps up:
/// ((level - 1/2) / highest)^gamma. Values below 0 and NaN give 0, above 1 `highest`.
class GammaCurve {
 public:
  /// gamma > 0; highest in 1..255.
  GammaCurve(double gamma, unsigned highest);

  unsigned level(double value) const {
    if (!(value > 0)) return 0;
    if (value >= 1) return highest_;
    unsigned result = first_[static_cast<std::size_t>(value * buckets)];
    while (value >= steps_[result]) ++result;
    return result;
  }
  double gamma() const { return gamma_; }
  unsigned highest() const { return highest_; }

 private:
  static constexpr int buckets = 1024;
  double gamma_;
  unsigned highest_;
  std::vector<double> steps_;                   ///< steps_[k]: smallest value of level k + 1; infinity at the end
  std::array<unsigned char, buckets> first_{};  ///< the level at each bucket's lower end
};

/// The curve for these numbers, built once and kept for this thread.
const GammaCurve& gamma_curve(double gamma, unsigned highest);

}  // namespace ps
