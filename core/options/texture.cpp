#include "options/renderer_kind.h"
#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_texture(const Settings& s, const SceneTraits& t) {
  if (!t.textures) return "the scene has no texture";
  if (draws_fragments(s.renderer) && s.draw != Draw::filled) return "needs draw = filled";
  return {};
}

Reason needs_textures_on(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_texture(s, t)) return reason;
  if (!s.textures) return "needs textures = on";
  return {};
}

Reason needs_normal_map(const Settings& s, const SceneTraits& t) {
  if (!t.normal_maps) return "the scene has no normal map";
  if (!s.lighting) return "needs lighting";
  if (sends_rays(s.renderer)) return {};
  if (s.draw != Draw::filled) return "needs draw = filled";
  if (s.shading != Shading::phong) return "needs shading = phong: light is computed at corners";
  return {};
}

Reason needs_height_map(const Settings& s, const SceneTraits& t) {
  if (!t.height_maps) return "the scene has no height map";
  if (draws_fragments(s.renderer) && s.draw != Draw::filled) return "needs draw = filled";
  return {};
}

Reason needs_relief_steps(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_height_map(s, t)) return reason;
  if (s.parallax != Parallax::steep && s.parallax != Parallax::occlusion) return "needs parallax = steep or occlusion";
  return {};
}

Reason needs_mipmaps(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_textures_on(s, t)) return reason;
  if (sends_rays(s.renderer)) return "rays have no footprint: they read the finest level";
  if (s.texture_filter != TextureFilter::trilinear && s.texture_filter != TextureFilter::mipmap)
    return "needs texture-filter = mipmap or trilinear";
  return {};
}

}  // namespace

std::vector<Option> texture_rows() {
  return {
      toggle<&Settings::textures>({.key = "textures",
                                   .label = "Textures",
                                   .help = {"Surfaces wear their pictures.", "CGFS ch. 14", ""},
                                   .truth = exactly("textures=on"),
                                   .inactive = needs_texture}),
      choice<&Settings::texture_filter>(
          {.key = "texture-filter",
           .label = "Filter",
           .help = {"How the texture is read between and across its texels.", "CGFS ch. 14",
                    "Nearest shows blocks near by and sparkles far away; mipmaps blur at grazing angles. Rays read "
                    "the finest level, so for them trilinear and mipmap look like bilinear."},
           .truth = pixel_average("texture-filter=bilinear"),
           .inactive = needs_textures_on},
          {{"trilinear", "trilinear", "Bilinear in the two nearest mip levels, mixed."},
           {"mipmap", "mipmap", "Bilinear in the nearest mip level."},
           {"bilinear", "bilinear", "The four texels around the point, weighted."},
           {"nearest", "nearest", "The texel that holds the point."}}),
      real<&Settings::mip_bias>(
          {.key = "mip-bias",
           .label = "Mip bias",
           .help = {"Added to the level of detail.", "CGFS ch. 14",
                    "Negative: sharper, with sparkle. Positive: blurred. The RMS error is least near -0.5 "
                    "(experiment mipmap-lod)."},
           .truth = pixel_average("texture-filter=bilinear"),
           .inactive = needs_mipmaps},
          -4, 4, OptionScale::linear, "levels"),
      integer<&Settings::anisotropy>(
          {.key = "anisotropy",
           .label = "Anisotropy",
           .help =
               {"How many lookups may share a pixel that sees the texture at a flat angle: along its long side, each "
                "at the level that suits the short one.",
                "CGFS ch. 14; hardware offers up to 16",
                "At 1 far ground is a blur; each doubling costs up to twice the texels."},
           .truth = pixel_average("texture-filter=bilinear"),
           .inactive = needs_mipmaps},
          1, 16, "taps"),
      choice<&Settings::texture_wrap>({.key = "texture-wrap",
                                       .label = "Wrap",
                                       .help = {"What lies beyond the texture's border.", "CGFS ch. 14", ""},
                                       .truth = as_set(),
                                       .inactive = needs_textures_on},
                                      {{"repeat", "repeat", "The picture again."},
                                       {"clamp", "clamp", "Its border texels."},
                                       {"mirror", "mirror", "The picture mirrored."}}),
      toggle<&Settings::normal_mapping>(
          {.key = "normal-mapping",
           .label = "Normal mapping",
           .help =
               {"Light falls on normals that a picture holds, turned from tangent space to the surface. Red is along "
                "u, green towards the top of the picture, blue along the surface's own normal.",
                "CGFS ch. 15; normal mapping after OBJ files",
                "Outlines and shadows stay those of the flat surface; seen edge-on, the trick shows."},
           .truth = exactly("normal-mapping=on"),
           .inactive = needs_normal_map}),
      choice<&Settings::parallax>(
          {.key = "parallax-mapping",
           .label = "Parallax mapping",
           .help =
               {"A height map says how far the surface lies below its triangles; textures are read where the line of "
                "sight meets that relief.",
                "Kaneko et al. 2001; Welsh 2004; McGuire and McGuire 2005; Tatarchuk 2006",
                "Outlines, depth and shadows stay flat; at a flat angle offsets swim and steps show as slices."},
           .truth = exactly("parallax-mapping=occlusion;parallax-steps=256"),
           .inactive = needs_height_map},
          {{"off", "off", "The picture lies on the surface."},
           {"offset", "offset", "The depth below the point decides the shift: too far where the view is flat."},
           {"limited", "offset, limited", "Never shifted by more than the depth: calm at flat angles, and too flat."},
           {"steep", "steep", "Walks down in steps until one lies inside the relief: right to one step."},
           {"occlusion", "occlusion", "The same, then the crossing of straight lines through the last two readings."}}),
      integer<&Settings::parallax_steps>(
          {.key = "parallax-steps",
           .label = "Parallax steps",
           .help = {"Steps from the top of a relief to its bottom.", "McGuire and McGuire 2005",
                    "Few of them slice the relief and miss what is thinner than a step; each may read the map."},
           .truth = exactly("parallax-steps=256"),
           .inactive = needs_relief_steps},
          1, 256, "steps"),
  };
}

}  // namespace ps::rows
