#pragma once
#include <string>
#include <vector>

#include "study/chart.h"

namespace ps {

/// An order between two points that a sentence states. Points by ChartPoint::number.
struct ChartClaim {
  enum class Kind {
    cheaper,     ///< `first` costs less than `second`
    more_exact,  ///< `first` has the better error
  };
  Kind kind{};
  int first = 0, second = 0;
};

/// What a chart shows, in one sentence, and every order that the sentence states.
struct ChartConclusion {
  std::string sentence;  ///< empty while nothing is measured
  std::vector<ChartClaim> claims;
};

/// States no order of cost unless surely_cheaper() holds, and no order of errors unless surely_more_exact() does
/// (study/chart_front.h). A chart that lacks points begins with "So far".
ChartConclusion chart_conclusion(const Chart& chart);

}  // namespace ps
