#pragma once
#include <algorithm>
#include <functional>
#include <span>

#include "raytrace/clear/triangle_watertight.h"
#include "study/stability/closed_sphere.h"
#include "study/stability/support.h"

namespace ps::stability {

/// A ray from the centre of a closed sphere to a point on it.
struct AimedRay {
  Vec3f origin, direction;
  Shear<float> shear;  ///< of the direction, for the watertight test
  std::span<const std::uint32_t>
      candidates;  ///< triangles of the mesh: all that can be met there, as the Aim keeps them
};

enum class AimAt {
  interior,  ///< evenly over a triangle
  edge,
  vertex
};

/// Rays that random directions would never find: three in a million go so near to an edge. They start in a cube of side
/// `side` around the centre.
class Aim {
 public:
  Aim(const ClosedSphere& mesh, std::uint32_t seed, double side);
  AimedRay next(AimAt what);

 private:
  AimedRay towards(const Vec3d& target, std::span<const std::uint32_t> candidates);
  std::span<const std::uint32_t> neighbours(std::size_t triangle) const {
    return std::span(neighbours_)
        .subspan(first_neighbour_[triangle], first_neighbour_[triangle + 1] - first_neighbour_[triangle]);
  }
  const ClosedSphere& mesh_;
  std::vector<std::vector<std::uint32_t>> around_;  ///< of each vertex: the triangles that have it
  std::vector<std::uint32_t> neighbours_;           ///< of each triangle in turn: those that share a vertex with it
  std::vector<std::size_t> first_neighbour_;        ///< of each triangle in `neighbours_`, and the end
  Random random_;
  double half_side_;
};

using TriangleHits = std::function<bool(const AimedRay&, const TracedTriangle<float>&)>;

struct CrackRates {
  double misses = 0, doubles = 0;  ///< per million rays
};

/// How often none, and how often more than one, of the triangles around is met by each test; all of them get the same
/// rays. The mesh has 101,760 triangles and radius 2; rays start in a cube of side 2 around its centre.
std::vector<CrackRates> crack_rates(AimAt what, const std::vector<TriangleHits>& tests, const StabilityRun& run);
/// Adds the series "`series`, misses" and "`series`, double hits".
void add_cracks(Rows& rows, double knob, const std::string& series, const CrackRates& naive, const CrackRates& robust);

/// The tests that several experiments use.
bool watertight_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);
template <class Real>
TriangleHits moeller_trumbore_hits(Real epsilon, Real tolerance);

}  // namespace ps::stability
