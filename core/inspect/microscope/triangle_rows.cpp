#include "inspect/microscope/drawing.h"
#include "inspect/number_text.h"

namespace ps {
namespace {

MicroRow numbers(std::string name, std::initializer_list<double> values) {
  MicroRow row{std::move(name), {}, {}};
  for (const double value : values) {
    row.values.push_back(number_text(value));
    row.exact.push_back(exact_number_text(value));
  }
  return row;
}

MicroRow numbers(std::string name, const std::array<double, 3>& values) {
  return numbers(std::move(name), {values[0], values[1], values[2]});
}

}  // namespace

std::vector<MicroRow> triangle_rows(const MicroTriangle& triangle) {
  std::vector<MicroRow> rows{numbers("edge value, px²", triangle.edges)};
  MicroRow owner{"edge owns ties", {}, {}};
  for (std::size_t i = 0; i < 3; ++i)
    owner.values.push_back(std::string(triangle.owns[i] ? "yes" : "no") + (triangle.ties[i] ? ", tie" : ""));
  owner.exact = owner.values;
  rows.push_back(std::move(owner));
  rows.push_back(numbers("weight on screen", triangle.weights_2d));
  if (triangle.on_canvas) return rows;
  rows.push_back(numbers("weight in space", triangle.weights));
  rows.push_back(numbers("z: screen, space", {triangle.z_2d, triangle.z}));
  if (triangle.uv) {
    rows.push_back(numbers("u: screen, space", {triangle.uv_2d->x, triangle.uv->x}));
    rows.push_back(numbers("v: screen, space", {triangle.uv_2d->y, triangle.uv->y}));
  }
  return rows;
}

int shown_triangle(const MicroReading& reading, int selected) {
  if (selected >= 0 && static_cast<std::size_t>(selected) < reading.triangles.size()) return selected;
  if (reading.front >= 0) return reading.front;
  return reading.triangles.empty() ? -1 : 0;
}

}  // namespace ps
