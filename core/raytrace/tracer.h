#pragma once
#include <optional>
#include <span>

#include "image/texture_sampling.h"
#include "raytrace/eye_media.h"
#include "raytrace/intersector.h"
#include "raytrace/medium.h"
#include "raytrace/normal_map.h"
#include "raytrace/self_hit.h"
#include "shade/fresnel.h"
#include "shade/illumination.h"
#include "shade/parallax_mapping.h"
#include "shade/reflection_map.h"

namespace ps {

/// What one eye ray found.
template <class Real>
struct TracedPixel {
  Vec3<Real> colour{0};
  Ray<Real> ray;
  Hit<Real> hit;          ///< of the eye ray; not found() = background
  Surface<Real> surface;  ///< only if hit
  std::uint32_t shadow_mask = 0;
};

/// The ray tracer of CGFS ch. 2-4: for one pixel, the light that its ray brings back.
template <class Real, class Recorder>
class Tracer {
 public:
  Tracer(const TraceInputs<Real>& inputs, Recorder& recorder)
      : inputs_(inputs), recorder_(recorder), intersector_(inputs, recorder) {}

  /// The pixel as one ray through its sample position sees it.
  TracedPixel<Real> trace_pixel(int column, int row) const {
    return trace_eye_ray(eye_ray(column, row, inputs_.viewport.sample));
  }

  TracedPixel<Real> trace_eye_ray(const Ray<Real>& ray) const {
    TracedPixel<Real> pixel;
    pixel.ray = ray;
    recorder_.count(Counter::eye_rays);
    const EyeMedia<Real> media(inputs_, ray);
    recorder_.begin([&] { return eye_ray_event(ray, media); });
    const Hit<Real> hit = intersector_.nearest(ray);
    pixel.colour = colour_of(pixel.ray, hit, 0, Real(1), media.innermost(), &pixel);
    recorder_.end();
    return pixel;
  }

  /// Calls use(column, rays, hits) for up to packet_width pixels of a part of a row at a time, whose eye rays are
  /// followed together.
  template <class Use>
  void find_pixels(int first_column, int end_column, int row, Use&& use) const {
    std::array<Ray<Real>, packet_width> rays;
    std::array<Hit<Real>, packet_width> hits;
    const Viewport<Real>& viewport = inputs_.viewport;
    const Vec3<Real> upwards = inputs_.up * viewport.at(first_column, row).y;  // the same for the row
    rays.fill(eye_ray(Real(0), upwards));
    for (int column = first_column; column < end_column;) {
      std::size_t count = 0;
      for (; count < packet_width && column + static_cast<int>(count) < end_column; ++count)
        aim(rays[count], viewport.at(column + static_cast<int>(count), row).x, upwards);
      recorder_.count(Counter::eye_rays, count);
      const auto some = std::span<const Ray<Real>>(rays).first(count);
      intersector_.nearest(some, std::span(hits).first(count));
      use(column, some, std::span<const Hit<Real>>(hits).first(count));
      column += static_cast<int>(count);
    }
  }

  /// Calls use(column, traced pixel) for them.
  template <class Use>
  void trace_pixels(int first_column, int end_column, int row, Use&& use) const {
    find_pixels(first_column, end_column, row,
                [&](int column, std::span<const Ray<Real>> rays, std::span<const Hit<Real>> hits) {
                  trace_known(rays, hits, [&](std::size_t i, const TracedPixel<Real>& pixel) {
                    use(column + static_cast<int>(i), pixel);
                  });
                });
  }

  /// What each eye ray meets first, without shading it; faster for rays of neighbouring pixels.
  void find(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const {
    recorder_.count(Counter::eye_rays, rays.size());
    intersector_.nearest(rays, hits);
  }

  /// The pixel whose eye ray is known to meet `hit`.
  TracedPixel<Real> trace_known(const Ray<Real>& ray, const Hit<Real>& hit) const {
    TracedPixel<Real> pixel;
    trace_known(ray, hit, pixel);
    return pixel;
  }

  /// find() for rays that are counted already.
  void search(std::span<const Ray<Real>> rays, std::span<Hit<Real>> hits) const { intersector_.nearest(rays, hits); }

  /// Calls use(i, traced pixel) for eye rays that are known to meet `hits`.
  template <class Use>
  void trace_known(std::span<const Ray<Real>> rays, std::span<const Hit<Real>> hits, Use&& use) const {
    TracedPixel<Real> pixel;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      trace_known(rays[i], hits[i], pixel);
      use(i, pixel);
    }
  }

