#include "image/gamma_curve.h"

#include <limits>
#include <list>

#include "base/check.h"
#include "math/power.h"

namespace ps {

GammaCurve::GammaCurve(double gamma, unsigned highest) : gamma_(gamma), highest_(highest) {
  PS_ASSERT(gamma > 0 && highest >= 1 && highest <= 255, "a gamma above 0 and at most 8 bits");
  for (unsigned k = 0; k < highest; ++k) steps_.push_back(power((k + 0.5) / highest, gamma));
  steps_.push_back(std::numeric_limits<double>::infinity());
  unsigned level = 0;
  for (int i = 0; i < buckets; ++i) {
    while (static_cast<double>(i) / buckets >= steps_[level]) ++level;
    first_[static_cast<std::size_t>(i)] = static_cast<unsigned char>(level);
  }
}

const GammaCurve& gamma_curve(double gamma, unsigned highest) {
  // A list, so that a curve stays where it is while another is made: one picture uses up to two, two views four.
  constexpr std::size_t most_kept = 8;
  thread_local std::list<GammaCurve> kept;
  for (const GammaCurve& curve : kept)
    if (curve.gamma() == gamma && curve.highest() == highest) return curve;
  if (kept.size() == most_kept) kept.pop_back();
  kept.emplace_front(gamma, highest);
  return kept.front();
}

}  // namespace ps
