// The listings of what is drawn on the canvas in a rasterizer's events.
#include <cmath>

#include "textbook/report_parts.h"

namespace ps::textbook {
namespace {

class CanvasReporter {
 public:
  CanvasReporter(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder)
      : book_(book), items_(lines_and_triangles(*book.scene.canvas_items)), reader_(reader), recorder_(recorder),
        colour_(book.background / 255.0) {}

  void report() {
    for (const int pixel : reader_.all("pixel"))
      if (const int line = reader_.around(pixel, "line from"); line >= 0)
        report_line(line, pixel);
      else if (reader_.last<Vec2d>(pixel, "outline at"))
        report_outline(pixel);
      else
        report_filled(pixel);
  }

 private:
  Vec2d from_top_left(const Vec2d& p) const {
    const int middle = book_.width / 2, centre_row = book_.height - book_.height / 2;
    return {p.x + middle, centre_row - p.y};
  }

  void report_line(int line, int pixel) {
    const Vec2d from = std::get<Vec2d>(reader_.value_of(line));
    const CanvasLine* drawn = nullptr;
    for (const CanvasItem& item : items_)
      if (const auto* one = std::get_if<CanvasLine>(&item);
          one && one->points[0] == from && one->points[1] == reader_.last<Vec2d>(line, "to").value_or(one->points[1]))
        drawn = one;
    if (!drawn) return;
    if (drawn->blend != Blend::replace) return report_write(drawn->colour, pixel);
    colour_ = drawn->colour;
    recorder_.event([&] {
      return LineEvent{{}, from_top_left(drawn->points[0]), from_top_left(drawn->points[1]), 0, colour_};
    });
  }

  const CanvasTriangle* triangle_of(int pixel) const {
    const int triangle = reader_.around(pixel, "triangle with vertex");
    if (triangle < 0) return nullptr;
    const CanvasTriangle* found = nullptr;
    for (const CanvasItem& item : items_)
      if (const auto* one = std::get_if<CanvasTriangle>(&item);
          one && (one->points[0] == std::get<Vec2d>(reader_.value_of(triangle)) ||
                  Vec2d(std::trunc(one->points[0].x), std::trunc(one->points[0].y)) ==
                      std::get<Vec2d>(reader_.value_of(triangle))))
        found = one;
    return found;
  }

  /// The listing does not say which of the three edges it is: it is reported as the first.
  void report_outline(int pixel) {
    const CanvasTriangle* triangle = triangle_of(pixel);
    if (!triangle || !triangle->outline) return;
    colour_ = *triangle->outline;
    recorder_.event([&] {
      return LineEvent{{}, from_top_left(triangle->points[0]), from_top_left(triangle->points[1]), 0, colour_};
    });
  }

  void report_filled(int pixel) {
    const CanvasTriangle* triangle = triangle_of(pixel);
    if (!triangle) return report_of_polygon(pixel);
    FragmentEvent event;
    for (std::size_t k = 0; k < 3; ++k)
      event.corners[k] = from_top_left({std::trunc(triangle->points[k].x), std::trunc(triangle->points[k].y)});
    if (reader_.last<bool>(pixel, "covered") == false) return;
    const Vec3d colour = reader_.last<Vec3d>(pixel, "colour").value_or(triangle->colours[0] * 255.0);
    recorder_.begin([&] { return event; });
    report_write(colour / 255.0, pixel);
    recorder_.end();
  }

  /// A polygon that is filled as a whole, or the pixel's own levels in place of its light.
  void report_of_polygon(int pixel) {
    if (const auto shown = reader_.last<Vec3d>(pixel, "light of these levels"))
      return report_write(*shown / 255.0, pixel);
    if (reader_.around(pixel, "polygon with pixel") < 0) return;
    report_write(reader_.last<Vec3d>(pixel, "colour").value_or(Vec3d(0)) / 255.0, pixel);
  }

  /// A shape's colour meets what the canvas has.
  void report_write(const Vec3d& colour, int pixel) {
    const auto becomes = reader_.last<Vec3d>(pixel, "canvas becomes");
    const Vec3d after = becomes ? *becomes / 255.0 : colour;
    recorder_.event([&] { return WriteEvent{{}, colour_, colour, after}; });
    colour_ = after;
  }

  const BookScene& book_;
  const std::vector<CanvasItem> items_;  // as the listings draw them, without polygons
  const WatchReader& reader_;
  PixelRecorder& recorder_;
  Vec3d colour_;  // of the pixel so far
};

}  // namespace

void report_canvas_items(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder) {
  CanvasReporter(book, reader, recorder).report();
}

}  // namespace ps::textbook
