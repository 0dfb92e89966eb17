#pragma once
#include <algorithm>
#include <vector>

#include "raytrace/clear/intersector.h"
#include "raytrace/clear/medium.h"
#include "raytrace/clear/surface_point.h"

namespace ps {

/// What an eye ray begins in: of each body that may hold its start, the ray meets the surface from the inside first, or
/// it does not begin in it. Bodies that it leaves later lie around those that it leaves earlier.
template <class Real>
class EyeMedia {
 public:
  EyeMedia(const TraceInputs<Real>& inputs, const Ray<Real>& ray) {
    if (inputs.eye_bodies.empty()) return;
    find(inputs, ray);
    chain_.resize(left_.size());
    for (std::size_t i = 0; i < left_.size(); ++i)
      chain_[i] = {left_[i].index, i + 1 < left_.size() ? &chain_[i + 1] : &outside_};
  }
  EyeMedia(const EyeMedia&) = delete;
  EyeMedia& operator=(const EyeMedia&) = delete;

  const Medium<Real>& innermost() const { return chain_.empty() ? outside_ : chain_[0]; }
  /// From the innermost to the outermost.
  std::vector<MediumAtEye> events() const {
    std::vector<MediumAtEye> found;
    for (const Left& body : left_) found.push_back({body.object, static_cast<double>(body.index)});
    return found;
  }

 private:
  /// A body that the ray leaves at `t`.
  struct Left {
    Real t = 0;
    std::int32_t object = -1;
    Real index = 1;
  };

  void find(const TraceInputs<Real>& inputs, const Ray<Real>& ray) {
    Silent silent;
    const Intersector<Real, Silent> intersector(inputs, silent);
    const auto note = [&](const Hit<Real>& hit, std::int32_t object) {
      if (!hit.found()) return;
      const SurfacePoint<Real> surface = surface_of(ray, hit, inputs);
      const ShadingMaterial<Real>& material = inputs.materials[surface.material];
      if (surface.back_face && material.transparency > 0) left_.push_back({hit.t, object, material.refraction_index});
    };
    bool meshes = false;
    for (const EyeBody& body : inputs.eye_bodies) {
      if (body.primitive) note(intersector.one(ray, *body.primitive), body.object);
      meshes = meshes || !body.primitive;
    }
    if (meshes) walk_to_meshes(inputs, intersector, ray, note);
    std::sort(left_.begin(), left_.end(),
              [](const Left& a, const Left& b) { return a.t != b.t ? a.t < b.t : a.object > b.object; });
  }

  /// The first triangle of each mesh among the bodies, by the accelerator: from surface to surface along the ray.
  template <class Note>
  static void walk_to_meshes(const TraceInputs<Real>& inputs, const Intersector<Real, Silent>& intersector,
                             Ray<Real> ray, Note&& note) {
    constexpr int most_surfaces = 256;
    std::vector<std::int32_t> wanted;
    for (const EyeBody& body : inputs.eye_bodies)
      if (!body.primitive) wanted.push_back(body.object);
    for (int i = 0; i < most_surfaces && !wanted.empty(); ++i) {
      const Hit<Real> hit = intersector.nearest(ray);
      if (!hit.found()) return;
      const std::int32_t object = primitive_of(*inputs.geometry, hit.primitive).id.object;
      if (const auto at = std::find(wanted.begin(), wanted.end(), object); at != wanted.end()) {
        note(hit, object);
        wanted.erase(at);
      }
      ray.t_min = hit.t;
    }
  }

  Medium<Real> outside_{};
  std::vector<Left> left_;  ///< from the innermost to the outermost; nearly always there are none
  std::vector<Medium<Real>> chain_;
};

}  // namespace ps
