#pragma once
#include <string>

#include "study/needs.h"

namespace ps::gui {

/// The advice in words.
struct NeedsAdvice {
  std::string verdict;  ///< one sentence
  std::string changes;  ///< "shadows=none, reflection-depth=1"; empty = keep the settings
  std::string saving;   ///< what work is, and how much is left of it
  std::string time;     ///< whether the time fell too
};
NeedsAdvice needs_advice(const Needs& needs, const Settings& base);

/// Whether the fraction of the time is larger than noise.
bool needs_time_shown(const FeatureShare& share);

/// Bars of each feature's share. Times are known at the end only (`timed`).
void needs_shares(const Needs& needs, bool timed);
/// Every step of the search; those that were taken are marked.
void needs_trail(const Needs& needs);

}  // namespace ps::gui