  /// Subsampling (CGFS ch. 5): `around` summarises the neighbours already traced; the primitives are what they hit. If
  /// all saw the same object, or nothing, only they are tested. Where the ray misses them (met = false), it is to be
  /// searched for after all.
  Hit<Real> find_between(const Ray<Real>& ray, std::span<const std::uint32_t> primitives, ReuseEvent& around) const {
    Hit<Real> hit;
    if (around.same && !primitives.empty()) hit = intersector_.among(ray, primitives);
    around.met = around.same && (primitives.empty() || hit.found());
    if (around.met) recorder_.count(Counter::searches_saved);
    return hit;
  }

  /// The same with all that follows.
  TracedPixel<Real> trace_between(const Ray<Real>& ray, std::span<const std::uint32_t> primitives,
                                  ReuseEvent around) const {
    TracedPixel<Real> pixel;
    pixel.ray = ray;
    recorder_.count(Counter::eye_rays);
    const EyeMedia<Real> media(inputs_, ray);
    recorder_.begin([&] { return eye_ray_event(ray, media); });
    Hit<Real> hit = find_between(ray, primitives, around);
    recorder_.event([&] { return around; });
    if (!around.met) hit = intersector_.nearest(ray);
    pixel.colour = colour_of(pixel.ray, hit, 0, Real(1), media.innermost(), &pixel);
    recorder_.end();
    return pixel;
  }

  /// What stands between a surface and a light that lies in the direction `to_light`, up to t_max of it.
  std::optional<PixelId> find_blocker(const Surface<Real>& surface, int light, const Vec3<Real>& to_light,
                                      Real t_max) const {
    if (inputs_.settings.shadows == Shadows::none) return {};
    Ray<Real> ray = leaving_ray(surface, to_light, t_max, inputs_.shadow_epsilon, inputs_);
    ray.passes_transparent = inputs_.any_transparent;
    recorder_.count(Counter::shadow_rays);
    recorder_.begin([&] { return ray_event(ray, RayKind::shadow, 0, Real(0)); });
    const Hit<Real> hit = inputs_.settings.shadow_any_hit ? any_blocker(ray, light) : intersector_.nearest(ray);
    recorder_.end();
    if (!hit.found()) return {};
    return id_of(*inputs_.geometry, hit);
  }

  /// Ray through a point of pixel (column, row), `offset` from its top-left corner.
  Ray<Real> eye_ray(int column, int row, const Vec2d& offset) const {
    const Vec2<Real> v = inputs_.viewport.at(column, row, offset);
    return eye_ray(v.x, inputs_.up * v.y);
  }

 private:
  /// Through the viewport position x to the right of the centre and `upwards` above it.
  Ray<Real> eye_ray(Real x, const Vec3<Real>& upwards) const {
    Ray<Real> ray{inputs_.eye, inputs_.forward, inputs_.near, inputs_.far, no_primitive};
    aim(ray, x, upwards);
    return ray;
  }
  void aim(Ray<Real>& ray, Real x, const Vec3<Real>& upwards) const {
    const Vec3<Real> across = inputs_.right * x + upwards;
    switch (inputs_.viewport.projection) {
    case Projection::perspective:
      ray.direction = across + inputs_.forward;
      break;
    case Projection::orthographic:
      ray.origin = inputs_.eye + across;
      break;
    }
  }

  /// As above, into a pixel that may have been used before.
  void trace_known(const Ray<Real>& ray, const Hit<Real>& hit, TracedPixel<Real>& pixel) const {
    pixel.ray = ray;
    pixel.hit = {};
    pixel.shadow_mask = 0;
    if (!hit.found()) pixel.surface = {};
    const EyeMedia<Real> media(inputs_, ray);
    pixel.colour = colour_of(pixel.ray, hit, 0, Real(1), media.innermost(), &pixel);
  }

