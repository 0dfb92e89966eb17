#include "study/picture_sheet.h"

#include <algorithm>

namespace ps {
namespace {

constexpr int sheet_gap = 6;  // pixels between places

void put(const Image<Rgb8>& picture, int left, int top, Image<Rgb8>& sheet) {
  for (int y = 0; y < picture.height(); ++y) {
    const auto from = picture.row(y);
    std::copy(from.begin(), from.end(), sheet.row(top + y).begin() + left);
  }
}

}  // namespace

Image<Rgb8> picture_sheet(std::span<const std::vector<Image<Rgb8>>> rows) {
  int width = 0, height = 0, columns = 0;
  for (const auto& row : rows) {
    columns = std::max(columns, static_cast<int>(row.size()));
    for (const Image<Rgb8>& picture : row) {
      width = std::max(width, picture.width());
      height = std::max(height, picture.height());
    }
  }
  if (width == 0) return {};
  const int count = static_cast<int>(rows.size());
  Image<Rgb8> sheet(columns * (width + sheet_gap) - sheet_gap, count * (height + sheet_gap) - sheet_gap,
                    Rgb8{255, 255, 255});
  for (int y = 0; y < count; ++y)
    for (std::size_t x = 0; x < rows[static_cast<std::size_t>(y)].size(); ++x)
      put(rows[static_cast<std::size_t>(y)][x], static_cast<int>(x) * (width + sheet_gap), y * (height + sheet_gap),
          sheet);
  return sheet;
}

}  // namespace ps
