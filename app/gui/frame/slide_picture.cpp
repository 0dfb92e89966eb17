#include "gui/frame/slide_picture.h"

#include <algorithm>
#include <vector>

#include "gui/theme/picture_letters.h"

namespace ps::gui {
namespace {

constexpr int times = 2;                    // larger than the picture
constexpr int slide_margin = 40, gap = 12;  // pixels
constexpr int least_em = 24, most_em = 48, ems_in_width = 26;
constexpr int least_width = 420;  // of a column, for the words

void put_enlarged(const Image<Rgb8>& picture, Vec2i at, Image<Rgb8>& on) {
  for (int y = 0; y < times * picture.height(); ++y)
    for (int x = 0; x < times * picture.width(); ++x) on.at(at.x + x, at.y + y) = picture.at(x / times, y / times);
}

int height_of(const std::vector<std::string>& lines, const PictureLetters& letters) {
  return static_cast<int>(lines.size()) * letters.line_height();
}

void put_lines(const std::vector<std::string>& lines, const PictureLetters& letters, Vec2i at, Image<Rgb8>& on) {
  for (const std::string& line : lines) {
    letters.draw(on, at, line);
    at.y += letters.line_height();
  }
}

}  // namespace

Image<Rgb8> slide_picture(std::span<const SlidePart> parts) {
  int width = least_width, height = 0;
  for (const SlidePart& part : parts) {
    width = std::max(width, times * part.picture->width());
    height = std::max(height, times * part.picture->height());
  }
  const int em = std::clamp(width / ems_in_width, least_em, most_em);
  const PictureLetters bold(PictureLetters::Weight::bold, em), regular(PictureLetters::Weight::regular, em * 3 / 4);
  std::vector<std::vector<std::string>> titles, captions;
  int above = 0, below = 0;
  for (const SlidePart& part : parts) {
    titles.push_back(bold.lines(part.title, width));
    captions.push_back(regular.lines(part.caption, width));
    above = std::max(above, height_of(titles.back(), bold) + gap);
    below = std::max(below, height_of(captions.back(), regular) + gap);
  }
  const int count = static_cast<int>(parts.size());
  Image<Rgb8> slide(count * (width + slide_margin) + slide_margin, 2 * slide_margin + above + height + below,
                    Rgb8{255, 255, 255});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int left = slide_margin + static_cast<int>(i) * (width + slide_margin), top = slide_margin + above;
    put_lines(titles[i], bold, {left, top - gap - height_of(titles[i], bold)}, slide);
    put_enlarged(*parts[i].picture, {left, top}, slide);
    put_lines(captions[i], regular, {left, top + times * parts[i].picture->height() + gap}, slide);
  }
  return slide;
}

}  // namespace ps::gui
