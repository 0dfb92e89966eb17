#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/check.h"
#include "engine/figure_number.h"
#include "engine/maths.h"
#include "image/painter.h"
#include "record/story.h"

/// Figures of lessons: lines, dots and labels in a plane of their own, x to the right and y up. chapters/README.md
/// describes how they are written. The window, the presenter and the handout draw the same marks.

namespace ps {

enum class LineTip { plain, arrow };

/// An open line through two places or more.
struct FigureLine {
  std::vector<Vec2d> places;
  Stroke stroke{.tint = {}, .width = 1.5};
  LineTip tip = LineTip::plain;
};

/// The inside of a convex polygon.
struct FigureArea {
  std::vector<Vec2d> corners;
  Tint fill;
};

/// A point, as a small disc.
struct FigureDot {
  Vec2d at{0, 0};
  Tint tint = {};
};

/// Words or a formula beside a place.
struct FigureLabel {
  Vec2d at{0, 0};
  Vec2d side{0, 0};   ///< where the label lies from its place, -1 to 1 along each axis; (0, 0): on it
  std::string words;  ///< of a label without a formula
  MathsRow formula;   ///< of one with: its words are part of it
  Tint tint = {};
};

using FigureMark = std::variant<FigureLine, FigureArea, FigureDot, FigureLabel>;

/// The lines of a `figure` block, and where they are in the lesson.
struct FigureSource {
  std::string text, file;
  int first_line = 1;
};

struct Figure {
  std::string description;  ///< in words, for those who do not see it
  std::vector<FigureMark> marks;
  std::vector<FigureNumber> of_pixel = {};  ///< the numbers of the picked pixel that it draws; others have none
  FigureSource source = {};                 ///< of those, to be read again for another pixel
  std::string note = {};                    ///< of those, written below: which pixel it is drawn for
};

/// Reads the lines of a `figure` block; `first_line` is the first one's number in `file`. Numbers of a pixel are those
/// of the story, which must have them all, or without one those that the lesson gives for the step's own pixel. Throws
/// InputError with file, line and column.
Figure read_figure(std::string_view text, const std::string& file, int first_line, const PixelStory* story = nullptr);

/// The figure for the pixel of this story. Where its numbers are missing or cannot be drawn, it is the one for the
/// step's own pixel, and its note says so; so it is as long as there is no story. Other figures stay as they are.
std::shared_ptr<const Figure> figure_of_pixel(const std::shared_ptr<const Figure>& figure, const PixelStory* story);

/// The description, and the pixel it is drawn for.
std::string figure_words(const Figure& figure);

/// A label, with formulas between dollar signs. `start` is the place of its first byte. Throws InputError.
FigureLabel read_label(std::string_view text, const SourcePlace& start);

/// The size of a figure in a column of this width: as wide as it is and as high as it needs, in the painter's pixels.
double figure_height(const Painter& painter, const Figure& figure, double width);

/// Draws a figure into a column of this width whose upper left corner is `corner`.
void draw_figure(Painter& painter, const Figure& figure, const Vec2d& corner, double width);

/// As Scalable Vector Graphics, with its description for screen readers.
std::string figure_svg(const Figure& figure);

}  // namespace ps
