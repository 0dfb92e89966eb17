#include "raster/setup/place_mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

#include "math/unit.h"

namespace ps::raster {

double largest_stretch(const Mat3d& matrix) {
  const Mat3d square = glm::transpose(matrix) * matrix;
  double bound = 0;
  for (int column = 0; column < 3; ++column)
    bound = std::max(bound, std::abs(square[column][0]) + std::abs(square[column][1]) + std::abs(square[column][2]));
  return std::sqrt(bound);
}

TessellationView seen_from_within(const PartPlace& place, const TessellationView& view) {
  const Mat3d back = inverse(place.linear);
  const double most = largest_stretch(place.linear), least = 1 / largest_stretch(back);
  TessellationView own = view;
  own.eye = back * (view.eye - place.translation);
  own.forward = unit_of(back * view.forward);
  // A length along the surface grows by at most `most`, and the distance to the eye by at least `least`.
  own.pixels_per_unit *= view.projection == Projection::perspective ? most / least : most;
  own.nearest /= most;
  return own;
}

void place_mesh(const PartPlace& place, Mesh& mesh) {
  const Mat3d normals = transpose(inverse(place.linear));
  for (Vec3d& p : mesh.positions) p = place.linear * p + place.translation;
  for (Vec3d& n : mesh.normals) n = unit_of(normals * n);
  if (determinant(place.linear) > 0) return;
  for (MeshTriangle& triangle : mesh.triangles) {
    std::swap(triangle.position[1], triangle.position[2]);
    std::swap(triangle.normal[1], triangle.normal[2]);
    std::swap(triangle.uv[1], triangle.uv[2]);
  }
}

}  // namespace ps::raster
