#include <array>
#include <span>

#include <fmt/format.h>

#include "inspect/microscope/drawing.h"
#include "record/value_text.h"

namespace ps {
namespace {

MicroRow numbers(std::string name, std::span<const double> values) {
  MicroRow row{std::move(name), number_row(values), {}};
  for (const double value : values) row.exact.push_back(exact_number_text(value));
  return row;
}

MicroRow numbers(std::string name, double on_screen, double in_space) {
  return numbers(std::move(name), std::array{on_screen, in_space});
}

}  // namespace

std::vector<MicroTable> triangle_tables(const MicroTriangle& triangle) {
  MicroTable corners{{"vertex 0", "vertex 1", "vertex 2"}, {numbers("edge value, px²", triangle.edges)}};
  MicroRow owner{"owns samples on its edge", {}, {}};
  for (std::size_t i = 0; i < 3; ++i)
    owner.values.push_back(std::string(triangle.owns[i] ? "yes" : "no") + (triangle.ties[i] ? ", tie" : ""));
  owner.exact = owner.values;
  corners.rows.push_back(std::move(owner));
  corners.rows.push_back(numbers("weight on screen", triangle.weights_2d));
  if (triangle.on_canvas) return {corners};
  corners.rows.push_back(numbers("weight in space", triangle.weights));
  MicroTable there{{"by screen", "by space"}, {numbers("z", triangle.z_2d, triangle.z)}};
  if (triangle.uv) {
    there.rows.push_back(numbers("u", triangle.uv_2d->x, triangle.uv->x));
    there.rows.push_back(numbers("v", triangle.uv_2d->y, triangle.uv->y));
  }
  std::vector<MicroTable> tables{corners, there};
  if (triangle.depth) {
    const std::array<double, 1> compared{*triangle.depth};
    tables.push_back({{"as compared"}, {numbers("depth", compared)}});
  }
  if (triangle.face)
    for (MicroTable& table : face_tables({*triangle.face, triangle.weights})) tables.push_back(std::move(table));
  return tables;
}

std::vector<MicroTable> face_tables(const FacePoint& point) {
  MicroTable vertices{{"vertex 0", "vertex 1", "vertex 2"}, {}}, there{{"at the point"}, {}};
  const auto& [first, second, third] = point.face.corners;
  const auto add = [&](std::string name, const std::optional<double>& a, const std::optional<double>& b,
                       const std::optional<double>& c, const std::optional<double>& at_point) {
    if (a && b && c) vertices.rows.push_back(numbers(name, std::array{*a, *b, *c}));
    if (at_point) there.rows.push_back(numbers(std::move(name), std::array{*at_point}));
  };
  const auto part = [](const auto& vector, int axis) {
    return vector ? std::optional<double>((*vector)[axis]) : std::nullopt;
  };
  const auto normal = normal_at(point);
  for (int axis = 0; axis < 3; ++axis)
    add(fmt::format("normal {}", "xyz"[axis]), part(first.normal, axis), part(second.normal, axis),
        part(third.normal, axis), part(normal, axis));
  const auto uv = uv_at(point);
  for (int axis = 0; axis < 2; ++axis)
    add(axis == 0 ? "u" : "v", part(first.uv, axis), part(second.uv, axis), part(third.uv, axis), part(uv, axis));
  std::vector<MicroTable> tables;
  for (MicroTable* table : {&vertices, &there})
    if (!table->rows.empty()) tables.push_back(std::move(*table));
  return tables;
}

int shown_triangle(const MicroReading& reading, int selected) {
  if (selected >= 0 && static_cast<std::size_t>(selected) < reading.triangles.size()) return selected;
  if (reading.front >= 0) return reading.front;
  return reading.triangles.empty() ? -1 : 0;
}

}  // namespace ps