  /// The colour that comes back along `ray` after `depth` bounces, one at least.
  Vec3<Real> trace(const Ray<Real>& ray, RayKind kind, int depth, Real share, const Medium<Real>& medium) const {
    recorder_.begin([&] { return ray_event(ray, kind, depth, share); });
    const Hit<Real> hit = intersector_.nearest(ray);
    const Vec3<Real> colour = colour_of(ray, hit, depth, share, medium, nullptr);
    recorder_.end();
    return colour;
  }

  /// The colour that comes back along `ray` from `hit`, or from the background. `first` notes what the eye ray found.
  Vec3<Real> colour_of(const Ray<Real>& ray, const Hit<Real>& hit, int depth, Real share, const Medium<Real>& medium,
                       TracedPixel<Real>* first) const {
    Vec3<Real> colour = inputs_.background;
    if (hit.found()) {
      Surface<Real> own;
      Surface<Real>& surface = first ? first->surface : own;
      put_surface(ray, hit, inputs_, surface);
      if (inputs_.settings.parallax != Parallax::off && inputs_.materials[surface.material].height_map >= 0)
        move_uv(ray, inputs_.materials[surface.material], surface);
      if (inputs_.settings.normal_mapping && inputs_.materials[surface.material].normal_map >= 0)
        map_normal(inputs_.materials[surface.material], surface);
      if (first) first->hit = hit;
      recorder_.event([&] { return hit_event(hit, surface); });
      colour = shade(ray, surface, depth, share, medium, first);
    } else {
      recorder_.event([&] { return MissEvent{Vec3d(inputs_.background)}; });
    }
    return colour;
  }

  Vec3<Real> shade(const Ray<Real>& ray, const Surface<Real>& surface, int depth, Real share,
                   const Medium<Real>& medium, TracedPixel<Real>* first) const {
    const ShadingMaterial<Real>& material = inputs_.materials[surface.material];
    if (material.varies() && inputs_.settings.textures && surface.has_uv)
      return shade_as(ray, surface, varied_material(surface, material), depth, share, medium, first);
    return shade_as(ray, surface, material, depth, share, medium, first);
  }

  /// shade() of a surface of this material.
  Vec3<Real> shade_as(const Ray<Real>& ray, const Surface<Real>& surface, const ShadingMaterial<Real>& material,
                      int depth, Real share, const Medium<Real>& medium, TracedPixel<Real>* first) const {
    const Vec3<Real> local = local_colour(ray, surface, material, first);
    const Real reflective = material.reflective;
    if (depth >= inputs_.settings.reflection_depth) return local;
    const Real through = material.transparency;
    const Real further = share * (through + (Real(1) - through) * reflective);
    if ((through > 0 || reflective > 0) && further < inputs_.reflection_cutoff) {
      recorder_.event([&] {
        return CutoffEvent{static_cast<double>(further), static_cast<double>(inputs_.reflection_cutoff)};
      });
      return local;
    }
    if (through > 0) return see_through(ray, surface, material, local, depth, share, medium);
    if (!(reflective > 0)) return local;

    const Vec3<Real> reflected = mirrored_colour(ray, surface, material, depth, share * reflective, medium);
    const Vec3<Real> result = local * (Real(1) - reflective) + reflected * reflective;
    recorder_.event([&] {
      return ReflectionEvent{static_cast<double>(reflective), Vec3d(local), Vec3d(reflected), Vec3d(result)};
    });
    return result;
  }

  /// What the scene, or the material's picture of its surroundings, shows in the mirrored direction.
  Vec3<Real> mirrored_colour(const Ray<Real>& ray, const Surface<Real>& surface, const ShadingMaterial<Real>& material,
                             int depth, Real share, const Medium<Real>& medium) const {
    const Vec3<Real> direction = mirrored_direction(surface, -ray.direction, inputs_);
    if (material.reflection_map >= 0 && inputs_.settings.textures)
      return read_reflection_map(*inputs_.textures[static_cast<std::size_t>(material.reflection_map)],
                                 material.reflection_map, material.surroundings, direction,
                                 inputs_.settings.texture_filter, recorder_);
    const Ray<Real> reflected =
        leaving_ray(surface, direction, std::numeric_limits<Real>::infinity(), inputs_.reflection_epsilon, inputs_);
    recorder_.count(Counter::reflection_rays);
    return trace(reflected, RayKind::reflection, depth + 1, share, medium);
  }

