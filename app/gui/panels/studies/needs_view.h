#pragma once
#include <span>
#include <string>

#include "gui/panels/studies/table_cells.h"
#include "study/needs.h"

namespace ps::gui {

/// The advice in words.
struct NeedsAdvice {
  std::string verdict;  ///< one sentence
  std::string words;    ///< "shadows: none, reflection depth 1"; empty = keep the settings
  std::string changes;  ///< the same as keys: "shadows=none, reflection-depth=1"
  std::string saving;   ///< what work is, and how much is left of it
  std::string time;     ///< whether the time fell too
};
NeedsAdvice needs_advice(const Needs& needs, const Settings& base);

/// Bars of each feature's share, beside the picture without it. Times are known at the end only (`timed`).
void needs_shares(const Needs& needs, bool timed, SmallPictures& thumbnails);
/// The features that are not used, and why, in one sentence.
void unused_features(std::span<const FeatureShare> shares);
/// Every step of the search; those that were taken are marked.
void needs_trail(const Needs& needs);

}  // namespace ps::gui
