#include "inspect/microscope/micro_svg.h"

#include <fmt/format.h>

#include "image/svg.h"
#include "record/value_text.h"

namespace ps {
namespace {

constexpr double page_margin = 24, pixel_size = 620, column = 110, names = 150, line_height = 20, texel_size = 210;
constexpr double text_left = page_margin + pixel_size + 28, page_width = text_left + names + 3 * column + page_margin,
                 page_height = pixel_size + 2 * page_margin + 24;
constexpr std::string_view ink = "#181818", page_white = "#ffffff", quiet = "#808080", yellow = "#f0e442";

/// A drawing of the microscope put into a square of the page.
class SvgPanel {
 public:
  SvgPanel(SvgDrawing& svg, const MicroDrawing& drawing, const Vec2d& corner, double size)
      : svg_(svg), drawing_(drawing), corner_(corner), size_(size) {}

  void draw() {
    svg_.begin_clip(corner_, corner_ + Vec2d(size_));
    svg_.picture(corner_, corner_ + Vec2d(size_), drawing_.backdrop);
    for (const MicroItem& item : drawing_.items) draw_item(item);
    svg_.end_clip();
  }

 private:
  Vec2d place(const Vec2d& point) const {
    return corner_ + (point - drawing_.low) / (drawing_.high - drawing_.low) * size_;
  }

  void rimmed(const Vec2d& a, const Vec2d& b, double width, std::string_view dash = {}) {
    svg_.line(a, b, {page_white, width + 3, {}, {}, 0.85});
    svg_.line(a, b, {ink, width, dash});
  }

  void words(const Vec2d& at, const std::string& text) {
    const double width = 7.5 * static_cast<double>(text.size()) + 6;
    svg_.polygon(
        {at + Vec2d(-width / 2, -9), at + Vec2d(width / 2, -9), at + Vec2d(width / 2, 9), at + Vec2d(-width / 2, 9)},
        {{}, 0, {}, page_white, 0.85});
    svg_.text(at + Vec2d(0, 4.5), text, 13, SvgAnchor::middle);
  }

  void cross(const Vec2d& at, double arm) {
    for (const double width : {5.0, 2.0})
      for (const Vec2d& along : {Vec2d(1, 0), Vec2d(0, 1)})
        for (const double side : {-1.0, 1.0})
          svg_.line(at + along * (side * arm * 0.35), at + along * (side * arm), {width > 3 ? ink : yellow, width});
  }

  void draw_item(const MicroItem& item) {
    const Vec2d at = place(item.points.front());
    const double width = item.emphasised ? 3.2 : 1.6;
    std::vector<Vec2d> corners;
    for (const Vec2d& point : item.points) corners.push_back(place(point));
    switch (item.kind) {
    case MicroKind::grid:
      return svg_.line(at, corners[1], {quiet, 1, {}, {}, 0.35});
    case MicroKind::neighbour:
      return svg_.line(at, corners[1], {quiet, 1.4});
    case MicroKind::pixel:
      svg_.polygon(corners, {page_white, 5, {}, {}, 0.85});
      return svg_.polygon(corners, {ink, 2.4});
    case MicroKind::edge_owned:
      return rimmed(at, corners[1], width);
    case MicroKind::edge_not_owned:
      return rimmed(at, corners[1], width, "8 5");
    case MicroKind::owner_mark:
      svg_.line(at, corners[1], {page_white, width + 1.6, {}, {}, 0.85});
      return svg_.line(at, corners[1], {ink, width * 0.7});
    case MicroKind::corner:
      return svg_.polygon({at + Vec2d(-4, -4), at + Vec2d(4, -4), at + Vec2d(4, 4), at + Vec2d(-4, 4)},
                          {page_white, 1.5, {}, ink});
    case MicroKind::sample_lit:
      return svg_.circle(at, 7, {item.on_dark ? ink : page_white, 2, {}, item.on_dark ? page_white : ink});
    case MicroKind::sample_unlit:
      svg_.circle(at, 7, {item.on_dark ? ink : page_white, 5});
      return svg_.circle(at, 7, {item.on_dark ? page_white : ink, 2});
    case MicroKind::point:
      return cross(at, 14);
    case MicroKind::place:
      return cross(at, 9);
    case MicroKind::triangle_name:
      return words(at, item.label);
    case MicroKind::footprint:
      svg_.polygon(corners, {ink, 5, {}, {}, 0.6});
      return svg_.polygon(corners, {yellow, 2.2});
    case MicroKind::tap:
      if (item.shape == MicroShape::words) return words(at, item.label);
      svg_.polygon(corners, {page_white, 4.5, {}, {}, 0.85});
      return svg_.polygon(corners, {ink, 1.6});
    }
  }

  SvgDrawing& svg_;
  const MicroDrawing& drawing_;
  Vec2d corner_;
  double size_;
};

/// Writes the table and returns where it ends.
double draw_table(SvgDrawing& svg, const MicroTable& table, double y) {
  const auto right = [](std::size_t i) { return text_left + names + column * static_cast<double>(i + 1); };
  for (std::size_t i = 0; i < table.columns.size(); ++i) svg.text({right(i), y}, table.columns[i], 12, SvgAnchor::end);
  for (const MicroRow& row : table.rows) {
    y += line_height;
    svg.text({text_left, y}, row.name, 13);
    for (std::size_t i = 0; i < row.values.size(); ++i) svg.text({right(i), y}, row.values[i], 13, SvgAnchor::end);
  }
  return y + line_height;
}

}  // namespace

std::string micro_svg(const Microscope& microscope, const MicroReading& reading, int selected) {
  const Vec2i pixel = microscope.pixel();
  const std::string title = fmt::format("Pixel ({}, {}) at panel size", pixel.x, pixel.y);
  SvgDrawing svg(page_width, page_height, title);
  svg.text({page_margin, page_margin}, title, 17, SvgAnchor::start, true);
  const MicroDrawing drawing = pixel_drawing(microscope, reading, selected);
  SvgPanel(svg, drawing, {page_margin, page_margin + 12}, pixel_size).draw();
  double y = page_margin + 28;
  svg.text({text_left, y}, "At the point: " + reading.seen, 15, SvgAnchor::start, true);
  y += line_height;
  svg.text({text_left, y}, fmt::format("sample point {} of the pixel", vector_text(reading.point)), 13);
  y += line_height * 1.5;
  if (const int shown = shown_triangle(reading, selected); shown >= 0) {
    const MicroTriangle& triangle = reading.triangles[static_cast<std::size_t>(shown)];
    svg.text({text_left, y}, fmt::format("{}  {}", shown + 1, triangle.name), 14, SvgAnchor::start, true);
    for (const MicroTable& table : triangle_tables(triangle)) y = draw_table(svg, table, y + line_height);
  }
  if (reading.ray) svg.text({text_left, y}, reading.ray->verdict, 13), y += line_height;
  if (!reading.texture) return svg.finish();
  double x = text_left;
  for (const MicroTexels& level : reading.texture->levels) {
    if (x + texel_size > page_width) break;
    svg.text({x, y + line_height}, fmt::format("texture level {}", level.level), 13);
    const MicroDrawing texels = texel_drawing(level);
    SvgPanel(svg, texels, {x, y + line_height + 8}, texel_size).draw();
    x += texel_size + 16;
  }
  return svg.finish();
}

}  // namespace ps
