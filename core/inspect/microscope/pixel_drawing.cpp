#include <algorithm>
#include <cmath>

#include "inspect/microscope/drawing.h"
#include "inspect/microscope/window_clip.h"
#include "options/renderer_kind.h"

namespace ps {
namespace {

constexpr int most_subpixel_lines = 16;  // in a pixel
constexpr double mark_length = 0.04;     // of an owner's mark, in pixels
constexpr double mark_spacing = 0.055;
constexpr double name_room = 0.12;  // that a name leaves around the centre of the pixel

const ClipWindow shown_part{Vec2d(-micro_margin), Vec2d(1 + micro_margin)};

void add_line(MicroDrawing& drawing, MicroKind kind, const Vec2d& from, const Vec2d& to) {
  if (const auto part = clip_segment(from, to, shown_part))
    drawing.items.push_back({kind, MicroShape::line, {(*part)[0], (*part)[1]}});
}

/// Lines across the pixel at whole multiples of `step`, `first` to `last` of them.
void add_cross_lines(MicroDrawing& drawing, MicroKind kind, double at) {
  add_line(drawing, kind, {at, -micro_margin}, {at, 1 + micro_margin});
  add_line(drawing, kind, {-micro_margin, at}, {1 + micro_margin, at});
}

void add_grids(MicroDrawing& drawing, int subpixel_bits) {
  const int lines = 1 << std::min(subpixel_bits, 4);
  static_assert(most_subpixel_lines == 1 << 4);
  for (int i = -lines / 4; i <= lines + lines / 4; ++i)
    if (i != 0 && i != lines) add_cross_lines(drawing, MicroKind::grid, static_cast<double>(i) / lines);
}

/// Marks along an owned edge that point to the side of its triangle.
void add_owner_marks(MicroDrawing& drawing, const std::array<Vec2d, 2>& part, const Vec2d& inside, int triangle,
                     bool emphasised) {
  const Vec2d along = part[1] - part[0];
  const double length = std::sqrt(dot(along, along));
  if (length < mark_spacing) return;
  Vec2d across = Vec2d(-along.y, along.x) / length;
  if (dot(across, inside - part[0]) < 0) across = -across;
  for (double at = mark_spacing / 2; at < length; at += mark_spacing) {
    const Vec2d foot = part[0] + along * (at / length);
    if (const auto mark = clip_segment(foot, foot + across * mark_length, shown_part))
      drawing.items.push_back(
          {MicroKind::owner_mark, MicroShape::line, {(*mark)[0], (*mark)[1]}, {}, triangle, emphasised});
  }
}

void add_triangle(MicroDrawing& drawing, const MicroTriangle& triangle, int index, bool emphasised) {
  for (std::size_t i = 0; i < 3; ++i) {  // edge i lies opposite vertex i
    const auto part = clip_segment(triangle.corners[(i + 1) % 3], triangle.corners[(i + 2) % 3], shown_part);
    if (!part) continue;
    const MicroKind kind = triangle.owns[i] ? MicroKind::edge_owned : MicroKind::edge_not_owned;
    drawing.items.push_back({kind, MicroShape::line, {(*part)[0], (*part)[1]}, {}, index, emphasised});
  }
  for (const Vec2d& corner : triangle.corners)
    if (clip_segment(corner, corner, shown_part))
      drawing.items.push_back({MicroKind::corner, MicroShape::dot, {corner}, {}, index, emphasised});
}

/// The marks of all edges lie over the edges, since neighbours share those.
void add_owners(MicroDrawing& drawing, const MicroTriangle& triangle, int index, bool emphasised) {
  const Vec2d middle = (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
  for (std::size_t i = 0; i < 3; ++i)
    if (triangle.owns[i])
      if (const auto part = clip_segment(triangle.corners[(i + 1) % 3], triangle.corners[(i + 2) % 3], shown_part))
        add_owner_marks(drawing, *part, middle, index, emphasised);
}

void add_name(MicroDrawing& drawing, const MicroTriangle& triangle, int index, bool emphasised) {
  const auto part = clip_polygon({triangle.corners.begin(), triangle.corners.end()}, shown_part);
  if (part.size() < 3) return;
  Vec2d middle(0);
  for (const Vec2d& corner : part) middle += corner / static_cast<double>(part.size());
  if (std::abs(middle.x - 0.5) < name_room && std::abs(middle.y - 0.5) < name_room)
    middle -= Vec2d(1.5 * name_room);  // the sample lies there
  drawing.items.push_back(
      {MicroKind::triangle_name, MicroShape::words, {middle}, std::to_string(index + 1), index, emphasised});
}

/// Whether black ink could hardly be seen on the backdrop there. Weights of ITU-R BT.709.
bool is_dark(const MicroDrawing& drawing, const Vec2d& point) {
  const Image<Rgb8>& picture = drawing.backdrop;
  if (picture.empty()) return false;
  const Vec2d share = (point - drawing.low) / (drawing.high - drawing.low);
  const auto index = [](double part, int size) {
    return static_cast<int>(std::clamp(part * size, 0.0, static_cast<double>(size - 1)));
  };
  const Rgb8 level = picture.at(index(share.x, picture.width()), index(share.y, picture.height()));
  return 0.2126 * level.r + 0.7152 * level.g + 0.0722 * level.b < 110;
}

}  // namespace

MicroDrawing pixel_drawing(const Microscope& microscope, const MicroReading& reading, int selected) {
  MicroDrawing drawing;
  drawing.low = shown_part.low;
  drawing.high = shown_part.high;
  drawing.backdrop = microscope.enlarged();
  const Settings& settings = microscope.settings();
  if (draws_fragments(settings.renderer)) add_grids(drawing, settings.subpixel_bits);
  for (const double border : {0.0, 1.0}) add_cross_lines(drawing, MicroKind::neighbour, border);
  drawing.items.push_back({MicroKind::pixel, MicroShape::outline, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const int chosen = shown_triangle(reading, selected);
  const int count = static_cast<int>(reading.triangles.size());
  const auto triangle = [&](int i) -> const MicroTriangle& { return reading.triangles[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < count; ++i)
    if (i != chosen) add_triangle(drawing, triangle(i), i, false);
  if (chosen >= 0) add_triangle(drawing, triangle(chosen), chosen, true);
  for (int i = 0; i < count; ++i) add_owners(drawing, triangle(i), i, i == chosen);
  for (int i = 0; i < count; ++i)
    if (i != chosen) add_name(drawing, triangle(i), i, false);
  if (chosen >= 0) add_name(drawing, triangle(chosen), chosen, true);
  for (const MicroSample& sample : microscope.samples()) {
    drawing.items.push_back(
        {sample.lit ? MicroKind::sample_lit : MicroKind::sample_unlit, MicroShape::dot, {sample.position}});
    drawing.items.back().on_dark = is_dark(drawing, sample.position);
  }
  drawing.items.push_back({MicroKind::point, MicroShape::dot, {reading.point}});
  return drawing;
}

}  // namespace ps
