#pragma once
#include <string>
#include <vector>

#include "image/painter.h"
#include "inspect/microscope/microscope.h"

namespace ps {

/// The microscope's pictures as lists of primitives, for the window and for files alike.

/// What a primitive represents; the painter decides how it looks.
enum class MicroKind {
  grid,            ///< line of the sub-pixel grid, or between texels
  neighbour,       ///< border of a pixel beside this one
  pixel,           ///< the pixel's own border
  edge_owned,      ///< edge of a triangle to which the fill rule gives the points on it
  edge_not_owned,  ///< the same for an edge whose points belong to the other side
  owner_mark,      ///< short line from an owned edge into its triangle
  corner,          ///< where a triangle's vertex was rounded to
  sample_lit,
  sample_unlit,
  point,          ///< the movable sample point
  triangle_name,  ///< number of a triangle, at the centre of its part of the picture
  footprint,      ///< the pixel's outline on a texture
  tap,            ///< a texel that was read, with its weight
  place           ///< where a texture was read
};

enum class MicroShape { line, outline, dot, words };

struct MicroItem {
  MicroKind kind = MicroKind::grid;
  MicroShape shape = MicroShape::line;
  std::vector<Vec2d> points;  ///< inside the drawing's rectangle, except those of outlines
  std::string label = {};     ///< words, or a tap's weight
  int triangle = -1;          ///< index into MicroReading::triangles; -1 = none
  bool emphasised = false;    ///< belongs to the triangle that is looked at
  bool on_dark = false;       ///< of samples: the backdrop is dark there, so that they are drawn light
};

struct MicroDrawing {
  Vec2d low{0, 0}, high{1, 1};   ///< what is shown
  Image<Rgb8> backdrop;          ///< fills the rectangle
  std::vector<MicroItem> items;  ///< later ones lie over earlier ones
};

/// The pixel with its margin: what lies in it, triangle edges, samples, and the sample point of `reading`. `selected`
/// is an index into its triangles, or -1.
MicroDrawing pixel_drawing(const Microscope& microscope, const MicroReading& reading, int selected);

/// Texels around a lookup, with the pixel's footprint and what was read, in texels from the texture's top left.
MicroDrawing texel_drawing(const MicroTexels& texels);

/// The place of a point of a drawing that fills `area`, and the point at a place.
Vec2d micro_place(const MicroDrawing& drawing, const PaintArea& area, const Vec2d& point);
Vec2d micro_point(const MicroDrawing& drawing, const PaintArea& area, const Vec2d& place);

/// Draws the items over their backdrop.
void draw_micro(Painter& painter, const MicroDrawing& drawing, const PaintArea& area);

/// A line of numbers beside the drawing.
struct MicroRow {
  std::string name;
  std::vector<std::string> values;  ///< one for each column
  std::vector<std::string> exact;   ///< the same with all digits
};

/// Rows under the headings of their columns.
struct MicroTable {
  std::vector<std::string> columns;
  std::vector<MicroRow> rows;
};

/// What the kernel computes for a triangle at the sample point. First what each vertex has: edge values with who owns
/// ties, weights on the screen and in space. Then depth and texture coordinates by both kinds of weights, and the depth
/// that the depth buffer compares. For a triangle of a model, what its vertices carry, as face_tables() has it.
std::vector<MicroTable> triangle_tables(const MicroTriangle& triangle);

/// Normals in world space and texture coordinates of the vertices, and those of the point; empty where there are
/// none.
std::vector<MicroTable> face_tables(const FacePoint& point);

/// The triangle whose numbers are shown: `selected` where there is such a one, else the one in front, else the first;
/// -1 if there is none.
int shown_triangle(const MicroReading& reading, int selected);

}  // namespace ps
