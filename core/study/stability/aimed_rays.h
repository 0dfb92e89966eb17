#pragma once
#include <algorithm>
#include <functional>

#include "study/stability/closed_sphere.h"
#include "study/stability/support.h"

namespace ps::stability {

/// A ray from the middle of a closed sphere to a place on it.
struct AimedRay {
  Vec3f origin, direction;
  std::vector<std::uint32_t> candidates;  ///< all triangles that touch that place's corners
};

enum class AimAt {
  interior,  ///< evenly over a triangle
  edge,
  vertex
};

/// Rays that random directions would never find: three in a million go so near to an edge. They start in a cube of side
/// 2 `reach` in the middle.
class Aim {
 public:
  Aim(const ClosedSphere& mesh, std::uint32_t seed, double reach = 1);
  AimedRay next(AimAt what);

 private:
  AimedRay towards(const Vec3d& target, std::initializer_list<std::uint32_t> vertices);
  const ClosedSphere& mesh_;
  std::vector<std::vector<std::uint32_t>> around_;
  Random random_;
  double reach_;
};

using TriangleHits = std::function<bool(const AimedRay&, const TracedTriangle<float>&)>;

struct CrackRates {
  double misses = 0, doubles = 0;  ///< per million rays
};

/// How often none, and how often more than one, of the triangles around is met by each test; all of them get the same
/// rays. The mesh is the one of 101,760 triangles with radius 2.
std::vector<CrackRates> crack_rates(AimAt what, const std::vector<TriangleHits>& tests, const StabilityRun& run,
                                    double reach = 1);
/// Adds the series "`series`, misses" and "`series`, double hits".
void add_cracks(Rows& rows, double knob, const std::string& series, const CrackRates& naive, const CrackRates& robust);

/// The tests that several experiments use.
bool watertight_hits(const AimedRay& ray, const TracedTriangle<float>& triangle);
template <class Real>
TriangleHits moeller_trumbore_hits(Real epsilon, Real tolerance);

}  // namespace ps::stability
