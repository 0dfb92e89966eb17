#include <array>
#include <string>
#include <utility>

#include "options/rows.h"

namespace ps::rows {
namespace {

Reason needs_lighting(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_filled_fragments(s)) return reason;
  if (!t.casting_lights) return "the scene has no point or directional light";
  if (!s.lighting) return needs("lighting", true);
  return {};
}

Reason needs_lit_fragments(const Settings& s, const SceneTraits& t) { return needs_lighting(s, t); }

Reason needs_vertex_normals(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_lighting(s, t)) return reason;
  if (draws_fragments(s.renderer) && t.spheres) return {};
  if (!t.vertex_normals) return "no model of the scene has vertex normals";
  return {};
}

Reason needs_interpolated_normals(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_vertex_normals(s, t)) return reason;
  if (s.normals != Normals::vertex) return needs("normals", Normals::vertex);
  if (draws_fragments(s.renderer) && s.shading != Shading::phong) return needs("shading", Shading::phong);
  return {};
}

Reason needs_highlights(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_lighting(s, t)) return reason;
  if (!t.specular) return "no material of the scene has highlights";
  return {};
}

Reason needs_visible_highlights(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_highlights(s, t)) return reason;
  if (!s.specular) return needs("specular", true);
  return {};
}

Reason needs_surfaces(const Settings&, const SceneTraits& t) {
  if (!t.spheres && !t.triangles && !t.solids && !t.csg) return "the scene has no surface to light";
  return {};
}

Reason needs_several_lights(const Settings& s, const SceneTraits& t) {
  if (const auto reason = needs_filled_fragments(s)) return reason;
  if (t.light_count < 2) return "the scene has fewer than two lights";
  if (!s.lighting) return needs("lighting", true);
  return {};
}

Reason needs_attributes(const Settings& s, const SceneTraits&) {
  if (!fills(s.draw)) return needs("draw", Draw::filled);
  return {};
}

template <std::size_t Light>
Reason needs_light(const Settings&, const SceneTraits& t) {
  return t.light_count > Light ? Reason{} : "the scene has no such light";
}

/// "all", then one choice for each index.
template <std::size_t... Light>
std::vector<Choice> light_choices(std::index_sequence<Light...>) {
  static const std::array keys{std::to_string(Light)...};
  static const std::array labels{"light " + std::to_string(Light)...};
  return {{"all", "all", "All lights."}, {keys[Light], labels[Light], "This light alone.", needs_light<Light>}...};
}

Option light_shown_row() {
  constexpr std::size_t most_lights = 16;
  Option option = choice<&Settings::light_shown>(
      {.key = "light-shown",
       .label = "Light shown",
       .help = {"Shows the contribution of one light, or of all.", "CGFS ch. 15; CGPP 15.7.2.3",
                "The pictures of the single lights add up to the full one, unless a colour is clamped."},
       .keywords = "solo, single light, isolate a light",
       .truth = other_picture(),
       .inactive = needs_several_lights,
       .known_to = {.fast = any_value, .hardware = any_value},
       .shown_by = {.experiments = none, .scenes = {{"sixteen_lights.scene"}}}},
      light_choices(std::make_index_sequence<most_lights>()));
  option.sweep_values = "all,0,1,2";  // most scenes have no more lights
  option.get = [](const Settings& settings) { return static_cast<OptionNumber>(settings.light_shown - all_lights); };
  option.set = [](Settings& settings, OptionNumber number) {
    settings.light_shown = static_cast<int>(number) + all_lights;
  };
  return option;
}

}  // namespace

