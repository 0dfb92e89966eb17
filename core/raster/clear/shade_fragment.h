#pragma once
#include <optional>

#include "image/anisotropic.h"
#include "image/mip_level.h"
#include "image/texture_sampling.h"
#include "math/unit.h"
#include "raster/assembly/corner_attributes.h"
#include "raster/assembly/screen_geometry.h"
#include "raster/assembly/vertex_light.h"
#include "raster/base/fragment.h"
#include "raster/base/light_at.h"
#include "raster/environment/mirror_environment.h"
#include "raster/setup/draw_stage.h"
#include "raster/shadow/shadowed_light.h"
#include "shade/normal_mapping.h"
#include "shade/parallax_mapping.h"
#include "shade/reflection_map.h"

namespace ps::raster {

/// What shading found out besides the colour; channels show it.
template <class Real>
struct ShadedFragment {
  Vec3<Real> colour{0, 0, 0};
  Vec3<Real> normal{0, 0, 0};  ///< world space, length 1; only where the layout asks for a shading normal
  Vec2<Real> uv{0, 0};
  Real mip = -1;                  ///< level read; -1 without a texture
  std::uint32_t shadow_mask = 0;  ///< bit i set: light i does not reach the point
};

/// How fast u and v change from pixel to pixel, in texels: derivatives of the interpolated quotients, not differences
/// between neighbours.
template <class Real>
TextureDerivatives<Real> uv_derivatives(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                                        const Fragment<Real>& fragment, const Vec2<Real>& uv,
                                        const Image<Vec3f>& texture) {
  const auto stride = static_cast<std::size_t>(setup.surface->layout.count);
  const Real* a = setup.attributes + setup.surface->layout.uv;
  const Vec2<Real> size(static_cast<Real>(texture.width()), static_cast<Real>(texture.height()));
  const auto along = [&](const std::array<std::int64_t, 3>& step) {
    std::array<Real, 3> change;  // of the screen weights
    for (std::size_t i = 0; i < 3; ++i) change[i] = static_cast<Real>(step[i]) * setup.inverse_area;
    Vec2<Real> d(change[0] * a[0] + change[1] * a[stride] + change[2] * a[2 * stride],
                 change[0] * a[1] + change[1] * a[stride + 1] + change[2] * a[2 * stride + 1]);
    if (inputs.divides()) {  // (u/z) / (1/z): the quotient rule
      const Real depth_change = weighted(change, setup.triangle->inverse_z);
      d.x = (d.x - uv.x * depth_change) * fragment.z;
      d.y = (d.y - uv.y * depth_change) * fragment.z;
    }
    return Vec2<Real>(d.x * size.x, d.y * size.y);
  };
  return {along(setup.edges.step_x), along(setup.edges.step_y)};
}

/// Where textures are read: at the surface's own coordinates, or where the line of sight meets its relief. How fast
/// they change follows the surface.
template <class Real>
struct TexturePlace {
  Vec2<Real> uv{0, 0};
  Vec2<Real> of_surface{0, 0};
};

/// What is the same wherever a fragment reads a texture: all but the place.
template <class Real>
struct FragmentLookup {
  const MipChain& chain;
  TextureLookup<Real> lookup;
  AnisotropicFootprint<Real> footprint;

