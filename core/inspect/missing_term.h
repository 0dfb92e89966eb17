#pragma once
#include <array>
#include <string>
#include <vector>

#include "image/display.h"
#include "record/story.h"

namespace ps {

/// A row of the sum in the levels of the pixel as it is displayed.
struct TermRow {
  std::size_t line = 0;        ///< index into PixelStory::ledger
  std::array<int, 3> adds{};   ///< levels that the pixel loses without the row
  std::array<int, 3> again{};  ///< levels that it gains if the row counts twice
};

/// The rows of a pixel's sum beside the pixel of another picture.
struct MissingTerm {
  enum class Change {
    none,
    left_out,
    counted_twice,
    unmixed  ///< the local colour counts whole, as without reflections
  };
  std::array<int, 3> difference{};  ///< the other picture minus this one, in levels of 255
  std::vector<TermRow> rows;        ///< rows that add light, in the order of the sum
  Change change = Change::none;
  std::vector<std::size_t> named;  ///< one or two of the rows (indices into the ledger) that explain the difference
  std::string sentence;  ///< "Red is 102 levels too dark: that is the highlight of light 1, 103."; never empty
};

/// Finds the row, or the two rows together, whose removal or doubling makes `other` of the pixel, to one level of each
/// channel; or the row of a local colour that counts whole, as without reflections. Of rows that do so equally well the
/// one furthest down in the sum is named: it says most.
MissingTerm find_missing_term(const PixelStory& story, const DisplayTransform& display, Rgb8 other);

}  // namespace ps
