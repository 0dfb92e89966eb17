#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_texture(const Settings& s, const SceneTraits& t) {
  if (!t.textures) return "the scene has no texture";
  if (const auto reason = needs_filled_fragments(s)) return reason;
  return {};
}

Reason needs_textures_on(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_texture(s, t)) return reason;
  if (!s.textures) return needs("textures", true);
  return {};
}

Reason needs_normal_map(const Settings& s, const SceneTraits& t) {
  if (!t.normal_maps) return "the scene has no normal map";
  if (!s.lighting) return needs("lighting", true).said("needs lighting");
  if (sends_rays(s.renderer)) return {};
  if (!fills(s.draw)) return needs("draw", Draw::filled);
  if (s.shading != Shading::phong)
    return needs("shading", Shading::phong).because("other shading evaluates the lighting per vertex or triangle");
  return {};
}

Reason needs_mapped_normals(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_normal_map(s, t)) return reason;
  if (!s.normal_mapping) return needs("normal-mapping", true);
  if (!t.stretched) return "no model of the scene has an unequal scale";
  return {};
}

Reason needs_height_map(const Settings& s, const SceneTraits& t) {
  if (!t.height_maps) return "the scene has no height map";
  if (const auto reason = needs_filled_fragments(s)) return reason;
  return {};
}

Reason needs_relief_steps(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_height_map(s, t)) return reason;
  if (s.parallax != Parallax::steep && s.parallax != Parallax::occlusion)
    return needs("parallax-mapping", Parallax::steep, Parallax::occlusion).said("needs parallax = steep or occlusion");
  return {};
}

Reason needs_mipmaps(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_textures_on(s, t)) return reason;
  if (s.texture_filter != TextureFilter::trilinear && s.texture_filter != TextureFilter::mipmap)
    return needs("texture-filter", TextureFilter::mipmap, TextureFilter::trilinear);
  return {};
}

}  // namespace

