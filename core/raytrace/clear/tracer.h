#pragma once
#include <optional>
#include <span>
#include <vector>

#include "image/texture_sampling.h"
#include "raytrace/base/eye_ray.h"
#include "raytrace/clear/eye_media.h"
#include "raytrace/clear/intersector.h"
#include "raytrace/clear/medium.h"
#include "raytrace/clear/surface_point.h"

namespace ps {

/// What one eye ray found.
template <class Real>
struct TracedPixel {
  Vec3<Real> colour{0};
  Ray<Real> ray;
  Hit<Real> hit;               ///< of the eye ray; not found() = background
  SurfacePoint<Real> surface;  ///< only if hit
  std::uint32_t shadow_mask = 0;
};

/// The ray tracer of CGFS ch. 2-4: for one pixel, the light that its ray brings back.
template <class Real, class Recorder>
class Tracer {
 public:
  /// Rays are searched for by the clear path.
  Tracer(const TraceInputs<Real>& inputs, Recorder& recorder)
      : inputs_(inputs), recorder_(recorder), intersector_(inputs, recorder), search_(intersector_) {}
  /// Rays are searched for by `search`, which counts its own work.
  Tracer(const TraceInputs<Real>& inputs, Recorder& recorder, const RaySearch<Real>& search)
      : inputs_(inputs), recorder_(recorder), intersector_(inputs, recorder), search_(search) {}
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  const TraceInputs<Real>& inputs() const { return inputs_; }
  Recorder& recorder() const { return recorder_; }

  /// The pixel as one ray through its sample position sees it.
  TracedPixel<Real> trace_pixel(int column, int row) const {
    return trace_eye_ray(eye_ray(inputs_, column, row, inputs_.viewport.sample));
  }
  TracedPixel<Real> trace_eye_ray(const Ray<Real>& ray) const;

