#include "gui/theme/picture_letters.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include "base/resources.h"

namespace ps::gui {

struct PictureLetters::Font {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  Font(const std::string& path, int em) {
    if (FT_Init_FreeType(&library) != 0) return;
    if (FT_New_Face(library, path.c_str(), 0, &face) == 0) FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(em));
  }
  ~Font() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Calls visit(glyph, left) for each letter, and gives the width of all.
  template <class Visit>
  int each_letter(std::string_view text, FT_Int32 flags, Visit visit) const {
    int left = 0;
    for (std::size_t i = 0; face && i < text.size();) {
      auto code = static_cast<unsigned char>(text[i++]);
      FT_ULong letter = code;
      int more = code >= 0xF0 ? 3 : code >= 0xE0 ? 2 : code >= 0xC0 ? 1 : 0;
      if (more > 0) letter &= 0x3Fu >> more;
      for (; more > 0 && i < text.size(); --more)
        letter = letter << 6 | (static_cast<unsigned char>(text[i++]) & 0x3Fu);
      if (FT_Load_Char(face, letter, flags) != 0) continue;
      visit(*face->glyph, left);
      left += static_cast<int>(face->glyph->advance.x >> 6);
    }
    return left;
  }
};

PictureLetters::PictureLetters(Weight weight, int em)
    : font_(std::make_unique<Font>(
          font_file(weight == Weight::bold ? "Inter-SemiBold.otf" : "Inter-Regular.otf").string(), em)),
      em_(em) {}

PictureLetters::~PictureLetters() = default;

int PictureLetters::width(std::string_view text) const {
  return font_->each_letter(text, FT_LOAD_DEFAULT, [](const FT_GlyphSlotRec_&, int) {});
}

std::vector<std::string> PictureLetters::lines(std::string_view text, int width) const {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!lines.empty() && this->width(lines.back() + " " + word) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

void PictureLetters::draw(Image<Rgb8>& on, Vec2i at, std::string_view text) const {
  font_->each_letter(text, FT_LOAD_RENDER, [&](const FT_GlyphSlotRec_& glyph, int left) {
    const FT_Bitmap& ink = glyph.bitmap;
    for (unsigned row = 0; row < ink.rows; ++row)
      for (unsigned column = 0; column < ink.width; ++column) {
        const int x = at.x + left + glyph.bitmap_left + static_cast<int>(column);
        const int y = at.y + em_ - glyph.bitmap_top + static_cast<int>(row);
        if (!on.contains(x, y)) continue;
        const int paper = 255 - ink.buffer[static_cast<int>(row) * ink.pitch + static_cast<int>(column)];
        const auto shade = [&](std::uint8_t level) { return static_cast<std::uint8_t>(level * paper / 255); };
        Rgb8& pixel = on.at(x, y);
        pixel = {shade(pixel.r), shade(pixel.g), shade(pixel.b)};
      }
  });
}

}  // namespace ps::gui
