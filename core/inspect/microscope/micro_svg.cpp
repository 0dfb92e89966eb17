#include "inspect/microscope/micro_svg.h"

#include <fmt/format.h>

#include "image/svg.h"
#include "record/value_text.h"

namespace ps {
namespace {

constexpr double page_margin = 24, pixel_size = 620, column = 110, names = 150, line_height = 20, texel_size = 210;
constexpr double text_left = page_margin + pixel_size + 28, page_width = text_left + names + 3 * column + page_margin,
                 page_height = pixel_size + 2 * page_margin + 24;

PaintArea square_at(const Vec2d& corner, double size) { return {corner, corner + size}; }

/// Writes the table and returns where it ends.
double draw_table(Painter& painter, const MicroTable& table, double y) {
  const auto right = [](std::size_t i) { return text_left + names + column * static_cast<double>(i + 1); };
  const TextLook number{.anchor = TextAnchor::end};
  for (std::size_t i = 0; i < table.columns.size(); ++i) painter.text({right(i), y}, table.columns[i], number);
  for (const MicroRow& row : table.rows) {
    y += line_height;
    painter.text({text_left, y}, row.name, {});
    for (std::size_t i = 0; i < row.values.size(); ++i) painter.text({right(i), y}, row.values[i], number);
  }
  return y + line_height;
}

/// Writes the words about a face, if it has some, and returns where they end.
double draw_face(Painter& painter, const std::optional<FaceData>& face, double y) {
  const std::string words = face ? face_words(*face) : std::string();
  if (words.empty()) return y;
  painter.text({text_left, y + line_height}, words, {});
  return y + line_height;
}

}  // namespace

std::string micro_svg(const Microscope& microscope, const MicroReading& reading, int selected) {
  const Vec2i pixel = microscope.pixel();
  const std::string title = fmt::format("Pixel ({}, {}) at panel size", pixel.x, pixel.y);
  SvgPainter svg(page_width, page_height, title);
  svg.text({page_margin, page_margin}, title, {.lettering = Lettering::strong});
  const MicroDrawing drawing = pixel_drawing(microscope, reading, selected);
  draw_micro(svg, drawing, square_at({page_margin, page_margin + 12}, pixel_size));
  double y = page_margin + 28;
  svg.text({text_left, y}, "At the point: " + reading.seen, {.lettering = Lettering::strong});
  y += line_height;
  svg.text({text_left, y}, fmt::format("sample point {} of the pixel", vector_text(reading.point)), {});
  y += line_height * 1.5;
  if (const int shown = shown_triangle(reading, selected); shown >= 0) {
    const MicroTriangle& triangle = reading.triangles[static_cast<std::size_t>(shown)];
    svg.text({text_left, y}, fmt::format("{}  {}", shown + 1, triangle.name), {.lettering = Lettering::strong_label});
    y = draw_face(svg, triangle.face, y);
    for (const MicroTable& table : triangle_tables(triangle)) y = draw_table(svg, table, y + line_height);
  }
  if (reading.ray) svg.text({text_left, y}, reading.ray->verdict, {}), y += line_height;
  if (reading.face) {
    y = draw_face(svg, reading.face->face, y);
    for (const MicroTable& table : face_tables(*reading.face)) y = draw_table(svg, table, y + line_height);
  }
  if (!reading.texture) return svg.finish();
  double x = text_left;
  for (const MicroTexels& level : reading.texture->levels) {
    if (x + texel_size > page_width) break;
    svg.text({x, y + line_height}, fmt::format("texture level {}", level.level), {});
    const MicroDrawing texels = texel_drawing(level);
    draw_micro(svg, texels, square_at({x, y + line_height + 8}, texel_size));
    x += texel_size + 16;
  }
  return svg.finish();
}

}  // namespace ps
