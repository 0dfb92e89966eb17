#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "math/vec.h"

namespace ps {

/// A text to be written beside a mark. All in the same unit, y down.
struct LabelWish {
  Vec2d mark{0, 0};
  Vec2d size{0, 0};  ///< of the text
  int rank = 0;      ///< lower ranks choose first
  Vec2d bar{0, 0};   ///< how far an error bar reaches to the left (x) and to the right (y) of the mark
};

struct LabelPlace {
  bool shown = false;  ///< false: there was no free place
  Vec2d corner{0, 0};  ///< top left of the text
};

using LabelLine = std::pair<Vec2d, Vec2d>;

/// Finds for each label a place near its mark where it covers no mark, no error bar and no other label and stays inside
/// the box from (0, 0) to `box`; where there is a choice it crosses none of the lines either. No two lines from marks
/// to their labels cross, and none runs through another label. `radius` is that of the largest mark.
std::vector<LabelPlace> place_labels(const std::vector<LabelWish>& wishes, const Vec2d& box, double radius,
                                     const std::vector<LabelLine>& lines = {});

/// The line from a mark's rim to its label, if that is so far away that it could be another's.
std::optional<LabelLine> label_leader(const LabelWish& wish, const LabelPlace& place, double radius);

}  // namespace ps