  TextureSample<Real> read(const Vec2<Real>& uv, TexelNotes notes = nullptr) const {
    return footprint.taps > 1 ? sample_anisotropic(chain, uv, lookup, footprint, notes)
                              : sample_texture(chain, uv, lookup, notes);
  }
};

template <class Real>
FragmentLookup<Real> fragment_lookup(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                                     const Fragment<Real>& fragment, int index, const Vec2<Real>& uv_of_surface) {
  const MipChain& chain = (*inputs.textures)[static_cast<std::size_t>(index)];
  FragmentLookup<Real> how{chain, {inputs.settings.texture_filter, wrap_of(chain, inputs.settings), 0}, {}};
  if (how.lookup.filter == TextureFilter::trilinear || how.lookup.filter == TextureFilter::mipmap) {
    const TextureDerivatives<Real> derivatives = uv_derivatives(inputs, setup, fragment, uv_of_surface, *chain.base);
    const Real bias = static_cast<Real>(inputs.settings.mip_bias);
    const Vec2<Real> size(static_cast<Real>(chain.base->width()), static_cast<Real>(chain.base->height()));
    how.lookup.level = mip_level(derivatives, bias);
    if (inputs.settings.anisotropy > 1)
      how.footprint = anisotropic_footprint(derivatives, size, inputs.settings.anisotropy, bias);
  }
  return how;
}

/// A texture at the fragment (CGFS ch. 14): its colour, or what else it holds.
template <class Real, class Recorder>
TextureSample<Real> read_texture(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                                 const Fragment<Real>& fragment, int index, const TexturePlace<Real>& place,
                                 Recorder& recorder, TextureUse use = TextureUse::surface) {
  const FragmentLookup<Real> how = fragment_lookup(inputs, setup, fragment, index, place.of_surface);
  const TextureSample<Real> sample = how.read(place.uv);
  recorder.count(Counter::texel_reads, static_cast<std::uint64_t>(sample.texels));
  recorder.event([&] {
    TextureEvent event;
    event.texture = index;
    event.uv = Vec2d(place.uv);
    event.level = static_cast<double>(how.footprint.taps > 1 ? how.footprint.level : how.lookup.level);
    event.result = Vec3d(how.read(place.uv, &event.texels).colour);
    event.use = use;
    return event;
  });
  return sample;
}

template <class Real>
Vec3<Real> shading_normal(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                          const Fragment<Real>& fragment) {
  const int slot = setup.surface->layout.normal;
  if (slot == AttributeLayout::absent) return setup.triangle->face_normal;
  return interpolate3(inputs, setup, fragment, slot);
}

/// Normal mapping (CGFS ch. 15): the normal that the map holds, turned from tangent space to the world.
template <class Real, class Recorder>
Vec3<Real> map_normal(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                      const Fragment<Real>& fragment, const TexturePlace<Real>& place, const Vec3<Real>& normal,
                      Recorder& recorder) {
  const int slot = setup.surface->layout.tangents, index = setup.surface->material.normal_map;
  const TangentFrame<Real> frame{interpolate3(inputs, setup, fragment, slot),
                                 interpolate3(inputs, setup, fragment, slot + 3)};
  const auto& placing = setup.surface->placing;
  const auto space = placing ? tangent_space(normal, frame, *placing) : tangent_space(normal, frame);
  if (!space) return normal;
  const Vec3<Real> stored = stored_normal(read_texture(inputs, setup, fragment, index, place, recorder).colour);
  const Vec3<Real> mapped = mapped_normal(*space, stored);
  recorder.event([&] {
    return NormalMapEvent{index,         Vec2d(place.uv), Vec3d(stored), Vec3d(space->tangent), Vec3d(space->bitangent),
                          Vec3d(normal), Vec3d(mapped)};
  });
  return mapped;
}

/// Parallax mapping (shade/parallax_mapping.h): the texture coordinates that the relief shows.
template <class Real, class Recorder>
Vec2<Real> relief_uv(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                     const Vec2<Real>& uv, const Vec3<Real>& normal, Recorder& recorder) {
  const AttributeLayout& layout = setup.surface->layout;
  const ShadingMaterial<Real>& material = setup.surface->material;
  const TangentFrame<Real> frame{interpolate3(inputs, setup, fragment, layout.tangents),
                                 interpolate3(inputs, setup, fragment, layout.tangents + 3)};
  const Vec3<Real> to_eye = inputs.to_eye(interpolate3(inputs, setup, fragment, layout.position));
  const auto shift = relief_shift(normal, frame, to_eye, material.relief_depth, inputs.settings.parallax);
  if (!shift) return uv;
  const FragmentLookup<Real> how = fragment_lookup(inputs, setup, fragment, material.height_map, uv);
  const auto depth_at = [&](const Vec2<Real>& at) {
    const TextureSample<Real> sample = how.read(at);
    recorder.count(Counter::texel_reads, static_cast<std::uint64_t>(sample.texels));
    return Real(1) - sample.colour.x;
  };
  return parallax_uv(material.height_map, uv, *shift, inputs.settings, depth_at, recorder);
}

/// Light on the fragment: computed here (Phong), or carried over from the vertices (Gouraud) or the triangle (flat);
/// the recorder then gets the lighting events of those points.
template <class Real, class Recorder>
Lighting<Real> light_fragment(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                              const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                              const Vec3<Real>& normal, Recorder& recorder, std::optional<int> only_light) {
  const AttributeLayout& layout = setup.surface->layout;
  switch (inputs.settings.shading) {
  case Shading::phong: {
    const bool has_position = layout.position != AttributeLayout::absent;
    const Vec3<Real> position = has_position ? interpolate3(inputs, setup, fragment, layout.position) : Vec3<Real>(0);
    return light_at(inputs, *setup.surface, position, normal, recorder, only_light);
  }
  case Shading::gouraud: {
    if constexpr (Recorder::records) {
      const CornerSource<Real> source = corner_source(inputs, geometry, *setup.triangle);
      for (std::size_t k = 0; k < 3; ++k)
        light_of_point(inputs, setup, light_point(inputs, setup, fragment, source, k), recorder);
    }
    Lighting<Real> lighting;
    lighting.light = interpolate3(inputs, setup, fragment, layout.light);
    if (layout.extra != AttributeLayout::absent) lighting.extra = interpolate3(inputs, setup, fragment, layout.extra);
    return lighting;
  }
  case Shading::flat: {
    if constexpr (Recorder::records) {
      const FlatPoint<Real> point =
          flat_point(corner_source(inputs, geometry, *setup.triangle), inputs.settings.normals);
      light_of_point(inputs, setup, LightPoint<Real>{point.position, point.normal}, recorder);
    }
    return {flat_constant(setup, 0), flat_constant(setup, 1)};
  }
  }
  return {};
}

/// The surface as its maps of light make it at the fragment (MTL: map_Ks, map_Ka). Only Phong shading computes light
/// where they are read.
template <class Real, class Recorder>
Surface<Real> surface_at(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                         const Fragment<Real>& fragment, const TexturePlace<Real>& place, Recorder& recorder) {
  Surface<Real> own = *setup.surface;
  ShadingMaterial<Real>& material = own.material;
  if (material.specular_map >= 0)
    *material.specular_colour *=
        read_texture(inputs, setup, fragment, material.specular_map, place, recorder, TextureUse::highlight).colour;
  if (material.ambient_map >= 0)
    *material.ambient_colour *=
        read_texture(inputs, setup, fragment, material.ambient_map, place, recorder, TextureUse::ambient).colour;
  return own;
}

/// The value of the opacity map (MTL: map_d) at the fragment; 1 without one.
template <class Real, class Recorder>
Real mapped_opacity(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                    Recorder& recorder) {
  const Surface<Real>& surface = *setup.surface;
  if (surface.material.opacity_map < 0 || !inputs.settings.textures || surface.layout.uv == AttributeLayout::absent)
    return 1;
  TexturePlace<Real> place;
  place.uv = place.of_surface = {interpolate(inputs, setup, fragment, surface.layout.uv),
                                 interpolate(inputs, setup, fragment, surface.layout.uv + 1)};
  const int map = surface.material.opacity_map;
  return read_texture(inputs, setup, fragment, map, place, recorder, TextureUse::opacity).colour.x;
}

/// Whether the opacity map leaves less than half of the surface at the fragment. Without blending fragments are there
/// or not.
template <class Real, class Recorder>
bool is_cut_out(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                Recorder& recorder) {
  return !blends(inputs.settings) && mapped_opacity(inputs, setup, fragment, recorder) < Real(0.5);
}

/// The weight of the fragment's colour when it is blended with what the pixel holds (CGPP 15.7.1.3): what the material
/// does not let through, times its opacity map. 1 for all fragments without blending.
template <class Real, class Recorder>
Real opacity_of(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                Recorder& recorder) {
  if (!blends(inputs.settings)) return 1;
  return (Real(1) - setup.surface->material.transparency) * mapped_opacity(inputs, setup, fragment, recorder);
}

/// The output merger: a fragment over what the pixel holds. Opaque ones replace it, bit for bit.
template <class Real>
Vec3<Real> blend_over(const Vec3<Real>& source, const Vec3<Real>& destination, Real opacity) {
  return opacity == Real(1) ? source : source * opacity + destination * (Real(1) - opacity);
}

/// The fragment's colour mixed with what the material's picture of its surroundings (MTL: refl) shows in the mirrored
/// direction of view, as mirror_environment() does with a picture of the scene.
template <class Real, class Recorder>
Vec3<Real> reflect_picture(const RasterInputs<Real>& inputs, const TriangleSetup<Real>& setup,
                           const Fragment<Real>& fragment, const Vec3<Real>& normal, const Vec3<Real>& local,
                           std::optional<int> only_light, Recorder& recorder) {
  const ShadingMaterial<Real>& material = setup.surface->material;
  const Real reflective = material.reflective;
  if (only_light.value_or(0) != 0) return local * (1 - reflective);  // the rest came with the first light
  const Vec3<Real> to_eye = inputs.to_eye(interpolate3(inputs, setup, fragment, setup.surface->layout.position));
  const Image<Vec3f>& picture = *(*inputs.textures)[static_cast<std::size_t>(material.reflection_map)].base;
  const Vec3<Real> reflected = read_reflection_map(picture, material.reflection_map, material.surroundings,
                                                   mirror(to_eye, normal), inputs.settings.texture_filter, recorder);
  const Vec3<Real> result = local * (1 - reflective) + reflected * reflective;
  recorder.event([&] {
    return ReflectionEvent{static_cast<double>(reflective), Vec3d(local), Vec3d(reflected), Vec3d(result)};
  });
  return result;
}

/// The colour that a fragment has of its own (CGFS ch. 13 and 14).
template <class Real, class Recorder>
ShadedFragment<Real> own_colour(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                                const TriangleSetup<Real>& setup, const Fragment<Real>& fragment, Recorder& recorder,
                                std::optional<int> only_light) {
  const Surface<Real>& surface = *setup.surface;
  const AttributeLayout& layout = surface.layout;
  ShadedFragment<Real> shaded;
  recorder.count(Counter::attributes_interpolated, static_cast<std::uint64_t>(layout.count));
  Vec3<Real> colour = surface.material.colour;
  Vec3<Real> normal(0);
  if (layout.shading_normal) normal = shading_normal(inputs, setup, fragment);
  TexturePlace<Real> place;
  if (layout.uv != AttributeLayout::absent) {
    place.of_surface = {interpolate(inputs, setup, fragment, layout.uv),
                        interpolate(inputs, setup, fragment, layout.uv + 1)};
    place.uv =
        layout.relief ? relief_uv(inputs, setup, fragment, place.of_surface, normal, recorder) : place.of_surface;
    shaded.uv = place.uv;
    if (inputs.settings.textures && surface.material.texture >= 0) {
      const auto sample = read_texture(inputs, setup, fragment, surface.material.texture, place, recorder);
      shaded.mip = sample.level;
      colour *= sample.colour;
    }
  }
  if (layout.shading_normal) {
    if (layout.mapped_normal) normal = map_normal(inputs, setup, fragment, place, normal, recorder);
    shaded.normal = unit_or_zero(normal);
    if (inputs.settings.renormalise) normal = shaded.normal;
  }
  shaded.colour = colour;
  if (!layout.lit) return shaded;
  const auto light_on = [&](const TriangleSetup<Real>& lit) {
    return inputs.has_shadows()
               ? shadowed_light(inputs, geometry, lit, fragment, normal, shaded.shadow_mask, recorder, only_light)
               : light_fragment(inputs, geometry, lit, fragment, normal, recorder, only_light);
  };
  Lighting<Real> lighting;
  if (layout.light_maps) {
    const Surface<Real> own = surface_at(inputs, setup, fragment, place, recorder);
    TriangleSetup<Real> lit = setup;
    lit.surface = &own;
    lighting = light_on(lit);
  } else {
    lighting = light_on(setup);
  }
  shaded.colour = colour * lighting.light + lighting.extra;
  recorder.event([&] {
    ShadeEvent event;
    event.surface = Vec3d(colour);
    event.light = Vec3d(lighting.light);
    event.extra = Vec3d(lighting.extra);
    event.local = Vec3d(shaded.colour);
    return event;
  });
  return shaded;
}

/// The colour of a fragment with its reflection, under all lights or, with Phong shading, only one of them; what is
/// mirrored then comes with the first.
template <class Real, class Recorder>
ShadedFragment<Real> shade_fragment(const RasterInputs<Real>& inputs, const ScreenGeometry<Real>& geometry,
                                    const TriangleSetup<Real>& setup, const Fragment<Real>& fragment,
                                    Recorder& recorder, std::optional<int> only_light = {}) {
  ShadedFragment<Real> shaded = own_colour(inputs, geometry, setup, fragment, recorder, only_light);
  if (setup.surface->layout.reflection_map)
    shaded.colour = reflect_picture(inputs, setup, fragment, shaded.normal, shaded.colour, only_light, recorder);
  else if (inputs.environment)
    shaded.colour = mirror_environment(inputs, setup, fragment, shaded.normal, shaded.colour, only_light, recorder);
  return shaded;
}

}  // namespace ps::raster
