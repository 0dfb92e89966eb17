#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/vec.h"

namespace ps::gui {

/// Letters of the window's typeface in a picture for a file, black, of any size. Without the font's file no letter
/// is drawn.
class PictureLetters {
 public:
  enum class Weight { regular, bold };
  /// `em` in pixels.
  PictureLetters(Weight weight, int em);
  ~PictureLetters();
  PictureLetters(const PictureLetters&) = delete;
  PictureLetters& operator=(const PictureLetters&) = delete;

  /// From one line to the next, in pixels.
  int line_height() const { return em_ * 5 / 4; }
  int width(std::string_view text) const;
  /// The text in lines of at most this width, broken at blanks; a longer word sticks out.
  std::vector<std::string> lines(std::string_view text, int width) const;
  /// One line from its upper left corner; what is outside of the picture is dropped.
  void draw(Image<Rgb8>& on, Vec2i at, std::string_view text) const;

 private:
  struct Font;
  std::unique_ptr<Font> font_;
  int em_;
};

}  // namespace ps::gui
