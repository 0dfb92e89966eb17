#pragma once
#include <map>
#include <memory>
#include <string>

#include "gui/platform/texture.h"
#include "study/needs.h"

namespace ps::gui {

/// The advice in words.
struct NeedsAdvice {
  std::string verdict;  ///< one sentence
  std::string words;    ///< "Shadows: none, Reflection depth: 1"; empty = keep the settings
  std::string changes;  ///< the same as keys: "shadows=none, reflection-depth=1"
  std::string saving;   ///< what work is, and how much is left of it
  std::string time;     ///< whether the time fell too
};
NeedsAdvice needs_advice(const Needs& needs, const Settings& base);

/// Small pictures as the graphics card has them, by the name of the feature that they lack; "" = with all of them.
struct NeedsThumbnails {
  struct One {
    std::shared_ptr<const Image<Rgb8>> of;  ///< what the texture was made from
    Texture texture;
  };
  std::map<std::string, One, std::less<>> pictures;
};

/// Bars of each feature's share, beside the picture without it. Times are known at the end only (`timed`).
void needs_shares(const Needs& needs, bool timed, NeedsThumbnails& thumbnails);
/// Every step of the search; those that were taken are marked.
void needs_trail(const Needs& needs);

}  // namespace ps::gui
