// Definitions of tracer.h for callers with a recorder of their own; tracer.cpp instantiates those of the program.
#pragma once
#include "raytrace/clear/tracer.h"

#include <algorithm>
#include <limits>

#include "raster/shadow/shadow_lookup.h"
#include "raytrace/clear/lamp.h"
#include "raytrace/clear/normal_map.h"
#include "raytrace/clear/self_hit.h"
#include "shade/fresnel.h"
#include "shade/illumination.h"
#include "shade/parallax_mapping.h"
#include "shade/reflection_map.h"

namespace ps {

template <class Real, class Recorder>
TracedPixel<Real> Tracer<Real, Recorder>::trace_eye_ray(const Ray<Real>& ray) const {
  TracedPixel<Real> pixel;
  pixel.ray = ray;
  recorder_.count(Counter::eye_rays);
  const EyeMedia<Real> media(inputs_, ray);
  recorder_.begin([&] { return eye_ray_event(ray, media); });
  const Hit<Real> hit = search_.nearest(ray);
  pixel.colour = colour_of(pixel.ray, hit, 0, Real(1), media.innermost(), &pixel);
  recorder_.end();
  return pixel;
}

template <class Real, class Recorder>
TracedPixel<Real> Tracer<Real, Recorder>::trace_known(const Ray<Real>& ray, const Hit<Real>& hit) const {
  TracedPixel<Real> pixel;
  trace_known(ray, hit, pixel);
  return pixel;
}

template <class Real, class Recorder>
Hit<Real> Tracer<Real, Recorder>::find_between(const Ray<Real>& ray, std::span<const std::uint32_t> primitives,
                                               ReuseEvent& around) const {
  Hit<Real> hit;
  if (around.same && !primitives.empty()) hit = intersector_.among(ray, primitives);
  around.met = around.same && (primitives.empty() || hit.found());
  if (around.met) recorder_.count(Counter::searches_saved);
  return hit;
}

template <class Real, class Recorder>
TracedPixel<Real> Tracer<Real, Recorder>::trace_between(const Ray<Real>& ray, std::span<const std::uint32_t> primitives,
                                                        ReuseEvent around) const {
  TracedPixel<Real> pixel;
  pixel.ray = ray;
  recorder_.count(Counter::eye_rays);
  const EyeMedia<Real> media(inputs_, ray);
  recorder_.begin([&] { return eye_ray_event(ray, media); });
  Hit<Real> hit = find_between(ray, primitives, around);
  recorder_.event([&] { return around; });
  if (!around.met) hit = search_.nearest(ray);
  pixel.colour = colour_of(pixel.ray, hit, 0, Real(1), media.innermost(), &pixel);
  recorder_.end();
  return pixel;
}

template <class Real, class Recorder>
std::optional<PixelId> Tracer<Real, Recorder>::find_blocker(const SurfacePoint<Real>& surface, int light,
                                                            const Vec3<Real>& to_light, Real t_max) const {
  if (inputs_.settings.shadows == Shadows::none) return {};
  Ray<Real> ray = leaving_ray(surface, to_light, t_max, inputs_.shadow_epsilon, inputs_);
  ray.passes_transparent = inputs_.any_transparent;
  recorder_.count(Counter::shadow_rays);
  recorder_.begin([&] { return ray_event(ray, RayKind::shadow, 0, Real(0)); });
  const Hit<Real> hit = inputs_.settings.shadow_any_hit ? any_blocker(ray, light) : search_.nearest(ray);
  recorder_.end();
  if (!hit.found()) return {};
  return id_of(*inputs_.geometry, hit);
}

template <class Real, class Recorder>
Blocking<Real> Tracer<Real, Recorder>::find_blocking(const SurfacePoint<Real>& surface, int light,
                                                     const Vec3<Real>& to_light, Real t_max) const {
  // The point lies on the curved surface itself, and the triangles of the map lie within it: there is no error to allow
  // for.
  if (inputs_.shadow_maps)
    return Blocking<Real>::partly(raster::share_by_map(*inputs_.shadow_maps, light, surface.point,
                                                       surface.shading_normal, inputs_.settings, Real(0), recorder_));
  const Real radius = inputs_.lights[static_cast<std::size_t>(light)].radius;
  const int rays = inputs_.settings.shadow_samples;
  if (rays == 1 || !(radius > 0)) return find_blocker(surface, light, to_light, t_max);
  const LampDisc<Real> disc(to_light, radius);
  const Vec2i place = pattern_place(surface.point, light);
  std::optional<PixelId> blocker;
  int arrived = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec2d square = sample_in_square(inputs_.settings.shadow_pattern, i, rays, place);
    const auto found = find_blocker(surface, light, disc.towards(square), t_max);
    if (found && !blocker) blocker = found;
    arrived += found ? 0 : 1;
  }
  if (arrived == 0) return blocker;
  return Blocking<Real>::partly(static_cast<Real>(arrived) / static_cast<Real>(rays));
}