  /// What each eye ray meets first, without shading it; faster for rays of neighbouring pixels.
  void find(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const {
    recorder_.count(Counter::eye_rays, rays.size());
    search(rays, hits);
  }
  /// find() for rays that are counted already.
  void search(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const { search_.nearest_of_each(rays, hits); }

  /// The pixel whose eye ray, which is counted already, is known to meet `hit`.
  TracedPixel<Real> trace_known(const Ray<Real>& ray, const Hit<Real>& hit) const;
  /// The same into a pixel that may have been used before.
  void trace_known(const Ray<Real>& ray, const Hit<Real>& hit, TracedPixel<Real>& pixel) const;

  /// Subsampling (CGFS ch. 5): `around` summarises the neighbours already traced; the primitives are what they hit. If
  /// all saw the same object, or nothing, only they are tested. Where the ray misses them (met = false), it is to be
  /// searched for after all.
  Hit<Real> find_between(const Ray<Real>& ray, std::span<const std::uint32_t> primitives, ReuseEvent& around) const;
  /// The same with all that follows.
  TracedPixel<Real> trace_between(const Ray<Real>& ray, std::span<const std::uint32_t> primitives,
                                  ReuseEvent around) const;

  /// What is between a surface and a light that lies in the direction `to_light`, up to t_max of it.
  std::optional<PixelId> find_blocker(const SurfacePoint<Real>& surface, int light, const Vec3<Real>& to_light,
                                      Real t_max) const;

 private:
  /// The same for a light that may be a lamp: then several shadow rays find the share of it that is seen. Where the
  /// light has a shadow map, the map says it, and no ray is sent.
  Blocking<Real> find_blocking(const SurfacePoint<Real>& surface, int light, const Vec3<Real>& to_light,
                               Real t_max) const;
  /// The colour that comes back along `ray` after `depth` bounces, one at least.
  Vec3<Real> trace(const Ray<Real>& ray, RayKind kind, int depth, Real share, const Medium<Real>& medium) const;
  /// The colour that comes back along `ray` from `hit`, or from the background. `first` notes what the eye ray found.
  Vec3<Real> colour_of(const Ray<Real>& ray, const Hit<Real>& hit, int depth, Real share, const Medium<Real>& medium,
                       TracedPixel<Real>* first) const;
  Vec3<Real> shade(const Ray<Real>& ray, const SurfacePoint<Real>& surface, int depth, Real share,
                   const Medium<Real>& medium, TracedPixel<Real>* first) const;
  /// shade() of a surface of this material.
  Vec3<Real> shade_as(const Ray<Real>& ray, const SurfacePoint<Real>& surface, const ShadingMaterial<Real>& material,
                      int depth, Real share, const Medium<Real>& medium, TracedPixel<Real>* first) const;
  /// What the scene, or the material's picture of its surroundings, shows in the mirrored direction.
  Vec3<Real> mirrored_colour(const Ray<Real>& ray, const SurfacePoint<Real>& surface,
                             const ShadingMaterial<Real>& material, int depth, Real share,
                             const Medium<Real>& medium) const;
  /// How the light of a transparent surface is divided: local, reflected and transmitted.
  struct Shares {
    Real own = 1, mirrored = 0, refracted = 0;
  };
  /// A surface of transparency T and reflectivity R lets T of the light through and treats the rest as an opaque one
  /// does. Of the transmitted light, the boundary itself reflects the share F (Fresnel), all of it in total
  /// internal reflection; with fixed shares F is 0 otherwise.
  Shares shares_of(const ShadingMaterial<Real>& material, Real fresnel, Real share) const;
  /// Transparency and refraction (CGFS ch. 5).
  Vec3<Real> see_through(const Ray<Real>& ray, const SurfacePoint<Real>& surface, const ShadingMaterial<Real>& material,
                         const Vec3<Real>& local, int depth, Real share, const Medium<Real>& medium) const;
  /// Has the surface nothing behind it that light could run through? Then it does not bend light.
  bool is_flat(const SurfacePoint<Real>& surface) const;
  Vec3<Real> local_colour(const Ray<Real>& ray, const SurfacePoint<Real>& surface,
                          const ShadingMaterial<Real>& material, TracedPixel<Real>* first) const;
  /// Parallax mapping (shade/parallax_mapping.h): the texture coordinates become those that the relief shows.
  void move_uv(const Ray<Real>& ray, const ShadingMaterial<Real>& material, SurfacePoint<Real>& surface) const;
  /// Normal mapping (CGFS ch. 15).
  void map_normal(const ShadingMaterial<Real>& material, SurfacePoint<Real>& surface) const;
  /// Rays have no footprint, so they read the finest level of a texture.
  Vec3<Real> read_finest(int texture, const Vec2<Real>& uv, TextureUse use = TextureUse::surface) const;
  /// A material as its maps make it at the point (MTL: map_Ks, map_Ka, map_d).
  ShadingMaterial<Real> varied_material(const SurfacePoint<Real>& surface, const ShadingMaterial<Real>& material) const;
  Vec3<Real> textured_colour(const SurfacePoint<Real>& surface, const ShadingMaterial<Real>& material) const;
  /// With the shadow cache, what blocked this light last time is tested before everything else (CGFS ch. 5).
  Hit<Real> any_blocker(const Ray<Real>& ray, int light) const;
  RayEvent eye_ray_event(const Ray<Real>& ray, const EyeMedia<Real>& media) const;
  static RayEvent ray_event(const Ray<Real>& ray, RayKind kind, int depth, Real share);
  HitEvent hit_event(const Hit<Real>& hit, const SurfacePoint<Real>& surface) const;

  const TraceInputs<Real>& inputs_;
  Recorder& recorder_;
  Intersector<Real, Recorder> intersector_;
  const RaySearch<Real>& search_;
  /// By light. A tracer is for one tile, so the work that it saves does not depend on threads.
  mutable std::vector<std::uint32_t> last_blockers_;
};

// Defined in tracer-inl.h, compiled in tracer.cpp.
extern template class Tracer<float, Silent>;
extern template class Tracer<float, CountingRecorder>;
extern template class Tracer<float, PixelRecorder>;
extern template class Tracer<double, Silent>;
extern template class Tracer<double, CountingRecorder>;
extern template class Tracer<double, PixelRecorder>;

}  // namespace ps
