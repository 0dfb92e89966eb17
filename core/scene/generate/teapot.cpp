#include "scene/generate/teapot.h"

namespace ps {
namespace {

/// A point of a profile that is turned around the z axis.
struct ProfilePoint {
  double radius, height;
  double arc;  ///< second coordinate of the inner control points of a quarter circle of that radius
};

/// Newell makes quarter circles from control points at 0.56 times the radius, except for the lid's knob.
ProfilePoint at(double radius, double height) { return {radius, height, 0.56 * radius}; }

using Profile = std::array<ProfilePoint, 4>;

/// The four quarters of a turned profile, each starting where the one before ends: clockwise seen from above, as
/// published for everything but the bottom, which goes the other way (sense = -1) and so faces down.
void add_turned(std::vector<BezierPatch>& patches, const Profile& profile, double sense) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    BezierPatch patch;
    for (std::size_t row = 0; row < 4; ++row) {
      const auto [radius, height, arc] = profile[row];
      std::array<Vec2d, 4> columns{Vec2d{radius, 0}, {radius, -arc}, {arc, -radius}, {0, -radius}};
      for (std::size_t column = 0; column < 4; ++column) {
        Vec2d point = columns[column];
        for (int turn = 0; turn < quarter; ++turn) point = {point.y, -point.x};
        // Adding zero turns -0 into 0, so that equal points are equal bits.
        patch.control[4 * row + column] = {point.x + 0.0, sense * point.y + 0.0, height};
      }
    }
    patches.push_back(patch);
  }
}

/// Four rows of one half of handle or spout; the columns are (start, bulge, bulge, end), of which the published data
/// gives x and z, and how far the bulge reaches to the side (y).
struct HalfRow {
  Vec2d first, last;  ///< x and z of columns 0 and 1, and of columns 2 and 3
  double side;
};

/// The half at negative y, then its mirror image, whose columns run the other way round.
void add_mirrored(std::vector<BezierPatch>& patches, const std::array<HalfRow, 4>& rows) {
  for (const double mirror : {-1.0, 1.0}) {
    BezierPatch patch;
    for (std::size_t row = 0; row < 4; ++row) {
      const HalfRow& half = rows[row];
      const Vec2d start = mirror < 0 ? half.first : half.last;
      const Vec2d end = mirror < 0 ? half.last : half.first;
      patch.control[4 * row] = {start.x, 0, start.y};
      patch.control[4 * row + 1] = {start.x, mirror * half.side, start.y};
      patch.control[4 * row + 2] = {end.x, mirror * half.side, end.y};
      patch.control[4 * row + 3] = {end.x, 0, end.y};
    }
    patches.push_back(patch);
  }
}

}  // namespace

std::vector<BezierPatch> teapot_patches(TeapotBottom bottom) {
  std::vector<BezierPatch> patches;
  // Rim and body.
  add_turned(patches, {at(1.4, 2.4), at(1.3375, 2.53125), at(1.4375, 2.53125), at(1.5, 2.4)}, 1);
  add_turned(patches, {at(1.5, 2.4), at(1.75, 1.875), at(2, 1.35), at(2, 0.9)}, 1);
  add_turned(patches, {at(2, 0.9), at(2, 0.45), at(1.5, 0.225), at(1.5, 0.15)}, 1);
  // Handle.
  add_mirrored(patches, {HalfRow{{-1.6, 2.025}, {-1.5, 2.25}, 0.3},
                         {{-2.3, 2.025}, {-2.5, 2.25}, 0.3},
                         {{-2.7, 2.025}, {-3, 2.25}, 0.3},
                         {{-2.7, 1.8}, {-3, 1.8}, 0.3}});
  add_mirrored(patches, {HalfRow{{-2.7, 1.8}, {-3, 1.8}, 0.3},
                         {{-2.7, 1.575}, {-3, 1.35}, 0.3},
                         {{-2.5, 1.125}, {-2.65, 0.9375}, 0.3},
                         {{-2, 0.9}, {-1.9, 0.6}, 0.3}});
  // Spout.
  add_mirrored(patches, {HalfRow{{1.7, 1.425}, {1.7, 0.6}, 0.66},
                         {{2.6, 1.425}, {3.1, 0.825}, 0.66},
                         {{2.3, 2.1}, {2.4, 2.025}, 0.25},
                         {{2.7, 2.4}, {3.3, 2.4}, 0.25}});
  add_mirrored(patches, {HalfRow{{2.7, 2.4}, {3.3, 2.4}, 0.25},
                         {{2.8, 2.475}, {3.525, 2.49375}, 0.25},
                         {{2.9, 2.475}, {3.45, 2.5125}, 0.15},
                         {{2.8, 2.4}, {3.2, 2.4}, 0.15}});
  // Lid: knob and cover.
  add_turned(patches, {at(0, 3.15), ProfilePoint{0.8, 3.15, 0.45}, at(0, 2.85), at(0.2, 2.7)}, 1);
  add_turned(patches, {at(0.2, 2.7), at(0.4, 2.55), at(1.3, 2.55), at(1.3, 2.4)}, 1);
  if (bottom == TeapotBottom::closed) add_turned(patches, {at(0, 0), at(1.425, 0), at(1.5, 0.075), at(1.5, 0.15)}, -1);
  return patches;
}

Mesh make_teapot(const TeapotOptions& options) {
  Mesh mesh = tessellate(teapot_patches(options.bottom), options.divisions);
  mesh.name = "teapot";
  mesh.patches = teapot_patches(options.bottom);
  return mesh;
}

}  // namespace ps
