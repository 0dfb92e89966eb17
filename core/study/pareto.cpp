#include "study/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ps {

std::vector<bool> pareto_front(std::span<const Tradeoff> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isnan(points[i].cost) && !std::isnan(points[i].error)) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (points[a].cost != points[b].cost) return points[a].cost < points[b].cost;
    return points[a].error < points[b].error;
  });
  std::vector<bool> on_front(points.size(), false);
  // Walking to larger costs, only an error below all errors before can be on the front.
  double least_cheaper = std::numeric_limits<double>::infinity();
  bool any = false;
  for (std::size_t i = 0; i < order.size();) {
    const Tradeoff& best = points[order[i]];
    const bool better = !any || best.error < least_cheaper;
    std::size_t k = i;
    for (; k < order.size() && points[order[k]].cost == best.cost; ++k)
      on_front[order[k]] = better && points[order[k]].error == best.error;
    if (better) least_cheaper = best.error;
    any = true;
    i = k;
  }
  return on_front;
}

}  // namespace ps
