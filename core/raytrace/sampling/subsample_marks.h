#pragma once
#include <vector>

namespace ps {

/// Columns or rows begin .. end - 1 of a tile that subsampling searches: every `step`-th and the last.
inline std::vector<int> subsample_marks(int begin, int end, int step) {
  std::vector<int> at;
  for (int i = begin; i < end; i += step) at.push_back(i);
  if (at.back() != end - 1) at.push_back(end - 1);
  return at;
}

}  // namespace ps
