#pragma once
#include <span>
#include <string>

#include "image/image.h"

namespace ps::gui {

/// A picture on a slide, with its words.
struct SlidePart {
  std::string title, caption;
  const Image<Rgb8>* picture = nullptr;  ///< not empty
};

/// The pictures side by side on white, each pixel as a square of 2 x 2, a title above and a caption below each; words
/// are broken into lines and never cut.
Image<Rgb8> slide_picture(std::span<const SlidePart> parts);

}  // namespace ps::gui
