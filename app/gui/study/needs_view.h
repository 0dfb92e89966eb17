#pragma once
#include <string>

#include "study/needs.h"

namespace ps::gui {

/// The advice in words.
struct NeedsAdvice {
  std::string verdict;  ///< one sentence
  std::string changes;  ///< "shadows=none, reflection-depth=1"; empty = keep the settings
  std::string saving;   ///< what it saves and what it costs
};
NeedsAdvice needs_advice(const Needs& needs, const Settings& base);

/// Bars of each feature's share. Times are known at the end only (`timed`).
void needs_shares(const Needs& needs, bool timed);
/// Every step of the search; those that were taken are marked.
void needs_trail(const Needs& needs);

}  // namespace ps::gui
