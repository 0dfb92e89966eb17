#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/counters.h"
#include "raster/base/edge_function.h"
#include "record/events.h"

namespace ps::raster {

/// A triangle, or a piece of one that was cut, ready for coverage.
template <class Real>
struct ScreenTriangle {
  std::array<FixedPoint, 3> corners{};
  TileRect box;                     ///< samples that it may cover, inside the picture
  std::array<Real, 3> z{};          ///< camera-space z of the vertices
  std::array<Real, 3> inverse_z{};  ///< 1 / z
  Real sort_depth = 0;              ///< mean z of the whole triangle, for the painter
  Vec3<Real> face_normal{0, 0, 0};  ///< world space, length 1
  std::uint32_t surface = 0;        ///< index into RasterInputs::surfaces
  std::uint32_t attributes = 0;     ///< index of the first scalar in Batch::attributes, vertex after vertex
  std::uint32_t sequence = 0;       ///< number of the whole triangle in drawing order
  std::int32_t triangle = 0;        ///< number of the whole triangle in its object
  std::uint8_t pieces = 1;          ///< number of pieces that clipping made of the whole triangle
  bool cut = false;                 ///< a piece: its vertices' weights in the whole triangle follow its attributes
  bool back_face = false;
};

/// A line to be walked: an edge of a wireframe, or a vertex drawn as a point (both ends equal).
template <class Real>
struct ScreenLine {
  Vec2<Real> from{0, 0}, to{0, 0};  ///< centred canvas coordinates, y up (lines/walk_line.h)
  TileRect box;                     ///< pixels that it may touch, inside the picture
  Real sort_depth = 0;
  std::uint32_t surface = 0;
  std::uint32_t sequence = 0;
  std::int32_t triangle = 0;
};

/// A triangle that will draw nothing although its place on the canvas is near the inspected pixel.
struct RejectedTriangle {
  std::uint32_t sequence = 0;
  RejectEvent event;
};

/// What became of a run of triangles, in order.
template <class Real>
struct Batch {
  std::vector<ScreenTriangle<Real>> triangles;
  std::vector<ScreenLine<Real>> lines;
  std::vector<Real> attributes;
  Counters counters;
  std::vector<RejectedTriangle> rejected;  ///< only while a pixel is inspected
  std::uint64_t elsewhere = 0;             ///< rejected far from the inspected pixel
};

enum class PrimitiveShape : std::uint8_t { triangle, line };

/// Names a triangle or a line: number `index` of those of batch `batch`.
struct PrimitiveRef {
  std::uint32_t batch = 0;
  std::uint32_t index = 0;
  PrimitiveShape shape = PrimitiveShape::triangle;
  bool is_line() const { return shape == PrimitiveShape::line; }
};

}  // namespace ps::raster
