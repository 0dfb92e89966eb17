#pragma once
#include "record/fields/row.h"

/// Fields of the events at a surface point: textures, light, what is reflected and transmitted, and the pixel's colour.

namespace ps::fields {

template <>
struct List<TextureEvent> {
  using E = TextureEvent;
  static constexpr std::string_view kind = "texture", partners = kind;
  static constexpr std::array rows{field<&E::texture>("texture"), field<&E::uv>("uv"),
                                   field<&E::level>("level"),     field<&E::texels>("texels"),
                                   field<&E::result>("result"),   field<&E::use>("use")};
};

template <>
struct List<NormalMapEvent> {
  using E = NormalMapEvent;
  static constexpr std::string_view kind = "normal-map", partners = kind;
  static constexpr std::array rows{field<&E::texture>("texture"),     field<&E::uv>("uv"),
                                   field<&E::stored>("stored"),       field<&E::tangent>("tangent"),
                                   field<&E::bitangent>("bitangent"), field<&E::before>("before"),
                                   field<&E::after>("after")};
};

template <>
struct List<ParallaxEvent> {
  using E = ParallaxEvent;
  static constexpr std::string_view kind = "parallax", partners = kind;
  static constexpr std::array rows{field<&E::texture>("texture"), field<&E::from>("from"),
                                   field<&E::to>("to"),           field<&E::shift>("shift"),
                                   field<&E::depth>("depth"),     field<&E::relief>("relief-depths")};
};

template <>
struct List<LightEvent> {
  using E = LightEvent;
  static constexpr std::string_view kind = "light", partners = kind;
  static constexpr bool has_direction(const E& e) { return e.kind != LightKind::ambient; }
  static constexpr std::array rows{subject(field<&E::light>("light")),
                                   field<&E::kind>("light-kind"),
                                   field<&E::to_light>("to-light", has_direction),
                                   field<&E::n_dot_l>("n-dot-l", has_direction),
                                   field<&E::r_dot_v>("r-dot-v", has_direction),
                                   field<&E::diffuse>("diffuse"),
                                   field<&E::specular>("specular"),
                                   field<&E::ambient>("ambient", [](const E& e) { return e.ambient != 0; }),
                                   field<&E::blocker>("blocker"),
                                   field<&E::visible>("visible", [](const E& e) { return e.visible != 1; }),
                                   labelled("faces away", field<&E::below_horizon>("below-horizon"))};
};

template <>
struct List<ShadowMapEvent> {
  using E = ShadowMapEvent;
  static constexpr std::string_view kind = "shadow-map", partners = kind;
  static constexpr bool inside(const E& e) { return !e.outside; }
  static constexpr std::array rows{
      field<&E::light>("light"),
      field<&E::outside>("outside"),
      computed<&E::face, &E::cube>(
          "face", [](const E& e) { return std::string(cube_face_name(e.face)); }, [](const E& e) { return e.cube; }),
      field<&E::position>("position", inside),
      field<&E::depth>("own-depth", inside),
      field<&E::bias>("bias", inside),
      each<&E::taps, &ShadowTap::x>("tap-column", inside),
      each<&E::taps, &ShadowTap::y>("tap-row", inside),
      each<&E::taps, &ShadowTap::stored>("stored-depth", inside),
      each<&E::taps, &ShadowTap::lit>("lit", inside),
      field<&E::visible>("visible", inside)};
};

template <>
struct List<EnvironmentEvent> {
  using E = EnvironmentEvent;
  static constexpr std::string_view kind = "environment", partners = kind;
  static constexpr std::array rows{
      field<&E::centre>("centre"),
      field<&E::direction>("direction"),
      computed<&E::face>("face", [](const E& e) { return std::string(cube_face_name(e.face)); }),
      field<&E::position>("position"),
      field<&E::result>("result"),
      field<&E::left_out>("left-out")};
};

template <>
struct List<VertexLightEvent> {
  using E = VertexLightEvent;
  static constexpr std::string_view kind = "vertex-light", partners = kind;
  static constexpr std::array rows{field<&E::id>("id"),
                                   subject(computed<&E::vertex>("point",
                                                                [](const E& e) {
                                                                  return e.vertex
                                                                             ? "vertex " + std::to_string(*e.vertex)
                                                                             : std::string("centre");
                                                                })),
                                   field<&E::weight>("weight"),
                                   field<&E::position>("position"),
                                   field<&E::normal>("normal"),
                                   field<&E::light>("light"),
                                   labelled("other light", field<&E::extra>("extra"))};
};

template <>
struct List<ShadeEvent> {
  using E = ShadeEvent;
  static constexpr std::string_view kind = "shade", partners = kind;
  static constexpr std::array rows{field<&E::surface>("surface"), field<&E::light>("light"),
                                   labelled("other light", field<&E::extra>("extra")), field<&E::local>("local")};
};

template <>
struct List<ReflectionEvent> {
  using E = ReflectionEvent;
  static constexpr std::string_view kind = "reflection", partners = kind;
  static constexpr std::array rows{field<&E::reflective>("reflective"), field<&E::local>("local"),
                                   field<&E::reflected>("reflected"), field<&E::result>("result")};
};

template <>
struct List<CutoffEvent> {
  using E = CutoffEvent;
  static constexpr std::string_view kind = "cutoff", partners = kind;
  static constexpr std::array rows{field<&E::share>("share"), labelled("minimum", field<&E::least>("least"))};
};

template <>
struct List<RefractionEvent> {
  using E = RefractionEvent;
  static constexpr std::string_view kind = "refraction", partners = kind;
  static constexpr std::array rows{field<&E::transparency>("transparency"),
                                   field<&E::from_index>("from-index"),
                                   field<&E::to_index>("to-index"),
                                   field<&E::cos_incident>("cos-incident"),
                                   field<&E::cos_refracted>("cos-refracted"),
                                   field<&E::fresnel>("fresnel"),
                                   field<&E::total>("total-reflection"),
                                   computed<&E::own_share, &E::mirrored_share, &E::refracted_share>(
                                       "shares",
                                       [](const E& e) {
                                         return std::array{e.own_share, e.mirrored_share, e.refracted_share};
                                       }),
                                   field<&E::local>("local"),
                                   field<&E::mirrored>("mirrored"),
                                   field<&E::refracted>("refracted"),
                                   field<&E::result>("result")};
};

template <>
struct List<PixelEvent> {
  using E = PixelEvent;
  static constexpr std::string_view kind = "pixel", partners = kind;
  static constexpr std::array rows{field<&E::linear>("linear"), field<&E::display>("display")};
};

}  // namespace ps::fields