std::vector<Option> shading_rows() {
  return {
      toggle<&Settings::lighting>({.key = "lighting",
                                   .label = "Lighting",
                                   .help = {"Evaluates the lights. Off: every surface shows its local colour.",
                                            "CGFS ch. 2 against ch. 3", "Without lighting, shapes look flat."},
                                   .keywords = "illumination, shade, unlit, flat colour",
                                   .truth = exactly("lighting=on"),
                                   .inactive = needs_surfaces,
                                   .known_to = {.fast = any_value, .hardware = any_value},
                                   .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}}),
      light_shown_row(),
      choice<&Settings::shading>(
          {.key = "shading",
           .label = "Shading",
           .help = {"Where on a triangle the lighting equation is evaluated.", "CGFS ch. 13",
                    "Gouraud shading misses highlights between the vertices; flat shading shows the facets."},
           .keywords = "Gouraud, Phong, flat, facets, per pixel, per vertex, smooth shading, interpolation",
           .truth = exactly("shading=phong"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_lit_fragments,
           .known_to = {.fast = {limit(whole_tiles, 60, "whole tiles need shading = phong",
                                       [](const Settings& s, const SceneTraits&) {
                                         return s.lighting && s.shading != Shading::phong;
                                       })},
                        .hardware = any_value},
           .shown_by = {.experiments = {{"gouraud-highlight", is<&Settings::shading, Shading::gouraud>,
                                         "shading=phong"}},
                        .scenes = {{"cgfs/shading"}}}},
          {{"phong", "Phong", "At every pixel, with interpolated normals."},
           {"gouraud", "Gouraud", "At the vertices; the resulting light is interpolated."},
           {"flat", "flat", "Once, at the centre of the triangle."}}),
      choice<&Settings::normals>(
          {.key = "normals",
           .label = "Normals",
           .help = {"Which normals shading uses.", "CGFS ch. 13",
                    "Triangle normals show facets; vertex normals hide them but not the outline."},
           .keywords = "smooth, facets, vertex normal, face normal, smooth shading",
           .truth = exactly("normals=vertex"),
           .inactive = needs_vertex_normals,
           .known_to = {.fast = any_value, .hardware = defined_as("TRIANGLE_NORMALS")},
           .shown_by = {.experiments = {{"shadow-terminator"}},
                        .scenes = {{"cgfs/shading", "triangle-test=moeller-trumbore"}}}},
          {{"vertex", "of the vertices", "Stored in the model, interpolated between the vertices."},
           {"triangle", "of the triangle", "Perpendicular to the triangle."}}),
      toggle<&Settings::renormalise>(
          {.key = "renormalise",
           .label = "Renormalise",
           .help = {"Scales interpolated normals to length 1.", "CGFS ch. 13",
                    "Off: shortened normals change highlights between the vertices."},
           .keywords = "normalize, normalise, unit normal, interpolated normal",
           .truth = exactly("renormalise=on"),
           .inactive = needs_interpolated_normals,
           .known_to = {.fast = any_value, .hardware = defined_as("RENORMALISE")},
           .shown_by = {.experiments = {{"unnormalised-interpolated-normals", is<&Settings::renormalise, false>,
                                         "renormalise=on"}},
                        .scenes = {{"cgfs/shading", "triangle-test=moeller-trumbore"}}}}),
      choice<&Settings::normal_transform>(
          {.key = "normal-transform",
           .label = "Normal transform",
           .help = {"The matrix that transforms normals into world space.", "LAB 7; OCT",
                    "The model matrix tilts normals if a scale is not uniform: at scale 2 by up to 37 degrees, an RMS "
                    "error of 44 levels of 255 on a ball."},
           .keywords = "inverse transpose, normal matrix, non-uniform scale",
           .truth = exactly("normal-transform=inverse-transpose"),
           .inactive = needs_vertex_normals,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = {{"normal-under-scale",
                                         is_not<&Settings::normal_transform, NormalTransform::inverse_transpose>,
                                         "normal-transform=inverse-transpose"}},
                        .scenes = {{"lab/flattened", "", PictureWay::fragments}}}},
          {{"inverse-transpose", "inverse transpose", "Stays perpendicular to the surface."},
           {"model", "model matrix", "As for positions; wrong if the scale is not uniform."}}),
      choice<&Settings::illumination>(
          {.key = "illumination",
           .label = "Illumination",
           .help = {"Lighting model: relative intensities as in the book, or radiometric units.",
                    "CGFS ch. 3; CGPP 15.4", "Radiometric pictures need exposure and gamma to look right."},
           .keywords = "radiometry, photometry, physically based, PBR, Lambert, watt, inverse square",
           .truth = other_picture(),
           .inactive = needs_lighting,
           .known_to = {.fast = {knows(fragment_batches, 100, Illumination::book),
                                 knows(sphere_packets, 80, Illumination::book),
                                 knows(hit_shading, 40, Illumination::book)},
                        .hardware = defined_as("RADIOMETRIC")},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          {{"book", "the book's",
            "Relative intensities without distance fall-off; matte surfaces stay below 1 if they sum to 1, highlights "
            "may exceed it."},
           {"radiometric", "radiometric",
            "A point light's intensity is its power: power / (4 pi r^2) arrives. A Lambertian surface scatters 1 / pi "
            "of it; normalised highlights are brighter if sharper."}}),
      toggle<&Settings::attenuation>(
          {.key = "attenuation",
           .label = "Attenuation",
           .help = {"Weakens point lights with distance by their constant, linear and quadratic factors.", "OCT",
                    "Constant factor too small: surfaces near the light are overexposed."},
           .keywords = "fall-off, falloff, inverse square, distance",
           .truth = exactly("attenuation=on"),
           .inactive = [](const Settings& s, const SceneTraits& t) -> Reason {
             if (const auto reason = needs_lighting(s, t)) return reason;
             if (!t.attenuated) return "no point light of the scene has attenuation factors";
             if (s.illumination != Illumination::book) return needs("illumination", Illumination::book);
             return {};
           },
           .known_to = {.fast = {knows(fragment_batches, 110, false).where(&SceneTraits::attenuated),
                                 knows(sphere_packets, 90, false).where(&SceneTraits::attenuated),
                                 knows(hit_shading, 50, false).where(&SceneTraits::attenuated)},
                        .hardware = defined_as("ATTENUATION")},
           .shown_by = {.experiments = none, .scenes = {{"octree/attenuation"}}}}),
      toggle<&Settings::diffuse>(
          {.key = "diffuse",
           .label = "Diffuse term",
           .help = {"Adds diffuse light, which a surface scatters alike to all sides.", "CGFS ch. 3 and 13",
                    "Off: matte surfaces show ambient light alone, shiny ones their highlights as well."},
           .keywords = "Lambert, matte, specular only, highlights only, term",
           .truth = exactly("diffuse=on"),
           .inactive = needs_lighting,
           .known_to = {.fast = {knows(fragment_batches, 115, true), knows(sphere_packets, 95, true),
                                 knows(hit_shading, 55, true)},
                        .hardware = defined_as("DIFFUSE")},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}}),
      toggle<&Settings::specular>(
          {.key = "specular",
           .label = "Highlights",
           .help = {"Adds specular highlights, the mirror-like reflections of the lights.", "CGFS ch. 3", ""},
           .keywords = "highlight, shininess, gloss, Phong",
           .truth = exactly("specular=on"),
           .inactive = needs_highlights,
           .known_to = {.fast = any_value, .hardware = any_value},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}}),
      choice<&Settings::highlight>(
          {.key = "highlight",
           .label = "Highlight model",
           .help = {"The angle on which the highlight depends.", "CGFS ch. 3; OCT",
                    "The same exponent gives a wider highlight with N.H than with R.V."},
           .keywords = "specular, Blinn, Phong, half vector, shininess",
           .truth = other_picture(),
           .inactive = needs_visible_highlights,
           .known_to = {.fast = {knows(sphere_packets, 70, Highlight::phong)}, .hardware = defined_as("BLINN_PHONG")},
           .shown_by = {.experiments = none, .scenes = {{"cgfs/reflections"}}}},
          {{"phong", "R.V (Phong)", "Angle between the reflected light direction R and the view direction V."},
           {"blinn-phong", "N.H (Blinn-Phong)", "Angle between the normal N and the half vector H."}}),
      choice<&Settings::interpolation>(
          {.key = "interpolation",
           .label = "Interpolation",
           .help = {"How vertex values are interpolated across a triangle.", "CGFS ch. 12 and 14; LAB 6",
                    "With affine interpolation textures bend, and swim when the camera moves."},
           .keywords = "perspective correct, affine, texture warping, PlayStation, barycentric",
           .truth = exactly("interpolation=perspective"),
           .acts_for = ActsFor::fragments,
           .inactive = needs_attributes,
           .known_to = {.fast = {knows(fragment_batches, 30, Interpolation::perspective)}, .hardware = any_value},
           .shown_by = {.experiments = {{"affine-texture", is<&Settings::interpolation, Interpolation::affine>,
                                         "interpolation=perspective"}},
                        .scenes = {{"cgfs/crates"}}}},
          {{"perspective", "perspective-correct",
            "Interpolates value/z and 1/z, which are linear on the screen; one division per pixel."},
           {"affine", "affine", "Interpolates the value itself as if it were linear on the screen."}}),
  };
}

}  // namespace ps::rows