std::vector<Option> texture_rows() {
  return {
      toggle<&Settings::textures>(
          {.key = "textures",
           .label = "Textures",
           .help = {"Applies texture images to surfaces.", "CGFS ch. 14", ""},
           .keywords = "texture mapping, image, uv, decal",
           .truth = pixel_average("textures=on;texture-filter=bilinear"),
           .inactive = needs_texture,
           .known_to = {.fast = {knows(fragment_batches, 140, false)
                                     .where(&SceneTraits::opacity_maps)
                                     .said("SIMD cuts nothing out by opacity maps"),
                                 limit(fragment_batches, 150, "SIMD does not support reflection maps",
                                       [](const Settings& s, const SceneTraits& t) {
                                         return s.textures && t.reflection_maps && s.reflection_depth > 0;
                                       })},
                        .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/brick-wall"}}}}),
      choice<&Settings::texture_filter>(
          {.key = "texture-filter",
           .label = "Filter",
           .help = {"How a colour is computed from the texels around a point.", "CGFS ch. 14",
                    "Nearest shows blocks near by and sparkles far away; mipmaps blur at grazing angles. Rays read "
                    "level 0, so trilinear and mipmap look like bilinear there."},
           .keywords =
               "texel, bilinear, trilinear, nearest, mipmap, mip, minification, magnification, aliasing, moire, "
               "shimmer, pixelated, blur",
           .truth = pixel_average("texture-filter=bilinear"),
           .inactive = needs_textures_on,
           .known_to = {.fast = any_value, .hardware = defined_as("TEXTURE_FILTER")},
           .shown_by = {.experiments = {{"mipmap-lod",
                                         [](const Settings& s) {
                                           return s.texture_filter == TextureFilter::nearest ||
                                                  s.texture_filter == TextureFilter::bilinear;
                                         },
                                         "texture-filter=trilinear"}},
                        .scenes = {{"cgfs/crates", "", PictureWay::fragments}}}},
          {{"trilinear", "trilinear", "Bilinear in the two nearest mip levels, blended."},
           {"mipmap", "mipmap", "Bilinear in the nearest mip level."},
           {"bilinear", "bilinear", "Weighted mean of the four texels around the point."},
           {"nearest", "nearest", "The texel that contains the point."}}),
      real<&Settings::mip_bias>(
          {.key = "mip-bias",
           .label = "Mip bias",
           .help = {"Added to the computed mip level.", "CGFS ch. 14",
                    "Negative: sharper, with sparkle. Positive: blurred. The RMS error is least near -0.5 "
                    "(experiment mipmap-lod)."},
           .keywords = "LOD bias, mipmap, level of detail, blur, sharpness",
           .truth = pixel_average("texture-filter=bilinear"),
           .acts_for = ActsFor::fragments,
           .only_for = "no effect: rays have no footprint and read level 0",
           .inactive = needs_mipmaps,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"mipmap-lod",
                                         [](const Settings& s) { return s.mip_bias < -1 || s.mip_bias > 1; },
                                         "mip-bias=0"}},
                        .scenes = {{"cgfs/crates"}}}},
          -4, 4, OptionScale::linear, "levels"),
      integer<&Settings::anisotropy>(
          {.key = "anisotropy",
           .label = "Anisotropy",
           .help = {"Maximum number of lookups along the long axis of the pixel's footprint; the short axis chooses "
                    "the mip level.",
                    "CGFS ch. 14; hardware offers up to 16",
                    "Too small: distant ground is blurred. Each doubling costs up to twice the texel reads."},
           .keywords = "anisotropic filtering, AF, mipmap, grazing angle, blur",
           .truth = pixel_average("texture-filter=bilinear"),
           .acts_for = ActsFor::fragments,
           .only_for = "no effect: rays have no footprint and read level 0",
           .inactive = needs_mipmaps,
           .known_to = {.fast = {knows(fragment_batches, 160, 1)}, .hardware = any_value},
           .shown_by = {.experiments = {{"mipmap-lod"}}, .scenes = {{"cgfs/crates"}}}},
          1, 16, "taps"),
      choice<&Settings::hardware_texturing>(
          {.key = "hardware-texturing",
           .label = "Hardware texturing",
           .help = {"What filters textures on a graphics processor.", "OpenGL 3.3, 3.8.9 to 3.8.11",
                    "A driver may approximate the level of detail and round filter weights to 8 bits."},
           .keywords = "sampler, texture unit, texelFetch, filtering, GPU, OpenGL",
           .truth = pixel_average("hardware-texturing=shader;texture-filter=bilinear"),
           .acts_for = ActsFor::readers,
           .only_for = "only the hardware renderer uses it",
           .inactive = needs_textures_on,
           .known_to = {.fast = any_value, .hardware = defined_as("HARDWARE_TEXTURING")},
           .shown_by = {.experiments = {{"driver-level"}}, .scenes = {{"cgfs/crates"}}}},
          {{"shader", "in the shader", "The formula of the rasterizer, texel by texel."},
           {"driver", "by the driver", "The driver's filter and level of detail."}}),
      choice<&Settings::texture_wrap>({.key = "texture-wrap",
                                       .label = "Wrap",
                                       .help = {"What lookups outside the texture return.", "CGFS ch. 14", ""},
                                       .keywords = "repeat, clamp, mirror, address mode, tiling, border",
                                       .truth = other_picture(),
                                       .inactive = needs_textures_on,
                                       .known_to = {.fast = any_value, .hardware = any_value},
                                       .shown_by = {.experiments = none, .scenes = {{"cgfs/brick-wall"}}}},
                                      {{"repeat", "repeat", "The texture repeats."},
                                       {"clamp", "clamp", "The nearest border texel."},
                                       {"mirror", "mirror", "The texture repeats, mirrored every second time."}}),
      toggle<&Settings::normal_mapping>(
          {.key = "normal-mapping",
           .label = "Normal mapping",
           .help = {"Shades with normals from an image in tangent space: red along u, green towards the top of the "
                    "image, blue along the surface normal.",
                    "CGFS ch. 15; normal mapping after OBJ files",
                    "Outlines and shadows stay those of the flat surface, which is visible at grazing angles."},
           .keywords = "bump map, bump mapping, normal map, tangent space, relief",
           .truth = exactly("normal-mapping=on"),
           .inactive = needs_normal_map,
           .known_to = {.fast = {limit(every_fragment, 30, "normal maps are shaded one fragment at a time",
                                       [](const Settings& s, const SceneTraits& t) {
                                         return s.normal_mapping && t.normal_maps && s.lighting &&
                                                s.shading == Shading::phong && t.casting_lights;
                                       })},
                        .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/brick-wall"}}}}),
      choice<&Settings::mapped_normals>(
          {.key = "mapped-normals",
           .label = "Mapped normals",
           .help =
               {"Where a normal from a map becomes one of the world: in axes upright in the world, or in the model's, "
                "by the inverse transpose of the model's matrix.",
                "OCT (normal mapping); CGFS ch. 15",
                "Axes of the world keep a relief's slopes although its model is stretched: at scale (1, 3, 1) a slope "
                "of 37 degrees along y stays 37, in place of 14. From below it can get 28 % of a light, in place of "
                "49 %."},
           .keywords = "inverse transpose, tangent space, TBN, normal matrix, non-uniform scale, bump map",
           .truth = exactly("mapped-normals=inverse-transpose"),
           .inactive = needs_mapped_normals,
           .known_to = {.fast = any_value, .hardware = defined_as("MAPPED_NORMALS")},
           .shown_by = {.experiments = none, .scenes = {{"stretched_relief.scene"}}}},
          {{"world-frame", "upright in the world", "Slopes are those of the map, whatever the scale."},
           {"inverse-transpose", "inverse transpose", "Slopes are stretched with the model."}}),
      choice<&Settings::parallax>(
          {.key = "parallax-mapping",
           .label = "Parallax mapping",
           .help = {"A height map stores how far the relief lies below its triangles; textures are read where the line "
                    "of sight meets the relief.",
                    "Kaneko et al. 2001; Welsh 2004; McGuire and McGuire 2005; Tatarchuk 2006",
                    "Outlines, depth and shadows stay flat; at grazing angles offsets swim and steps show as slices."},
           .keywords = "relief mapping, height map, displacement, bump, parallax occlusion",
           .truth = exactly("parallax-mapping=occlusion;parallax-steps=256"),
           .inactive = needs_height_map,
           .known_to = {.fast = {knows(every_fragment, 20, Parallax::off)
                                     .where(&SceneTraits::height_maps)
                                     .said("reliefs are shaded one fragment at a time")},
                        .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/relief", "parallax-mapping=steep"}}}},
          {{"off", "off", "The texture lies on the surface."},
           {"offset", "offset", "Shifts by the relief's depth below the point: too far at grazing angles."},
           {"limited", "offset, limited", "Limits the shift to the depth: stable at grazing angles, but too flat."},
           {"steep", "steep", "Steps along the line of sight until a step lies inside the relief: exact to one step."},
           {"occlusion", "occlusion", "The same, then intersects the straight lines through the last two samples."}}),
      integer<&Settings::parallax_steps>(
          {.key = "parallax-steps",
           .label = "Parallax steps",
           .help =
               {"Number of steps from the top of the relief to its bottom.", "McGuire and McGuire 2005",
                "Too few: the relief shows slices and misses details thinner than a step. Each step reads the map."},
           .keywords = "relief mapping, height map, ray march, slices",
           .truth = exactly("parallax-steps=256"),
           .inactive = needs_relief_steps,
           .known_to = {.fast = any_value, .hardware = defined_as("PARALLAX_STEPS")},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/relief", "parallax-mapping=steep"}}}},
          1, 256, "steps"),
  };
}

}  // namespace ps::rows
