#pragma once
#include <functional>
#include <memory>

#include "raytrace/base/geometry.h"
#include "raytrace/base/ray.h"

namespace ps {

/// A triangle that Embree offers, with what its own arithmetic says: t, and the weights of vertices a, b and c.
struct EmbreeCandidate {
  std::uint32_t primitive = no_primitive;
  float t = 0;
  std::array<float, 3> weights{};
};

/// The scene's triangles in Intel's ray tracing kernels, as production renderers use them. Optional: see has_embree()
/// in base/machine.h. Embree decides with its own arithmetic which triangles a ray meets; it does not
/// report the nodes that it visits.
class EmbreeTriangles {
 public:
  /// Throws InputError if Embree cannot be used. Of several threads one builds at a time.
  explicit EmbreeTriangles(const TracedGeometry<float>& geometry);
  ~EmbreeTriangles();
  EmbreeTriangles(const EmbreeTriangles&) = delete;
  EmbreeTriangles& operator=(const EmbreeTriangles&) = delete;

  /// Calls visit(candidate) -> bool for triangles that the ray meets at t_min <= t <= `limit`. Where it returns true,
  /// what lies behind the candidate is no longer looked for (`any`: the search ends).
  template <class Visit>
  void for_each_candidate(const Ray<float>& ray, float limit, bool any, Visit&& visit) const {
    search(ray, limit, any, {&visit, [](void* data, const EmbreeCandidate& candidate) {
                               return (*static_cast<std::remove_reference_t<Visit>*>(data))(candidate);
                             }});
  }

  /// What Embree says that it allocated.
  std::size_t heap_bytes() const;

 private:
  struct Visitor {
    void* data;
    bool (*visit)(void* data, const EmbreeCandidate& candidate);
  };
  struct Content;
  struct Turns;
  struct LetGo {
    void operator()(Content* content) const;
  };
  void search(const Ray<float>& ray, float limit, bool any, const Visitor& visitor) const;
  std::unique_ptr<Content, LetGo> content_;
};

/// What rays search with accelerator = embree: the triangles there, everything else in a tree of boxes. Embree
/// computes in float, so that of double is never made.
template <class Real>
struct EmbreeGeometry {
  std::shared_ptr<const EmbreeTriangles> triangles;  ///< absent if the scene has none
  Bvh<Real> others;                                  ///< its order holds numbers of primitives

  std::size_t heap_bytes() const { return owned_bytes(triangles, others); }
};
std::shared_ptr<const EmbreeGeometry<float>> embree_geometry(const Scene& scene, const TracedGeometry<float>& geometry,
                                                             Prepared& prepared);

}  // namespace ps
