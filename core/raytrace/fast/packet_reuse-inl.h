// Subsampling (CGFS ch. 5) for packets: which sphere a pixel is tested against. Vector form of sampling/subsample.h.
#if defined(PIXELSCOPE_PACKET_REUSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PIXELSCOPE_PACKET_REUSE_INL_H_
#undef PIXELSCOPE_PACKET_REUSE_INL_H_
#else
#define PIXELSCOPE_PACKET_REUSE_INL_H_
#endif

#include <algorithm>
#include <vector>

#include "raytrace/fast/packet_search-inl.h"
#include "raytrace/sampling/plan.h"
#include "raytrace/sampling/subsample_marks.h"

HWY_BEFORE_NAMESPACE();
namespace ps::HWY_NAMESPACE {

/// The searched pixels of a tile, and for any row what the pixels between them are tested against.
class PacketReuse {
 public:
  /// What a pixel of the row is tested against: a sphere, nothing (-1), or every_sphere.
  struct Row {
    HWY_ALIGN float only[traced_tile_size + HWY_MAX_BYTES / 4];
    HWY_ALIGN float searched[traced_tile_size + HWY_MAX_BYTES / 4];  ///< 1: what it meets is known by a search
  };

  /// `search(columns, row, found)` finds the spheres that the pixels of these columns see.
  template <class SearchRow>
  PacketReuse(const TileRect& tile, int step, SearchRow&& search)
      : x0_(tile.x0), columns_(subsample_marks(tile.x0, tile.x1, step)), rows_(subsample_marks(tile.y0, tile.y1, step)),
        found_(columns_.size() * rows_.size()) {
    for (std::size_t y = 0; y < rows_.size(); ++y) search(columns_, rows_[y], &found_[y * columns_.size()]);
  }

  void fill(int row, Row& result) const {
    const auto y1 = static_cast<std::size_t>(std::lower_bound(rows_.begin(), rows_.end(), row) - rows_.begin());
    const bool searched_row = rows_[y1] == row;
    const float* const above = &found_[(searched_row ? y1 : y1 - 1) * columns_.size()];
    const float* const below = &found_[y1 * columns_.size()];
    for (std::size_t x = 0; x < columns_.size(); ++x) {
      const auto place = [&](int column) { return static_cast<std::size_t>(column - x0_); };
      const float here = above[x] == below[x] ? above[x] : every_sphere;
      result.only[place(columns_[x])] = here;
      result.searched[place(columns_[x])] = searched_row ? 1.0f : 0.0f;
      if (x + 1 == columns_.size()) break;
      const float next = above[x + 1] == below[x + 1] ? above[x + 1] : every_sphere;
      for (std::size_t i = place(columns_[x]) + 1; i < place(columns_[x + 1]); ++i) {
        result.only[i] = here == next ? here : every_sphere;
        result.searched[i] = 0;
      }
    }
  }

 private:
  int x0_;
  std::vector<int> columns_, rows_;
  std::vector<float> found_;
};

}  // namespace ps::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
