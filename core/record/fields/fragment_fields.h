#pragma once
#include "record/fields/row.h"

/// Fields of the events of the rasterizer: triangles that are rejected or cover the pixel, and what writes it.

namespace ps::fields {

template <>
struct List<RejectEvent> {
  using E = RejectEvent;
  static constexpr std::string_view kind = "reject", partners = "triangle";
  static constexpr std::array rows{subject(field<&E::id>("id")), field<&E::reason>("reason"),
                                   field<&E::detail>("detail", [](const E& e) { return !e.detail.empty(); }),
                                   field<&E::edges>("edges")};
};

template <>
struct List<FragmentEvent> {
  using E = FragmentEvent;
  static constexpr std::string_view kind = "fragment", partners = "triangle";
  static constexpr bool multisampled(const E& e) { return e.samples > 1; }
  static constexpr std::array rows{
      subject(field<&E::id>("id")),
      labelled("vertex 0", computed<&E::corners>("corner-0", [](const E& e) { return e.corners[0]; })),
      labelled("vertex 1", computed<&E::corners>("corner-1", [](const E& e) { return e.corners[1]; })),
      labelled("vertex 2", computed<&E::corners>("corner-2", [](const E& e) { return e.corners[2]; })),
      labelled("vertex depths", field<&E::corner_depth>("corner-depth")),
      field<&E::edges>("edges"),
      labelled("owns edge", field<&E::tie_owned>("tie-owned")),
      field<&E::weights_2d>("weights-2d"),
      field<&E::weights>("weights"),
      field<&E::z>("z"),
      field<&E::inverse_z>("inverse-z"),
      field<&E::depth>("depth-test"),
      field<&E::depth_stored>("depth-stored"),
      field<&E::depth_new>("depth-new"),
      field<&E::back_face>("back-face"),
      field<&E::clipped_into>("clipped-into"),
      field<&E::sphere_triangle>("sphere-triangle", [](const E& e) { return e.sphere_triangle >= 0; }),
      field<&E::pass>("pass", [](const E& e) { return e.pass != E::Pass::only; }),
      field<&E::samples>("samples", multisampled),
      field<&E::samples_covered>("samples-covered", multisampled)};
};

template <>
struct List<CoverageEvent> {
  using E = CoverageEvent;
  static constexpr std::string_view kind = "coverage", partners = kind;
  static constexpr std::array rows{field<&E::id>("id"),           field<&E::strategy>("strategy"),
                                   field<&E::covered>("covered"), field<&E::how>("how"),
                                   field<&E::values>("values"),   field<&E::tests>("tests")};
};

template <>
struct List<StencilEvent> {
  using E = StencilEvent;
  static constexpr std::string_view kind = "stencil", partners = kind;
  /// Both ends of the silhouette edge of each side, one after the other.
  static std::vector<double> edges_of_sides(const E& e) {
    std::vector<double> numbers;
    for (const VolumeCrossing& crossing : e.crossings) {
      if (crossing.part != VolumePart::side) continue;
      for (const Vec3d& end : {crossing.edge_from, crossing.edge_to})
        numbers.insert(numbers.end(), {end.x, end.y, end.z});
    }
    return numbers;
  }
  static constexpr std::array rows{
      field<&E::light>("light"),
      field<&E::silhouette_edges>("silhouette-edges"),
      field<&E::surface_z>("surface-z"),
      each<&E::crossings, &VolumeCrossing::object>("volume-of"),
      each<&E::crossings, &VolumeCrossing::z>("volume-z"),
      each<&E::crossings, &VolumeCrossing::enters>("enters"),
      each<&E::crossings, &VolumeCrossing::change>("change"),
      computed<&E::crossings>("edges-of-sides", [](const E& e) { return edges_of_sides(e); }),
      field<&E::count>("count"),
      field<&E::stored>("stored")};
};

template <>
struct List<WriteEvent> {
  using E = WriteEvent;
  static constexpr std::string_view kind = "write", partners = kind;
  static constexpr std::array rows{field<&E::id>("id"), field<&E::before>("before"), field<&E::shaded>("shaded"),
                                   field<&E::opacity>("opacity"), field<&E::after>("after")};
};

template <>
struct List<PolygonEvent> {
  using E = PolygonEvent;
  static constexpr std::string_view kind = "polygon", partners = kind;
  static constexpr bool by_rows(const E& e) { return e.row.has_value(); }
  static constexpr std::array rows{subject(field<&E::item>("item")),
                                   field<&E::fill>("fill"),
                                   computed<&E::vertices>("vertices",
                                                          [](const E& e) {
                                                            std::vector<double> numbers;
                                                            for (const Vec2d& v : e.vertices)
                                                              numbers.insert(numbers.end(), {v.x, v.y});
                                                            return numbers;
                                                          }),
                                   computed<&E::row>(
                                       "columns",
                                       [](const E& e) {
                                         return std::array{e.row->left, e.row->right};
                                       },
                                       by_rows),
                                   computed<&E::row>(
                                       "edges", [](const E& e) { return e.row->edges; }, by_rows),
                                   computed<&E::row>(
                                       "along-edges", [](const E& e) { return e.row->along_edges; }, by_rows),
                                   computed<&E::row>(
                                       "first-colour", [](const E& e) { return e.row->end_colours[0]; }, by_rows),
                                   computed<&E::row>(
                                       "last-colour", [](const E& e) { return e.row->end_colours[1]; }, by_rows),
                                   computed<&E::row>(
                                       "along-row", [](const E& e) { return e.row->along_row; }, by_rows),
                                   computed<&E::row>(
                                       "colour", [](const E& e) { return e.row->colour; }, by_rows)};
};

template <>
struct List<LineEvent> {
  using E = LineEvent;
  static constexpr std::string_view kind = "line", partners = kind;
  static constexpr std::array rows{field<&E::id>("id"), field<&E::from>("from"), field<&E::to>("to"),
                                   field<&E::step>("step"), field<&E::colour>("colour")};
};

}  // namespace ps::fields
