#pragma once
#include <span>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps {

/// Pictures in rows on one white sheet, each in the top left corner of its place; the places are as large as the
/// largest picture. Empty pictures leave their places white. Without any picture the sheet is empty.
Image<Rgb8> picture_sheet(std::span<const std::vector<Image<Rgb8>>> rows);

}  // namespace ps