  /// How the light of a transparent surface is divided: local, reflected and transmitted.
  struct Shares {
    Real own = 1, mirrored = 0, refracted = 0;
  };

  /// A surface of transparency T and reflectivity R lets T of the light through and treats the rest as an opaque one
  /// does. Of the transmitted light, the boundary itself reflects the share F (Fresnel), all of it in total
  /// internal reflection; with fixed shares F is 0 otherwise.
  Shares shares_of(const ShadingMaterial<Real>& material, Real fresnel, Real share) const {
    const Real through = material.transparency, rest = Real(1) - through;
    Shares shares{rest * (Real(1) - material.reflective), rest * material.reflective + through * fresnel,
                  through * (Real(1) - fresnel)};
    if (shares.mirrored > 0 && shares.refracted > 0) {
      const Real least = std::max(least_branch_share<Real>, inputs_.reflection_cutoff);
      if (share * shares.mirrored < least) {
        shares.refracted += shares.mirrored;
        shares.mirrored = 0;
      } else if (share * shares.refracted < least) {
        shares.mirrored += shares.refracted;
        shares.refracted = 0;
      }
    }
    return shares;
  }

  /// Transparency and refraction (CGFS ch. 5).
  Vec3<Real> see_through(const Ray<Real>& ray, const Surface<Real>& surface, const ShadingMaterial<Real>& material,
                         const Vec3<Real>& local, int depth, Real share, const Medium<Real>& medium) const {
    static constexpr Medium<Real> outside{};
    const bool leaves = surface.back_face;
    const Medium<Real>& around = medium.around ? *medium.around : outside;
    const Medium<Real> inside{material.refraction_index, &medium};
    const Medium<Real>& beyond = leaves ? around : inside;
    const bool bends = inputs_.settings.refraction && !is_flat(surface);
    const Real n1 = bends ? medium.index : Real(1), n2 = bends ? beyond.index : Real(1);
    const std::optional<Refraction<Real>> bent = refract(ray.direction, surface.shading_normal, n1, n2);
    Real fresnel = bent ? Real(0) : Real(1);
    if (bent && bends && inputs_.settings.transparency == TransparencyShare::fresnel)
      fresnel = fresnel_share(bent->cos_incident, bent->cos_refracted, n1, n2);
    const Shares shares = shares_of(material, fresnel, share);
    Vec3<Real> mirrored(0), refracted(0);
    if (shares.mirrored > 0) mirrored = mirrored_colour(ray, surface, material, depth, share * shares.mirrored, medium);
    if (shares.refracted > 0 && bent) {
      const Ray<Real> through = leaving_ray(surface, bent->direction, std::numeric_limits<Real>::infinity(),
                                            inputs_.reflection_epsilon, inputs_);
      recorder_.count(Counter::refraction_rays);
      refracted =
          trace(through, RayKind::refraction, depth + 1, share * shares.refracted, is_flat(surface) ? medium : beyond);
    }
    const Vec3<Real> result = local * shares.own + mirrored * shares.mirrored + refracted * shares.refracted;
    recorder_.event([&] {
      RefractionEvent event;
      event.transparency = static_cast<double>(material.transparency);
      event.from_index = static_cast<double>(n1);
      event.to_index = static_cast<double>(n2);
      const Vec3<Real> unit = normalised(ray.direction);
      event.cos_incident = static_cast<double>(std::abs(dot(unit, surface.shading_normal)));
      event.cos_refracted = bent ? static_cast<double>(bent->cos_refracted) : 0.0;
      event.fresnel = static_cast<double>(fresnel);
      event.total = !bent;
      event.own_share = static_cast<double>(shares.own);
      event.mirrored_share = static_cast<double>(shares.mirrored);
      event.refracted_share = static_cast<double>(shares.refracted);
      event.local = Vec3d(local);
      event.mirrored = Vec3d(mirrored);
      event.refracted = Vec3d(refracted);
      event.result = Vec3d(result);
      return event;
    });
    return result;
  }

