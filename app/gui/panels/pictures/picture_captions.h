#pragma once

namespace ps::gui {

/// The lines above and below a picture: all of them, or one line each where the picture needs the height, or in letters
/// that are read from the last row.
enum class PictureCaptions { full, brief, projected };

/// How a picture that is not zoomed fills its place: with pixels of one size where that loses little, or wholly.
enum class PictureFit { even_pixels, whole_place };

}  // namespace ps::gui
