#pragma once
#include <algorithm>

namespace ps::hardware {

/// The entry of a store, a map whose entries have a number `used` that grows, that was not used for the longest time.
template <class Entries>
auto least_recent(Entries& entries) {
  return std::min_element(entries.begin(), entries.end(),
                          [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
}

}  // namespace ps::hardware
