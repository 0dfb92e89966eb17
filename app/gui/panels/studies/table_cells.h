#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gui/platform/texture.h"
#include "gui/theme/theme.h"

namespace ps::gui {

// Cells of the tables in which studies show what can be saved.

/// A number with a bar of that share of the cell, and a line at `limit` if there is one.
void bar_cell(std::string_view name, double share, const std::string& text, std::optional<double> limit = {});
/// One line over the width of the cell, cut where it is too long.
void cell_line(std::string_view text, const ImVec4& colour, Face face = Face::body);
/// In the next column, with a tooltip.
void column_heading(const char* text, const char* help);
/// In the next column; the whole text is a tooltip where it is cut.
void name_cell(std::string_view text);
/// "12.5 %"
std::string percent(double share);
/// The width of the digits of bar_cell(), at scale 1.
inline constexpr double cell_digits_width = 72;

/// Small pictures as the graphics card has them, by their names.
class SmallPictures {
 public:
  /// The picture as a texture that is made once.
  const Texture& texture(std::string_view name, const std::shared_ptr<const Image<Rgb8>>& picture);

 private:
  struct One {
    std::shared_ptr<const Image<Rgb8>> of;  ///< what the texture was made from
    Texture texture;
  };
  std::map<std::string, One, std::less<>> pictures_;
};
/// Of a cell with a thumbnail of this picture.
float thumbnail_width(const std::shared_ptr<const Image<Rgb8>>& picture);
/// In the next column, larger while the mouse is over it; without a picture the cell stays empty.
void thumbnail_cell(SmallPictures& thumbnails, std::string_view name,
                    const std::shared_ptr<const Image<Rgb8>>& picture);

}  // namespace ps::gui