  /// Has the surface nothing behind it that light could run through? Then it does not bend light.
  bool is_flat(const Surface<Real>& surface) const {
    const Primitive primitive = primitive_of(*inputs_.geometry, surface.primitive);
    if (primitive.kind != PrimitiveKind::solid) return false;
    const TracedSolid& solid = inputs_.geometry->solids[primitive.shape];
    const FormKind kind = inputs_.geometry->forms[solid.first_form].kind;
    return solid.steps == 0 && (kind == FormKind::plane || kind == FormKind::rectangle);
  }

  Vec3<Real> local_colour(const Ray<Real>& ray, const Surface<Real>& surface, const ShadingMaterial<Real>& material,
                          TracedPixel<Real>* first) const {
    recorder_.count(Counter::shading_calls);
    const Vec3<Real> surface_colour = textured_colour(surface, material);
    Lighting<Real> lighting{Vec3<Real>(1), Vec3<Real>(0)};
    if (inputs_.settings.lighting) {
      const LitPoint<Real> point{surface.point, surface.shading_normal, -ray.direction};
      const IlluminationOptions options = illumination_options(inputs_.settings);
      const bool useful_only = inputs_.settings.shadow_rays == ShadowRays::useful;
      const auto blocked = [&](int light, const Vec3<Real>& to_light, Real t_max) {
        if (useful_only && !adds_light(point, material, to_light, options)) return std::optional<PixelId>();
        const std::optional<PixelId> blocker = find_blocker(surface, light, to_light, t_max);
        if (blocker && first && light < 32) first->shadow_mask |= 1u << light;
        return blocker;
      };
      lighting = illuminate<Real>(point, material, inputs_.lights, options, blocked, recorder_);
    }
    const Vec3<Real> local = surface_colour * lighting.light + lighting.extra;
    recorder_.event([&] {
      return ShadeEvent{Vec3d(surface_colour), Vec3d(lighting.light), Vec3d(lighting.extra), Vec3d(local)};
    });
    return local;
  }

  /// Parallax mapping (shade/parallax_mapping.h): the texture coordinates become those that the relief shows.
  void move_uv(const Ray<Real>& ray, const ShadingMaterial<Real>& material, Surface<Real>& surface) const {
    if (!surface.has_uv) return;
    const auto frame = tangents_of(surface, *inputs_.geometry, TangentLengths::in_proportion);
    if (!frame) return;
    const auto shift =
        relief_shift(surface.shading_normal, *frame, -ray.direction, material.relief_depth, inputs_.settings.parallax);
    if (!shift) return;
    const Image<Vec3f>& heights = *inputs_.textures[static_cast<std::size_t>(material.height_map)];
    const bool nearest = inputs_.settings.texture_filter == TextureFilter::nearest;
    const TextureWrap wrap = inputs_.wraps[static_cast<std::size_t>(material.height_map)];
    const auto depth_at = [&](const Vec2<Real>& at) {
      recorder_.count(Counter::texel_reads, nearest ? 1 : 4);
      return Real(1) - (nearest ? sample_nearest(heights, at, wrap) : sample_bilinear(heights, at, wrap)).x;
    };
    surface.uv = parallax_uv(material.height_map, surface.uv, *shift, inputs_.settings, depth_at, recorder_);
  }

  /// Normal mapping (CGFS ch. 15).
  void map_normal(const ShadingMaterial<Real>& material, Surface<Real>& surface) const {
    const auto frame = tangents_of(surface, *inputs_.geometry);
    if (!frame) return;
    const auto space = tangent_space(surface.shading_normal, *frame);
    if (!space) return;
    const Vec3<Real> stored = stored_normal(read_finest(material.normal_map, surface.uv));
    const Vec3<Real> before = surface.shading_normal;
    surface.shading_normal = mapped_normal(*space, stored);
    recorder_.event([&] {
      return NormalMapEvent{material.normal_map,          Vec2d(surface.uv),       Vec3d(stored),
                            Vec3d(space->tangent),        Vec3d(space->bitangent), Vec3d(before),
                            Vec3d(surface.shading_normal)};
    });
  }

