#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "textbook/trace_listing.h"

namespace ps::textbook {

/// Finds what a listing had by the names on its lines. The trace must outlive it.
class WatchReader {
 public:
  explicit WatchReader(const ListingTrace& trace)
      : trace_(trace), below_(trace.instances.size() + 1), watches_(trace.instances.size() + 1) {
    for (std::size_t i = 0; i < trace.instances.size(); ++i)
      below_[slot(trace.instances[i].parent)].push_back(static_cast<int>(i));
    for (const Watch& watch : trace.watches) watches_[slot(watch.instance)].push_back(&watch);
  }

  std::string_view name_of(int instance) const { return trace_.instances[static_cast<std::size_t>(instance)].name; }
  const WatchValue& value_of(int instance) const { return trace_.instances[static_cast<std::size_t>(instance)].value; }
  int parent_of(int instance) const { return trace_.instances[static_cast<std::size_t>(instance)].parent; }
  /// The instances right inside `instance` (-1: inside none), in order.
  const std::vector<int>& below(int instance) const { return below_[slot(instance)]; }
  /// Those of them that the listing calls `name`.
  std::vector<int> below(int instance, std::string_view name) const {
    std::vector<int> found;
    for (const int inner : below(instance))
      if (name_of(inner) == name) found.push_back(inner);
    return found;
  }
  /// All instances of that name, in the order in which they began.
  std::vector<int> all(std::string_view name) const {
    std::vector<int> found;
    for (std::size_t i = 0; i < trace_.instances.size(); ++i)
      if (trace_.instances[i].name == name) found.push_back(static_cast<int>(i));
    return found;
  }
  /// The nearest instance of that name around `instance`, -1 if there is none.
  int around(int instance, std::string_view name) const {
    while (instance >= 0 && name_of(instance) != name) instance = parent_of(instance);
    return instance;
  }
  /// The last value of that name right inside the instance, if it is a T.
  template <class T>
  std::optional<T> last(int instance, std::string_view name) const {
    std::optional<T> found;
    for (const Watch* watch : watches_[slot(instance)])
      if (watch->name == name && std::holds_alternative<T>(watch->value)) found = std::get<T>(watch->value);
    return found;
  }
  const std::vector<const Watch*>& watches(int instance) const { return watches_[slot(instance)]; }

 private:
  std::size_t slot(int instance) const {
    return instance < 0 ? trace_.instances.size() : static_cast<std::size_t>(instance);
  }
  const ListingTrace& trace_;
  std::vector<std::vector<int>> below_;
  std::vector<std::vector<const Watch*>> watches_;
};

}  // namespace ps::textbook
