#include "inspect/event_fields.h"

#include "render/story/reason_text.h"

namespace ps {
namespace {

using Fields = std::vector<EventField>;

std::vector<double> list(const Vec2d& v) { return {v.x, v.y}; }
std::vector<double> list(const Vec3d& v) { return {v.x, v.y, v.z}; }
template <std::size_t N>
std::vector<double> list(const std::array<double, N>& v) {
  return {v.begin(), v.end()};
}
std::int64_t whole(int value) { return value; }

Fields fields(const RayEvent& e) {
  Fields f{{"ray", std::string(ray_kind_key(e.kind))},
           {"origin", list(e.origin)},
           {"direction", list(e.direction)},
           {"t-min", e.t_min},
           {"t-max", e.t_max},
           {"depth", whole(e.depth)},
           {"share", e.share}};
  std::vector<double> indices;
  for (const MediumAtEye& medium : e.inside) indices.push_back(medium.index);
  if (!e.inside.empty()) {
    f.push_back({"begins-in", PixelId{e.inside.front().object, -1}});
    f.push_back({"refraction-indices-around", indices});
  }
  return f;
}

Fields fields(const NodeEvent& e) {
  Fields f{{"node", whole(e.node)}, {"level", whole(e.level)}};
  if (e.radius > 0) {
    f.push_back({"center", list((e.low + e.high) * 0.5)});
    f.push_back({"radius", e.radius});
  } else {
    f.push_back({"low", list(e.low)});
    f.push_back({"high", list(e.high)});
  }
  f.push_back({"entered", e.entered});
  if (e.object >= 0) f.push_back({"model-of", PixelId{e.object, -1}});
  return f;
}

Fields fields(const SphereTestEvent& e) {
  Fields f{{"id", e.id}, {"outcome", std::string(outcome_key(e.outcome))}, {"discriminant", e.discriminant}};
  if (e.roots) f.push_back({"roots", list(*e.roots)});
  return f;
}

Fields fields(const TriangleTestEvent& e) {
  Fields f{{"id", e.id}, {"outcome", std::string(outcome_key(e.outcome))}};
  if (!e.rejected_by.empty()) f.push_back({"rejected-by", e.rejected_by});
  if (e.weights) f.push_back({"weights", list(*e.weights)});
  if (e.t) f.push_back({"t", *e.t});
  return f;
}

Fields fields(const HitEvent& e) {
  return {{"id", e.id},
          {"t", e.t},
          {"point", list(e.point)},
          {"geometric-normal", list(e.geometric_normal)},
          {"shading-normal", list(e.shading_normal)},
          {"weights", list(e.weights)},
          {"uv", list(e.uv)},
          {"back-face", e.back_face}};
}

Fields fields(const MissEvent& e) { return {{"background", list(e.background)}}; }

Fields fields(const TextureEvent& e) {
  return {{"texture", whole(e.texture)}, {"uv", list(e.uv)},         {"level", e.level},
          {"texels", e.texels},          {"result", list(e.result)}, {"use", std::string(texture_use_key(e.use))}};
}

Fields fields(const LightEvent& e) {
  Fields f{{"light", whole(e.light)}, {"light-kind", std::string(light_kind_key(e.kind))}};
  if (e.kind != LightKind::ambient) {
    f.push_back({"to-light", list(e.to_light)});
    f.push_back({"n-dot-l", e.n_dot_l});
    f.push_back({"r-dot-v", e.r_dot_v});
  }
  f.push_back({"diffuse", e.diffuse});
  f.push_back({"specular", e.specular});
  if (e.blocker) f.push_back({"blocker", *e.blocker});
  if (e.visible != 1) f.push_back({"visible", e.visible});
  f.push_back({"below-horizon", e.below_horizon});
  return f;
}

Fields fields(const ShadeEvent& e) {
  return {{"surface", list(e.surface)}, {"light", list(e.light)}, {"extra", list(e.extra)}, {"local", list(e.local)}};
}

Fields fields(const ReflectionEvent& e) {
  return {{"reflective", e.reflective},
          {"local", list(e.local)},
          {"reflected", list(e.reflected)},
          {"result", list(e.result)}};
}

Fields fields(const CutoffEvent& e) { return {{"share", e.share}, {"least", e.least}}; }

Fields fields(const RejectEvent& e) {
  Fields f{{"id", e.id}, {"reason", std::string(reject_reason_key(e.reason))}};
  if (!e.detail.empty()) f.push_back({"detail", e.detail});
  if (e.edges) f.push_back({"edges", list(*e.edges)});
  return f;
}

Fields fields(const FragmentEvent& e) {
  Fields f{{"id", e.id},
           {"corner-0", list(e.corners[0])},
           {"corner-1", list(e.corners[1])},
           {"corner-2", list(e.corners[2])},
           {"corner-depth", list(e.corner_depth)},
           {"edges", list(e.edges)},
           {"tie-owned", std::vector<bool>(e.tie_owned.begin(), e.tie_owned.end())},
           {"weights-2d", list(e.weights_2d)},
           {"weights", list(e.weights)},
           {"z", e.z},
           {"inverse-z", e.inverse_z},
           {"depth-test", std::string(depth_verdict_key(e.depth))},
           {"depth-stored", e.depth_stored},
           {"depth-new", e.depth_new},
           {"back-face", e.back_face},
           {"clipped-into", whole(e.clipped_into)}};
  if (e.sphere_triangle >= 0) f.push_back({"sphere-triangle", whole(e.sphere_triangle)});
  if (e.pass != FragmentEvent::Pass::only)
    f.push_back({"pass", std::string(e.pass == FragmentEvent::Pass::shading ? "shading" : "depth first")});
  if (e.samples > 1) {
    f.push_back({"samples", whole(e.samples)});
    f.push_back({"samples-covered", whole(e.samples_covered)});
  }
  return f;
}

Fields fields(const WriteEvent& e) {
  return {{"id", e.id}, {"before", list(e.before)}, {"shaded", list(e.shaded)}, {"after", list(e.after)}};
}

Fields fields(const LineEvent& e) {
  return {
      {"id", e.id}, {"from", list(e.from)}, {"to", list(e.to)}, {"step", whole(e.step)}, {"colour", list(e.colour)}};
}

Fields fields(const SolidTestEvent& e) {
  std::vector<double> parts, enter, leave;
  for (const SolidSpan& span : e.spans) {
    parts.push_back(span.part);
    enter.push_back(span.enter);
    leave.push_back(span.leave);
  }
  return {{"id", e.id},     {"outcome", std::string(outcome_key(e.outcome))},
          {"parts", parts}, {"enter", enter},
          {"leave", leave}, {"crossings", e.crossings}};
}

Fields fields(const RefractionEvent& e) {
  return {{"transparency", e.transparency},
          {"from-index", e.from_index},
          {"to-index", e.to_index},
          {"cos-incident", e.cos_incident},
          {"cos-refracted", e.cos_refracted},
          {"fresnel", e.fresnel},
          {"total-reflection", e.total},
          {"shares", std::vector<double>{e.own_share, e.mirrored_share, e.refracted_share}},
          {"local", list(e.local)},
          {"mirrored", list(e.mirrored)},
          {"refracted", list(e.refracted)},
          {"result", list(e.result)}};
}

Fields fields(const CoverageEvent& e) {
  return {{"id", e.id},           {"strategy", std::string(coverage_key(e.strategy))},
          {"covered", e.covered}, {"how", e.how},
          {"values", e.values},   {"tests", whole(e.tests)}};
}

Fields fields(const SampleEvent& e) {
  return {{"sample", whole(e.index)},
          {"samples", whole(e.count)},
          {"position", list(e.position)},
          {"weight", e.weight},
          {"colour", list(e.colour)}};
}

Fields fields(const CompareEvent& e) {
  return {{"neighbour", std::vector<double>{static_cast<double>(e.neighbour.x), static_cast<double>(e.neighbour.y)}},
          {"own", e.own},
          {"other", e.other},
          {"difference", e.difference},
          {"threshold", e.threshold},
          {"subdivides", e.subdivides}};
}

Fields fields(const ReuseEvent& e) {
  std::vector<double> columns, rows;
  for (int i = 0; i < e.count; ++i) {
    const Vec2i& pixel = e.around.at(static_cast<std::size_t>(i));
    columns.push_back(pixel.x);
    rows.push_back(pixel.y);
  }
  return {{"columns", columns}, {"rows", rows}, {"seen", e.seen}, {"same", e.same}, {"met", e.met}};
}

Fields fields(const NormalMapEvent& e) {
  return {{"texture", whole(e.texture)},    {"uv", list(e.uv)},
          {"stored", list(e.stored)},       {"tangent", list(e.tangent)},
          {"bitangent", list(e.bitangent)}, {"before", list(e.before)},
          {"after", list(e.after)}};
}

Fields fields(const ShadowMapEvent& e) {
  std::vector<double> columns, rows, stored;
  std::vector<bool> lit;
  for (const ShadowTap& tap : e.taps) {
    columns.push_back(tap.x);
    rows.push_back(tap.y);
    stored.push_back(tap.stored);
    lit.push_back(tap.lit);
  }
  Fields f{{"light", whole(e.light)}, {"outside", e.outside}};
  if (e.cube) f.push_back({"face", std::string(cube_face_name(e.face))});
  if (e.outside) return f;
  f.push_back({"position", list(e.position)});
  f.push_back({"own-depth", e.depth});
  f.push_back({"bias", e.bias});
  f.push_back({"tap-column", columns});
  f.push_back({"tap-row", rows});
  f.push_back({"stored-depth", stored});
  f.push_back({"lit", lit});
  f.push_back({"visible", e.visible});
  return f;
}

Fields fields(const StencilEvent& e) {
  std::vector<double> objects, depths, changes, sides;
  std::vector<bool> enters;
  for (const VolumeCrossing& crossing : e.crossings) {
    objects.push_back(crossing.object);
    depths.push_back(crossing.z);
    changes.push_back(crossing.change);
    enters.push_back(crossing.enters);
    if (crossing.part != VolumePart::side) continue;
    for (const Vec3d& end : {crossing.edge_from, crossing.edge_to}) sides.insert(sides.end(), {end.x, end.y, end.z});
  }
  return {{"light", whole(e.light)},  {"silhouette-edges", whole(e.silhouette_edges)},
          {"surface-z", e.surface_z}, {"volume-of", objects},
          {"volume-z", depths},       {"enters", enters},
          {"change", changes},        {"edges-of-sides", sides},
          {"count", whole(e.count)},  {"stored", whole(e.stored)}};
}

Fields fields(const EnvironmentEvent& e) {
  return {
      {"centre", list(e.centre)},     {"direction", list(e.direction)}, {"face", std::string(cube_face_name(e.face))},
      {"position", list(e.position)}, {"result", list(e.result)},       {"left-out", whole(e.left_out)}};
}

Fields fields(const ParallaxEvent& e) {
  return {{"texture", whole(e.texture)}, {"from", list(e.from)}, {"to", list(e.to)},
          {"shift", list(e.shift)},      {"depth", e.depth},     {"relief-depths", e.relief}};
}

Fields fields(const PixelEvent& e) {
  return {{"linear", list(e.linear)}, {"display", std::vector<double>(e.display.begin(), e.display.end())}};
}

constexpr std::array<std::string_view, std::variant_size_v<EventData>> kinds{
    "ray",        "node",       "sphere-test", "triangle-test", "hit",      "miss",    "texture",
    "light",      "shade",      "reflection",  "reject",        "fragment", "write",   "line",
    "pixel",      "solid-test", "refraction",  "coverage",      "sample",   "compare", "reuse",
    "normal-map", "shadow-map", "stencil",     "environment",   "parallax", "cutoff"};
static_assert(!kinds.back().empty());

}  // namespace

std::string_view cube_face_name(int face) {
  static constexpr std::array<std::string_view, 6> names{"+x", "-x", "+y", "-y", "+z", "-z"};
  return names.at(static_cast<std::size_t>(face));
}

std::string_view event_kind(const EventData& data) { return kinds.at(data.index()); }

std::vector<EventField> event_fields(const EventData& data) {
  return std::visit([](const auto& event) { return fields(event); }, data);
}

}  // namespace ps