template <class Real, class Recorder>
void Tracer<Real, Recorder>::trace_known(const Ray<Real>& ray, const Hit<Real>& hit, TracedPixel<Real>& pixel) const {
  pixel.ray = ray;
  pixel.hit = {};
  pixel.shadow_mask = 0;
  if (!hit.found()) pixel.surface = {};
  const EyeMedia<Real> media(inputs_, ray);
  pixel.colour = colour_of(pixel.ray, hit, 0, Real(1), media.innermost(), &pixel);
}

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::trace(const Ray<Real>& ray, RayKind kind, int depth, Real share,
                                         const Medium<Real>& medium) const {
  recorder_.begin([&] { return ray_event(ray, kind, depth, share); });
  const Hit<Real> hit = search_.nearest(ray);
  const Vec3<Real> colour = colour_of(ray, hit, depth, share, medium, nullptr);
  recorder_.end();
  return colour;
}

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::colour_of(const Ray<Real>& ray, const Hit<Real>& hit, int depth, Real share,
                                             const Medium<Real>& medium, TracedPixel<Real>* first) const {
  Vec3<Real> colour = inputs_.background;
  if (hit.found()) {
    SurfacePoint<Real> own;
    SurfacePoint<Real>& surface = first ? first->surface : own;
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

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::shade(const Ray<Real>& ray, const SurfacePoint<Real>& surface, int depth, Real share,
                                         const Medium<Real>& medium, TracedPixel<Real>* first) const {
  const ShadingMaterial<Real>& material = inputs_.materials[surface.material];
  if (material.varies() && inputs_.settings.textures && surface.has_uv)
    return shade_as(ray, surface, varied_material(surface, material), depth, share, medium, first);
  return shade_as(ray, surface, material, depth, share, medium, first);
}

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::shade_as(const Ray<Real>& ray, const SurfacePoint<Real>& surface,
                                            const ShadingMaterial<Real>& material, int depth, Real share,
                                            const Medium<Real>& medium, TracedPixel<Real>* first) const {
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

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::mirrored_colour(const Ray<Real>& ray, const SurfacePoint<Real>& surface,
                                                   const ShadingMaterial<Real>& material, int depth, Real share,
                                                   const Medium<Real>& medium) const {
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

template <class Real, class Recorder>
typename Tracer<Real, Recorder>::Shares Tracer<Real, Recorder>::shares_of(const ShadingMaterial<Real>& material,
                                                                          Real fresnel, Real share) const {
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

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::see_through(const Ray<Real>& ray, const SurfacePoint<Real>& surface,
                                               const ShadingMaterial<Real>& material, const Vec3<Real>& local,
                                               int depth, Real share, const Medium<Real>& medium) const {
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

template <class Real, class Recorder>
bool Tracer<Real, Recorder>::is_flat(const SurfacePoint<Real>& surface) const {
  const Primitive primitive = primitive_of(*inputs_.geometry, surface.primitive);
  if (primitive.kind != PrimitiveKind::solid) return false;
  const TracedSolid& solid = inputs_.geometry->solids[primitive.shape];
  const FormKind kind = inputs_.geometry->forms[solid.first_form].kind;
  return solid.steps == 0 && (kind == FormKind::plane || kind == FormKind::rectangle);
}

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::local_colour(const Ray<Real>& ray, const SurfacePoint<Real>& surface,
                                                const ShadingMaterial<Real>& material, TracedPixel<Real>* first) const {
  recorder_.count(Counter::shading_calls);
  const Vec3<Real> surface_colour = textured_colour(surface, material);
  Lighting<Real> lighting{Vec3<Real>(1), Vec3<Real>(0)};
  if (inputs_.settings.lighting) {
    const LitPoint<Real> point{surface.point, surface.shading_normal, -ray.direction};
    const IlluminationOptions options = illumination_options(inputs_.settings);
    const bool mapped = inputs_.shadow_maps != nullptr;
    const bool useful_only = !mapped && inputs_.settings.shadow_rays == ShadowRays::useful;
    const auto blocked = [&](int light, const Vec3<Real>& to_light, Real t_max) -> Blocking<Real> {
      if (useful_only && !adds_light(point, material, to_light, options)) return std::optional<PixelId>();
      const Blocking<Real> found = find_blocking(surface, light, to_light, t_max);
      const bool shadowed = mapped ? raster::is_shadowed(found.visible) : found.visible < 1;
      if (shadowed && first && light < 32) first->shadow_mask |= 1u << light;
      return found;
    };
    lighting = illuminate<Real>(point, material, inputs_.lights, options, blocked, recorder_);
  }
  const Vec3<Real> local = surface_colour * lighting.light + lighting.extra;
  recorder_.event([&] {
    return ShadeEvent{Vec3d(surface_colour), Vec3d(lighting.light), Vec3d(lighting.extra), Vec3d(local)};
  });
  return local;
}

template <class Real, class Recorder>
void Tracer<Real, Recorder>::move_uv(const Ray<Real>& ray, const ShadingMaterial<Real>& material,
                                     SurfacePoint<Real>& surface) const {
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

template <class Real, class Recorder>
void Tracer<Real, Recorder>::map_normal(const ShadingMaterial<Real>& material, SurfacePoint<Real>& surface) const {
  const auto frame = tangents_of(surface, *inputs_.geometry);
  if (!frame) return;
  const auto space = inputs_.placings.empty()
                         ? tangent_space(surface.shading_normal, *frame)
                         : tangent_space(surface.shading_normal, *frame, placing_at(surface, inputs_));
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

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::read_finest(int texture, const Vec2<Real>& uv, TextureUse use) const {
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

template <class Real, class Recorder>
ShadingMaterial<Real> Tracer<Real, Recorder>::varied_material(const SurfacePoint<Real>& surface,
                                                              const ShadingMaterial<Real>& material) const {
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

template <class Real, class Recorder>
Vec3<Real> Tracer<Real, Recorder>::textured_colour(const SurfacePoint<Real>& surface,
                                                   const ShadingMaterial<Real>& material) const {
  if (material.texture < 0 || !inputs_.settings.textures || !surface.has_uv) return material.colour;
  return read_finest(material.texture, surface.uv) * material.colour;
}

template <class Real, class Recorder>
Hit<Real> Tracer<Real, Recorder>::any_blocker(const Ray<Real>& ray, int light) const {
  if (!inputs_.settings.shadow_cache) return search_.any(ray);
  const auto index = static_cast<std::size_t>(light);
  if (last_blockers_.size() <= index) last_blockers_.resize(index + 1, no_primitive);
  if (last_blockers_[index] != no_primitive) {
    const Hit<Real> hit = intersector_.one(ray, last_blockers_[index]);
    if (hit.found()) return hit;
  }
  const Hit<Real> hit = search_.any(ray);
  if (hit.found()) last_blockers_[index] = hit.primitive;
  return hit;
}

template <class Real, class Recorder>
RayEvent Tracer<Real, Recorder>::eye_ray_event(const Ray<Real>& ray, const EyeMedia<Real>& media) const {
  RayEvent event = ray_event(ray, RayKind::eye, 0, Real(1));
  event.t_min = inputs_.settings.near;  // as asked, without the slack for rounding
  event.t_max = inputs_.settings.far;
  event.inside = media.events();
  return event;
}

template <class Real, class Recorder>
RayEvent Tracer<Real, Recorder>::ray_event(const Ray<Real>& ray, RayKind kind, int depth, Real share) {
  return {kind,
          Vec3d(ray.origin),
          Vec3d(ray.direction),
          static_cast<double>(ray.t_min),
          static_cast<double>(ray.t_max),
          depth,
          static_cast<double>(share),
          {}};
}

template <class Real, class Recorder>
HitEvent Tracer<Real, Recorder>::hit_event(const Hit<Real>& hit, const SurfacePoint<Real>& surface) const {
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

}  // namespace ps
