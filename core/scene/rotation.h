#pragma once
#include <optional>

#include "math/vec.h"

namespace ps {

enum class Axis { x, y, z };

/// Rotation about an axis, in the sense of the book's own programs: about y the rows are (c,0,-s), (0,1,0), (s,0,c).
/// The other two follow by exchanging the axes in a circle: about x the rows are (1,0,0), (0,c,s), (0,-s,c), about z
/// (c,s,0), (-s,c,0), (0,0,1).
Mat3d rotation_about(Axis axis, double degrees);

struct AxisAngle {
  Axis axis = Axis::y;
  double degrees = 0;  ///< from -180 to 180
};
/// The axis and angle for which rotation_about returns exactly this matrix, bit for bit; nullopt if there is none. The
/// identity is 0 degrees about y.
std::optional<AxisAngle> axis_angle_of(const Mat3d& rotation);

/// A matrix from its three rows.
Mat3d from_rows(const Vec3d& first, const Vec3d& second, const Vec3d& third);
/// Row 0, 1 or 2 of a matrix.
Vec3d row_of(const Mat3d& matrix, int row);

}  // namespace ps
