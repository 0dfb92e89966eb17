#include "options/renderer_kind.h"
#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_lighting(const Settings& s, const SceneTraits& t) {
  if (draws_fragments(s.renderer) && s.draw != Draw::filled) return "needs draw = filled";
  if (!t.casting_lights) return "the scene has no point or directional light";
  if (!s.lighting) return "needs lighting = on";
  return {};
}

Reason needs_lit_fragments(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  return needs_lighting(s, t);
}

Reason needs_vertex_normals(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_lighting(s, t)) return reason;
  if (draws_fragments(s.renderer) && t.spheres) return {};
  if (!t.vertex_normals) return "no model of the scene has vertex normals";
  return {};
}

Reason needs_interpolated_normals(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_vertex_normals(s, t)) return reason;
  if (s.normals != Normals::vertex) return "needs normals = vertex";
  if (draws_fragments(s.renderer) && s.shading != Shading::phong) return "needs shading = phong";
  return {};
}

Reason needs_highlights(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_lighting(s, t)) return reason;
  if (!t.specular) return "no material of the scene shines";
  return {};
}

Reason needs_visible_highlights(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_highlights(s, t)) return reason;
  if (!s.specular) return "needs specular = on";
  return {};
}

Reason needs_surfaces(const Settings&, const SceneTraits& t) {
  if (!t.spheres && !t.triangles && !t.solids && !t.csg) return "the scene has no surface that light could fall on";
  return {};
}

Reason needs_several_lights(const Settings& s, const SceneTraits& t) {
  if (draws_fragments(s.renderer) && s.draw != Draw::filled) return "needs draw = filled";
  if (!t.several_lights) return "the scene has fewer than two lights";
  if (!s.lighting) return "needs lighting = on";
  return {};
}

Reason needs_attributes(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_fragments(s, t)) return reason;
  if (s.draw != Draw::filled) return "needs draw = filled";
  return {};
}

}  // namespace

std::vector<Option> shading_rows() {
  return {
      toggle<&Settings::lighting>({.key = "lighting",
                                   .label = "Lighting",
                                   .help = {"Off: every surface shows its own colour.", "CGFS ch. 2 against ch. 3",
                                            "Without light, shapes look flat."},
                                   .truth = exactly("lighting=on"),
                                   .inactive = needs_surfaces}),
      integer<&Settings::light_shown>(
          {.key = "light-shown",
           .label = "Light shown",
           .help = {"Lets one light shine alone, by its number in the scene: what its own pass adds to the picture. 0 "
                    "shows all.",
                    "CGFS ch. 15; CGPP 15.7.2.3",
                    "The pictures of the single lights add up to the whole, unless a colour is clamped."},
           .truth = exactly("light-shown=0"),
           .inactive = needs_several_lights},
          0, 16),
      choice<&Settings::shading>(
          {.key = "shading",
           .label = "Shading",
           .help = {"Where the illumination equation is evaluated on a triangle.", "CGFS ch. 13",
                    "Gouraud misses highlights that fall between the corners; flat shows the facets."},
           .truth = exactly("shading=phong"),
           .inactive = needs_lit_fragments},
          {{"phong", "Phong", "At every pixel, with interpolated normals."},
           {"gouraud", "Gouraud", "At the corners; the light is interpolated."},
           {"flat", "flat", "Once, in the middle of the triangle."}}),
      choice<&Settings::normals>(
          {.key = "normals",
           .label = "Normals",
           .help = {"Which way the surface is said to face.", "CGFS ch. 13",
                    "Triangle normals show facets; vertex normals hide them but not the outline."},
           .truth = exactly("normals=vertex"),
           .inactive = needs_vertex_normals},
          {{"vertex", "of the vertices", "Given by the model, interpolated between corners."},
           {"triangle", "of the triangle", "Perpendicular to it."}}),
      toggle<&Settings::renormalise>({.key = "renormalise",
                                      .label = "Renormalise",
                                      .help = {"Brings interpolated normals back to length 1.", "CGFS ch. 13",
                                               "Without it the shortened normal changes highlights between corners."},
                                      .truth = exactly("renormalise=on"),
                                      .inactive = needs_interpolated_normals}),
      choice<&Settings::normal_transform>(
          {.key = "normal-transform",
           .label = "Normal transform",
           .help = {"How normals follow a model's transform.", "LAB 7; OCT",
                    "Under unequal scales the model matrix tilts normals: at a scale of 2 by up to 37 degrees, which "
                    "changes "
                    "the diffuse light of a ball by 44 of 255 levels (RMS)."},
           .truth = exactly("normal-transform=inverse-transpose"),
           .inactive = needs_vertex_normals},
          {{"inverse-transpose", "inverse transpose", "Stays perpendicular to the surface."},
           {"model", "model matrix", "As positions are transformed; wrong under unequal scales."}}),
      choice<&Settings::illumination>(
          {.key = "illumination",
           .label = "Illumination",
           .help = {"What a light's intensity means and how a surface answers.", "CGFS ch. 3; CGPP 15.4",
                    "Radiometric pictures need an exposure and a gamma to look right."},
           .truth = as_set(),
           .inactive = needs_lighting},
          {{"book", "the book's",
            "Relative intensities without distance fall-off; matte surfaces stay below 1 if they sum to 1, highlights "
            "may exceed it."},
           {"radiometric", "radiometric",
            "A point light's intensity is its power: power / (4 pi r^2) arrives. Lambert scatters 1 / pi of it, "
            "highlights are normalised so that sharper ones are brighter."}}),
      toggle<&Settings::attenuation>(
          {.key = "attenuation",
           .label = "Attenuation",
           .help = {"Point lights grow weaker with distance by their constant, linear and quadratic factors.", "OCT",
                    "With a small constant, surfaces near the light are overexposed."},
           .truth = exactly("attenuation=on"),
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_lighting(s, t)) return reason;
             if (!t.attenuated) return "no point light of the scene has attenuation factors";
             if (s.illumination != Illumination::book) return "needs illumination = book";
             return {};
           }}),
      toggle<&Settings::specular>({.key = "specular",
                                   .label = "Highlights",
                                   .help = {"Adds the mirror-like reflection of the lights.", "CGFS ch. 3", ""},
                                   .truth = exactly("specular=on"),
                                   .inactive = needs_highlights}),
      choice<&Settings::highlight>(
          {.key = "highlight",
           .label = "Highlight model",
           .help = {"Which angle the highlight depends on.", "CGFS ch. 3; OCT",
                    "The same exponent gives a wider highlight with N.H than with R.V."},
           .truth = as_set(),
           .inactive = needs_visible_highlights},
          {{"phong", "R.V (Phong)", "Between the mirrored light and the viewer."},
           {"blinn-phong", "N.H (Blinn-Phong)", "Between the normal and the middle of light and viewer."}}),
      choice<&Settings::interpolation>(
          {.key = "interpolation",
           .label = "Interpolation",
           .help = {"How values at the corners spread across a triangle.", "CGFS ch. 12 and 14; LAB 6",
                    "Affine textures bend and swim along the triangle's diagonal."},
           .truth = exactly("interpolation=perspective"),
           .inactive = needs_attributes},
          {{"perspective", "perspective-correct", "value/z and 1/z are linear on the screen; one division a pixel."},
           {"affine", "affine", "The value itself is taken to be linear on the screen."}}),
  };
}

}  // namespace ps::rows
