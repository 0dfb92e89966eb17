#pragma once
#include <span>
#include <vector>

namespace ps {

/// What is given for what: both smaller is better.
struct Tradeoff {
  double cost = 0;
  double error = 0;
};

/// For each point whether it lies on the Pareto front: no other point is at least as good in both and better in one.
/// Of equal points all lie on it or none. A point with a NaN is never on the front. O(n log n).
std::vector<bool> pareto_front(std::span<const Tradeoff> points);

}  // namespace ps
