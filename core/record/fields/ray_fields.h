#pragma once
#include "record/fields/row.h"

/// Fields of the events of rays: rays, nodes, tests, hits, and which rays are sent for a pixel.

namespace ps::fields {

template <>
struct List<RayEvent> {
  using E = RayEvent;
  static constexpr std::string_view kind = "ray", partners = kind;
  static constexpr bool starts_inside(const E& e) { return !e.inside.empty(); }
  static constexpr std::array rows{subject(field<&E::kind>("ray")),
                                   field<&E::origin>("origin"),
                                   field<&E::direction>("direction"),
                                   field<&E::t_min>("t-min"),
                                   field<&E::t_max>("t-max"),
                                   field<&E::depth>("depth"),
                                   field<&E::share>("share"),
                                   computed<&E::inside>(
                                       "begins-in",
                                       [](const E& e) {
                                         return PixelId{e.inside.front().object, -1};
                                       },
                                       starts_inside),
                                   each<&E::inside, &MediumAtEye::index>("refraction-indices-around", starts_inside)};
};

template <>
struct List<NodeEvent> {
  using E = NodeEvent;
  static constexpr std::string_view kind = "node", partners = kind;
  static constexpr bool is_sphere(const E& e) { return e.radius > 0; }
  static constexpr bool is_box(const E& e) { return !is_sphere(e); }
  static constexpr std::array rows{subject(field<&E::node>("node")),
                                   field<&E::level>("level"),
                                   computed<&E::low, &E::high>(
                                       "center", [](const E& e) -> Vec3d { return (e.low + e.high) * 0.5; }, is_sphere),
                                   field<&E::radius>("radius", is_sphere),
                                   field<&E::low>("low", is_box),
                                   field<&E::high>("high", is_box),
                                   field<&E::entered>("entered"),
                                   subject(computed<&E::object>(
                                       "model-of",
                                       [](const E& e) {
                                         return PixelId{e.object, -1};
                                       },
                                       [](const E& e) { return e.object >= 0; }))};
};

template <>
struct List<SphereTestEvent> {
  using E = SphereTestEvent;
  static constexpr std::string_view kind = "sphere-test", partners = "test";
  static constexpr std::array rows{subject(field<&E::id>("id")), field<&E::outcome>("outcome"),
                                   field<&E::discriminant>("discriminant"), field<&E::roots>("roots")};
};

template <>
struct List<TriangleTestEvent> {
  using E = TriangleTestEvent;
  static constexpr std::string_view kind = "triangle-test", partners = "test";
  static constexpr std::array rows{
      subject(field<&E::id>("id")), field<&E::outcome>("outcome"),
      field<&E::rejected_by>("rejected-by", [](const E& e) { return !e.rejected_by.empty(); }),
      field<&E::weights>("weights"), field<&E::t>("t")};
};

template <>
struct List<SolidTestEvent> {
  using E = SolidTestEvent;
  static constexpr std::string_view kind = "solid-test", partners = "test";
  static constexpr std::array rows{subject(field<&E::id>("id")),
                                   field<&E::outcome>("outcome"),
                                   each<&E::spans, &SolidSpan::part>("parts"),
                                   each<&E::spans, &SolidSpan::enter>("enter"),
                                   each<&E::spans, &SolidSpan::leave>("leave"),
                                   field<&E::crossings>("crossings")};
};

template <>
struct List<HitEvent> {
  using E = HitEvent;
  static constexpr std::string_view kind = "hit", partners = kind;
  static constexpr std::array rows{field<&E::id>("id"),
                                   field<&E::t>("t"),
                                   field<&E::point>("point"),
                                   field<&E::geometric_normal>("geometric-normal"),
                                   field<&E::shading_normal>("shading-normal"),
                                   field<&E::weights>("weights"),
                                   field<&E::uv>("uv"),
                                   field<&E::back_face>("back-face")};
};

template <>
struct List<MissEvent> {
  using E = MissEvent;
  static constexpr std::string_view kind = "miss", partners = "hit";
  static constexpr std::array rows{field<&E::background>("background")};
};

template <>
struct List<SampleEvent> {
  using E = SampleEvent;
  static constexpr std::string_view kind = "sample", partners = kind;
  static constexpr std::array rows{field<&E::index>("sample"), field<&E::count>("samples"),
                                   field<&E::position>("position"), field<&E::weight>("weight"),
                                   field<&E::colour>("colour")};
};

template <>
struct List<CompareEvent> {
  using E = CompareEvent;
  static constexpr std::string_view kind = "compare", partners = kind;
  static constexpr std::array rows{field<&E::neighbour>("neighbour"), field<&E::own>("own"),
                                   field<&E::other>("other"),         field<&E::difference>("difference"),
                                   field<&E::threshold>("threshold"), field<&E::subdivides>("subdivides")};
};

template <>
struct List<ReuseEvent> {
  using E = ReuseEvent;
  static constexpr std::string_view kind = "reuse", partners = kind;
  template <auto Coordinate>
  static std::vector<double> of_neighbours(const E& e) {
    const auto count = static_cast<std::size_t>(e.count);
    std::vector<double> numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = e.around.at(i).*Coordinate;
    return numbers;
  }
  static constexpr std::array rows{
      computed<&E::around, &E::count>("columns", [](const E& e) { return of_neighbours<&Vec2i::x>(e); }),
      computed<&E::around, &E::count>("rows", [](const E& e) { return of_neighbours<&Vec2i::y>(e); }),
      field<&E::seen>("seen"), field<&E::same>("same"), field<&E::met>("met")};
};

}  // namespace ps::fields
