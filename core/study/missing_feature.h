#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "frame/view.h"
#include "study/control.h"
#include "study/missing_candidates.h"

namespace ps {

struct MissingRequest {
  Scene scene;
  View view;  ///< of the file's size
  Settings settings;
  Image<Rgb8> file;
  int most_changes = 3;  ///< that are tried together
  WorkerPriority priority = WorkerPriority::normal;
};

/// A's picture with some changes, against the file.
struct MissingMatch {
  std::vector<std::string> keys;   ///< of the candidates; empty: A as it is
  std::vector<std::string> words;  ///< "without highlights"
  std::int64_t pixels = 0;         ///< that both have
  std::int64_t equal = 0;          ///< of them, with the file's levels
  std::int64_t near = 0;           ///< of them, with levels at most one apart
  double mean = 0;                 ///< mean difference of a channel, in levels

  double equal_share() const { return pixels == 0 ? 0 : static_cast<double>(equal) / static_cast<double>(pixels); }
  double near_share() const { return pixels == 0 ? 0 : static_cast<double>(near) / static_cast<double>(pixels); }
};

struct MissingFeature {
  enum class Verdict {
    nothing_missing,  ///< A is the file, or within one level of it everywhere
    found,            ///< `best` makes the file
    unexplained,      ///< no change that was tried does; `best` comes nearest
  };
  Verdict verdict = Verdict::unexplained;
  MissingMatch as_is;                ///< A without a change
  MissingMatch best;                 ///< the nearest; A itself where no change comes nearer
  std::vector<MissingMatch> single;  ///< every change alone that makes a picture of its own, nearest first
  std::size_t candidates = 0;        ///< changes that were tried
  int renders = 0;
};

/// Searches for the changes of A that make a file's picture. Each candidate is rendered alone; the three nearest are
/// combined with all others, then the nearest pair. A change is added only if it explains at least a quarter of the
/// pixels that still differ. `found` asks for nine tenths of the differing pixels and 98 % of all, equal or at most one
/// level apart (as floats and doubles round). Throws InputError where the sizes differ, and Cancelled.
MissingFeature find_missing_feature(const MissingRequest& request, StudyControl& control,
                                    const std::function<void(const StudyStatus&)>& update = {});

/// The result in one or two sentences, with shares of pixels. `file` is how the picture is called: "your file".
std::string missing_sentence(const MissingFeature& found, std::string_view file = "your file");
/// "without highlights, with levels truncated, not rounded"; "as it is" without a change.
std::string missing_words(const MissingMatch& match);

}  // namespace ps