  /// Rays have no footprint, so they read the finest level of a texture.
  Vec3<Real> read_finest(int texture, const Vec2<Real>& uv, TextureUse use = TextureUse::surface) const {
    const Image<Vec3f>& image = *inputs_.textures[static_cast<std::size_t>(texture)];
    const TextureWrap wrap = inputs_.wraps[static_cast<std::size_t>(texture)];
    const bool nearest = inputs_.settings.texture_filter == TextureFilter::nearest;
    std::vector<Texel> texels;
    const TexelNotes notes = Recorder::records ? &texels : nullptr;
    const Vec3<Real> texel =
        nearest ? sample_nearest(image, uv, wrap, 0, notes) : sample_bilinear(image, uv, wrap, 0, notes);
    recorder_.count(Counter::texel_reads, nearest ? 1 : 4);
    recorder_.event([&] { return TextureEvent{texture, Vec2d(uv), 0, std::move(texels), Vec3d(texel), use}; });
    return texel;
  }

  /// A material as its maps make it at the point (MTL: map_Ks, map_Ka, map_d).
  ShadingMaterial<Real> varied_material(const Surface<Real>& surface, const ShadingMaterial<Real>& material) const {
    ShadingMaterial<Real> own = material;
    if (material.specular_map >= 0 && inputs_.settings.lighting)
      *own.specular_colour *= read_finest(material.specular_map, surface.uv, TextureUse::highlight);
    if (material.ambient_map >= 0 && inputs_.settings.lighting)
      *own.ambient_colour *= read_finest(material.ambient_map, surface.uv, TextureUse::ambient);
    if (material.opacity_map >= 0)
      own.transparency =
          1 - (1 - material.transparency) * read_finest(material.opacity_map, surface.uv, TextureUse::opacity).x;
    return own;
  }

  Vec3<Real> textured_colour(const Surface<Real>& surface, const ShadingMaterial<Real>& material) const {
    if (material.texture < 0 || !inputs_.settings.textures || !surface.has_uv) return material.colour;
    return read_finest(material.texture, surface.uv) * material.colour;
  }

  /// With the shadow cache, what blocked this light last time is tested before everything else (CGFS ch. 5).
  Hit<Real> any_blocker(const Ray<Real>& ray, int light) const {
    if (!inputs_.settings.shadow_cache) return intersector_.any(ray);
    const auto index = static_cast<std::size_t>(light);
    if (last_blockers_.size() <= index) last_blockers_.resize(index + 1, no_primitive);
    if (last_blockers_[index] != no_primitive) {
      const Hit<Real> hit = intersector_.one(ray, last_blockers_[index]);
      if (hit.found()) return hit;
    }
    const Hit<Real> hit = intersector_.any(ray);
    if (hit.found()) last_blockers_[index] = hit.primitive;
    return hit;
  }

  RayEvent eye_ray_event(const Ray<Real>& ray, const EyeMedia<Real>& media) const {
    RayEvent event = ray_event(ray, RayKind::eye, 0, Real(1));
    event.t_min = inputs_.settings.near;  // as asked, without the slack for rounding
    event.t_max = inputs_.settings.far;
    event.inside = media.events();
    return event;
  }

  static RayEvent ray_event(const Ray<Real>& ray, RayKind kind, int depth, Real share) {
    return {kind,
            Vec3d(ray.origin),
            Vec3d(ray.direction),
            static_cast<double>(ray.t_min),
            static_cast<double>(ray.t_max),
            depth,
            static_cast<double>(share),
            {}};
  }

  HitEvent hit_event(const Hit<Real>& hit, const Surface<Real>& surface) const {
    HitEvent event;
    event.id = id_of(*inputs_.geometry, hit);
    event.t = static_cast<double>(hit.t);
    event.point = Vec3d(surface.point);
    event.geometric_normal = Vec3d(surface.geometric_normal);
    event.shading_normal = Vec3d(surface.shading_normal);
    for (std::size_t k = 0; k < 3; ++k) event.weights[k] = static_cast<double>(hit.weights[k]);
    event.uv = Vec2d(surface.uv);
    event.back_face = surface.back_face;
    return event;
  }

  const TraceInputs<Real>& inputs_;
  Recorder& recorder_;
  Intersector<Real, Recorder> intersector_;
  /// By light. A tracer is for one tile, so the work that it saves does not depend on threads.
  mutable std::vector<std::uint32_t> last_blockers_;
};

}  // namespace ps
