#pragma once
#include <vector>

#include "image/image.h"
#include "study/stability/support.h"

namespace ps::stability {

/// Who is seen where, to compare fragments with exact rays. Pixels beside an outline are left out: fragments round
/// vertices to sub-pixels, so an outline may pass a sample on the other side.
using Owners = Image<std::int32_t>;
constexpr std::int32_t background_owner = -1;

/// Calls visit(x, y) for each pixel that has the same owner in `truth` as its eight neighbours.
template <class Visit>
void for_inner_pixels(const Owners& truth, Visit&& visit) {
  for (int y = 1; y + 1 < truth.height(); ++y)
    for (int x = 1; x + 1 < truth.width(); ++x) {
      bool inner = true;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) inner = inner && truth.at(x + dx, y + dy) == truth.at(x, y);
      if (inner) visit(x, y);
    }
}

/// The percentage of the inner pixels of `truth` that `shown` gives to another owner.
inline double wrong_owners(const Owners& truth, const Owners& shown) {
  double all = 0, wrong = 0;
  for_inner_pixels(truth, [&](int x, int y) {
    ++all;
    wrong += shown.at(x, y) != truth.at(x, y) ? 1 : 0;
  });
  return percent(wrong, all);
}

/// The owners of a picture's pixels, made from their object and triangle by owner(id); the background stays.
template <class OwnerOf>
Owners owners_of(const Image<PixelId>& ids, OwnerOf&& owner) {
  Owners owners(ids.width(), ids.height(), background_owner);
  for (std::size_t i = 0; i < ids.pixels().size(); ++i)
    if (ids.pixels()[i].object >= 0) owners.pixels()[i] = owner(ids.pixels()[i]);
  return owners;
}

}  // namespace ps::stability
