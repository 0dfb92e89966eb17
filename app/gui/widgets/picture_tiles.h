#pragma once
#include <imgui.h>

#include <functional>
#include <string>

#include "gui/platform/texture.h"

namespace ps::gui {

/// A picture over a title: something that can be opened.
struct PictureTile {
  std::string name;  ///< of the control
  std::string title;
  std::string note;     ///< a line below the title; empty = none
  bool ticked = false;  ///< a tick in front of the note
  std::string tooltip;
  /// Asked for while the tile is in sight: the picture, at most so large in pixels; nullptr while it is being made.
  std::function<const Texture*(int width, int height)> picture;
};

struct TileLook {
  int lines = 2;        ///< of small print below each picture
  bool reveal = false;  ///< scrolls to the selected tile though no key has moved the selection
};

/// Tiles in rows as long as the present window is wide. One of them is selected, by number; the arrow keys move the
/// selection.
class PictureTiles {
 public:
  /// `count`: of all tiles that follow.
  PictureTiles(int& selected, std::size_t count, const TileLook& look);
  /// A line over the tiles that follow.
  void heading(const std::string& text);
  /// The next tile. Answers whether it was clicked.
  bool tile(const PictureTile& tile);

 private:
  const TileLook look_;
  bool reveal_ = false;
  int selected_ = 0, columns_ = 1, column_ = 0, number_ = 0;
};

/// The picture at the centre of a place: shrunk to it, or enlarged by the largest whole factor that fits.
void draw_tile_picture(ImDrawList& list, const Texture& picture, ImVec2 min, ImVec2 max);

/// Largest size of the pictures on tiles, pixels.
int tile_picture_size();

}  // namespace ps::gui
