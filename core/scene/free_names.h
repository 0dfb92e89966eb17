#pragma once
#include <map>
#include <set>
#include <string>

namespace ps {

/// Hands out names that are still free: the wanted one itself, else "wanted 2", "wanted 3", ...
class FreeNames {
 public:
  void take(const std::string& name) { taken_.insert(name); }
  std::string claim(const std::string& wanted) {
    if (taken_.insert(wanted).second) return wanted;
    for (int& number = next_[wanted];; ++number) {
      std::string name = wanted + " " + std::to_string(number + 2);
      if (taken_.insert(name).second) return name;
    }
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> next_;
};

}  // namespace ps
