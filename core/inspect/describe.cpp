#include "inspect/describe.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/enumerators.h"
#include "inspect/face_data.h"
#include "record/event_keys.h"
#include "record/value_text.h"
#include "render/story/light_words.h"
#include "render/story/names.h"
#include "render/story/reason_text.h"
#include "render/story/write_mixing.h"

namespace ps {
namespace {

/// A remark about a triangle that a file has a line for, or whose normals face away; empty for all else.
std::string face_remark(const Scene& scene, const PixelId& id) {
  const auto face = face_data(scene, id);
  const std::string words = !face ? "" : face->line > 0 ? face_words(*face) : facing_text(*face);
  return words.empty() ? "" : "; " + words;
}

struct Describer {
  const Scene& scene;
  static constexpr std::size_t most_listed = 8;  // vertices in one sentence

  std::string operator()(const RayEvent& e) const {
    std::string text =
        fmt::format("{} ray from {} along {}", enumerator_key(e.kind), vector_text(e.origin), vector_text(e.direction));
    for (std::size_t i = 0; i < e.inside.size(); ++i)
      text += fmt::format("{}{} (refraction index {})", i == 0 ? ", origin inside " : ", inside ",
                          object_name(scene, e.inside[i].object), number_text(e.inside[i].index));
    return text;
  }
  std::string operator()(const NodeEvent& e) const {
    const std::string place = e.object < 0 ? "" : fmt::format(" in the model of {}", object_name(scene, e.object));
    const std::string_view outcome = e.entered ? "entered" : "missed";
    if (e.radius > 0)
      return fmt::format("sphere {} on level {}, center {}, radius {}: {}", e.node, e.level,
                         vector_text((e.low + e.high) * 0.5), number_text(e.radius), outcome);
    return fmt::format("box {} on level {}{}: {}", e.node, e.level, place, outcome);
  }
  std::string operator()(const SphereTestEvent& e) const {
    std::string text = fmt::format("{}: {}", primitive_name(scene, e.id), outcome_text(e.outcome));
    if (e.roots)
      text += fmt::format(", t = {} and {}", number_text((*e.roots)[0]), number_text((*e.roots)[1]));
    else
      text += fmt::format(", discriminant {}", number_text(e.discriminant));
    return text;
  }
  std::string operator()(const TriangleTestEvent& e) const {
    std::string text = fmt::format("{}: {}", primitive_name(scene, e.id), outcome_text(e.outcome));
    if (!e.rejected_by.empty()) text += fmt::format(" ({})", e.rejected_by);
    if (e.t) text += fmt::format(", t = {}", number_text(*e.t));
    return text;
  }
  std::string operator()(const HitEvent& e) const {
    return fmt::format("hit {} at t = {}, point {}{}", primitive_name(scene, e.id), number_text(e.t),
                       vector_text(e.point), face_remark(scene, e.id));
  }
  std::string operator()(const MissEvent& e) const {
    return fmt::format("no hit: background {}", vector_text(e.background));
  }
  std::string operator()(const TextureEvent& e) const {
    const std::string use = e.use == TextureUse::surface ? "" : fmt::format(" for {}", enumerator_key(e.use));
    const std::string texels = e.texels.empty()       ? ""
                               : e.texels.size() == 1 ? " of 1 texel"
                                                      : fmt::format(" of {} texels", e.texels.size());
    return fmt::format("texture read{} at uv {}, level {}: {}{}", use, vector_text(e.uv), number_text(e.level),
                       vector_text(e.result), texels);
  }
  std::string operator()(const LightEvent& e) const {
    return fmt::format("{}: {}", light_name(scene, e.light), light_effect_text(scene, e, LightWords::whole));
  }
  std::string operator()(const VertexLightEvent& e) const {
    const std::string light = vector_text(e.light + e.extra);
    if (!e.vertex)
      return fmt::format("light at the centre of {}, for all of it: {}", primitive_name(scene, e.id), light);
    return fmt::format("light at vertex {} of {}: {}, weight {}", *e.vertex, primitive_name(scene, e.id), light,
                       number_text(e.weight));
  }
  std::string operator()(const ShadeEvent& e) const {
    return fmt::format("local colour {}: surface {} x light {}", vector_text(e.local), vector_text(e.surface),
                       vector_text(e.light));
  }
  std::string operator()(const ReflectionEvent& e) const {
    return fmt::format("reflectivity {}: {} x {} + {} x {} = {}", number_text(e.reflective),
                       number_text(1 - e.reflective), vector_text(e.local), number_text(e.reflective),
                       vector_text(e.reflected), vector_text(e.result));
  }
  std::string operator()(const CutoffEvent& e) const {
    return fmt::format(
        "not followed: the next bounce would contribute {} of the pixel's colour, less than reflection-cutoff = {}",
        number_text(e.share), number_text(e.least));
  }
  std::string operator()(const SolidTestEvent& e) const {
    std::string text = fmt::format("{}: {}", object_name(scene, e.id.object), outcome_text(e.outcome));
    for (std::size_t i = 0; i < e.crossings.size(); ++i)
      text += fmt::format("{} {}", i == 0 ? ", t =" : " and", number_text(e.crossings[i]));
    return text;
  }
  std::string operator()(const RefractionEvent& e) const {
    if (e.total)
      return fmt::format("total internal reflection: index {} to {}, cosine {}", number_text(e.from_index),
                         number_text(e.to_index), number_text(e.cos_incident));
    return fmt::format("transmission: {} x {} + {} x {} + {} x {} = {}", number_text(e.own_share), vector_text(e.local),
                       number_text(e.mirrored_share), vector_text(e.mirrored), number_text(e.refracted_share),
                       vector_text(e.refracted), vector_text(e.result));
  }
  std::string operator()(const ShadowMapEvent& e) const {
    const std::string name = light_name(scene, e.light);
    if (e.outside) return fmt::format("shadow map of {}: the point lies outside the map, lit", name);
    const std::string face = e.cube ? fmt::format("face {}, ", cube_face_name(e.face)) : std::string();
    if (e.taps.size() == 1) {
      const ShadowTap& tap = e.taps.front();
      return fmt::format("shadow map of {}: {}texel ({}, {}) stores depth {}, the point has {} - bias {}: {}", name,
                         face, tap.x, tap.y, number_text(tap.stored), number_text(e.depth), number_text(e.bias),
                         tap.lit ? "lit" : "in shadow");
    }
    return fmt::format("shadow map of {}: {}{} taps, {} % of the light reaches the point", name, face, e.taps.size(),
                       number_text(100 * e.visible));
  }
  std::string operator()(const StencilEvent& e) const {
    std::string text = fmt::format(
        "stencil of {}: {} of {} shadow volume faces are counted, sum {}", light_name(scene, e.light),
        std::count_if(e.crossings.begin(), e.crossings.end(), [](const VolumeCrossing& c) { return c.change != 0; }),
        e.crossings.size(), e.count);
    if (e.stored != e.count) text += fmt::format(", stored as {}", e.stored);
    text += e.stored == 0 ? ": lit" : ": in shadow";
    for (const VolumeCrossing& crossing : e.crossings)
      if (crossing.change != 0) text += "; " + crossing_text(crossing);
    return text;
  }
  std::string crossing_text(const VolumeCrossing& c) const {
    std::string what = fmt::format("{:+} where the line of sight {} the shadow volume of {}", c.change,
                                   c.enters ? "enters" : "leaves", object_name(scene, c.object));
    switch (c.part) {
    case VolumePart::lit_face:
      return what + " at its lit face";
    case VolumePart::far_end:
      return what + " at its far end";
    case VolumePart::side:
      return what + fmt::format(" through the side face of the silhouette edge {} to {}", vector_text(c.edge_from),
                                vector_text(c.edge_to));
    }
    return what;
  }
  std::string operator()(const EnvironmentEvent& e) const {
    std::string text = fmt::format("cube map rendered from {}: face {} along {} shows {}", vector_text(e.centre),
                                   cube_face_name(e.face), vector_text(e.direction), vector_text(e.result));
    if (e.left_out > 0)
      text += fmt::format("; {} dynamic object{} left out of it", e.left_out, e.left_out == 1 ? " is" : "s are");
    return text;
  }
  std::string operator()(const RejectEvent& e) const {
    std::string text = fmt::format("{}: {}", e.id.object < 0 ? "a triangle on the canvas" : primitive_name(scene, e.id),
                                   reject_reason_text(e.reason));
    if (!e.detail.empty()) text += fmt::format(" ({})", e.detail);
    return text;
  }
  std::string operator()(const FragmentEvent& e) const {
    if (e.id.object < 0) return "a triangle on the canvas covers the pixel";
    std::string text = fmt::format("{} covers the pixel at z = {}", primitive_name(scene, e.id), number_text(e.z));
    if (const std::string behind = behind_camera_text(e); !behind.empty()) text += fmt::format(" ({})", behind);
    switch (e.depth) {
    case FragmentEvent::Depth::passed:
      return text + ": passed the depth test" + face_remark(scene, e.id);
    case FragmentEvent::Depth::failed:
      return text + ": failed the depth test" + depth_against_text(e);
    case FragmentEvent::Depth::off:
      return text + ": depth test off" + face_remark(scene, e.id);
    }
    return text;
  }
  std::string operator()(const PolygonEvent& e) const {
    const std::string_view shape = e.vertices.size() == 3 ? "triangle" : "polygon";
    std::string text = fmt::format("{} {} with vertices ", shape, e.item);
    if (e.vertices.size() > most_listed) {
      text = fmt::format("{} {} with {} vertices", shape, e.item, e.vertices.size());
    } else {
      for (std::size_t i = 0; i < e.vertices.size(); ++i) text += (i == 0 ? "" : ", ") + vector_text(e.vertices[i]);
    }
    if (!e.row) return text + ": filled as triangles around its first vertex";
    return text + fmt::format(": its row is filled from x = {} to {}, interpolated from {} to {}: {} at {}",
                              e.row->left, e.row->right, vector_text(e.row->end_colours[0]),
                              vector_text(e.row->end_colours[1]), vector_text(e.row->colour),
                              number_text(e.row->along_row));
  }
  std::string operator()(const CoverageEvent& e) const {
    return e.strategy ? fmt::format("{}: {}", event_key(*e.strategy), e.how) : e.how;
  }
  std::string operator()(const WriteEvent& e) const {
    if (e.id.object < 0 && mixing_of(e) == Mixing::adds)
      return fmt::format("a shape adds its colour {} to {}: {}", vector_text(e.shaded), vector_text(e.before),
                         vector_text(e.after));
    if (e.id.object < 0 && mixing_of(e) == Mixing::filters)
      return fmt::format("a shape multiplies {1} by {0}: {2}", vector_text(e.shaded), vector_text(e.before),
                         vector_text(e.after));
    if (mixing_of(e) == Mixing::blends)
      return fmt::format("{} is blended: source {} x {} + destination {} x {} = {}", primitive_name(scene, e.id),
                         number_text(e.opacity), vector_text(e.shaded), number_text(1 - e.opacity),
                         vector_text(e.before), vector_text(e.after));
    return fmt::format("{} writes {} over {}", e.id.object >= 0 ? primitive_name(scene, e.id) : "a shape",
                       vector_text(e.after), vector_text(e.before));
  }
  std::string operator()(const LineEvent& e) const {
    const std::string what = e.id.object < 0 ? "line" : "edge of " + primitive_name(scene, e.id);
    return fmt::format("{} from {} to {} writes {} at step {}", what, vector_text(e.from), vector_text(e.to),
                       vector_text(e.colour), e.step);
  }
  std::string operator()(const SampleEvent& e) const {
    return fmt::format("sample {} of {} at {}: weight {}, colour {}", e.index + 1, e.count, vector_text(e.position),
                       number_text(e.weight), vector_text(e.colour));
  }
  std::string operator()(const CompareEvent& e) const {
    const std::string pixel = fmt::format("pixel ({}, {})", e.neighbour.x, e.neighbour.y);
    if (e.own.object != e.other.object)
      return fmt::format("{} sees {}, this one {}: subdivided", pixel, primitive_name(scene, e.other),
                         primitive_name(scene, e.own));
    return fmt::format("{} sees the same object; colours differ by {} (threshold {}): {}", pixel,
                       number_text(e.difference), number_text(e.threshold),
                       e.subdivides ? "subdivided" : "not subdivided");
  }
  std::string operator()(const ReuseEvent& e) const {
    if (!e.same) return "full search: the traced neighbours hit different objects or too many triangles";
    const std::string seen = primitive_name(scene, e.seen);
    if (!e.met) return fmt::format("full search: the traced neighbours hit {}, and this ray misses it", seen);
    return fmt::format("the traced neighbours hit {}: nothing else is tested", seen);
  }
  std::string operator()(const NormalMapEvent& e) const {
    return fmt::format("normal map: {} in tangent space changes the normal from {} to {}", vector_text(e.stored),
                       vector_text(e.before), vector_text(e.after));
  }
  std::string operator()(const ParallaxEvent& e) const {
    return fmt::format(
        "parallax: the line of sight meets the relief at depth {} of 1; texture coordinates {} become {}",
        number_text(e.depth), vector_text(e.from), vector_text(e.to));
  }
  std::string operator()(const PixelEvent& e) const {
    return fmt::format("pixel {}, stored as {}, {}, {}", vector_text(e.linear), e.display[0], e.display[1],
                       e.display[2]);
  }
};

template <class List, class Text>
std::string bracketed(const List& values, Text text) {
  std::string out = "(";
  for (std::size_t i = 0; i < values.size(); ++i) out += (i == 0 ? "" : ", ") + text(values[i]);
  return out + ")";
}

using NumberText = std::string (*)(double);

struct ValueText {
  const Scene& scene;
  NumberText number;

  std::string operator()(bool v) const { return v ? "yes" : "no"; }
  std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
  std::string operator()(double v) const { return number(v); }
  std::string operator()(const std::string& v) const { return v; }
  std::string operator()(const std::vector<double>& v) const { return bracketed(v, number); }
  std::string operator()(const std::vector<bool>& v) const {
    return bracketed(v, [](bool one) { return std::string(one ? "yes" : "no"); });
  }
  std::string operator()(const PixelId& v) const { return primitive_name(scene, v); }
  std::string operator()(const std::vector<Texel>& v) const {
    std::string out;
    for (const Texel& t : v)
      out += fmt::format("{}[{}, {}] level {} x {}", out.empty() ? "" : "; ", t.x, t.y, t.level, number(t.weight));
    return out;
  }
};

}  // namespace

std::string describe(const Event& event, const Scene& scene) { return std::visit(Describer{scene}, event.data); }

std::vector<FieldText> event_table(const Event& event, const Scene& scene) {
  std::vector<FieldText> table;
  for (const EventField& field : event_fields(event.data, scene)) {
    table.push_back({field_label(field), std::visit(ValueText{scene, number_text}, field.value),
                     std::visit(ValueText{scene, exact_number_text}, field.value)});
  }
  return table;
}

}  // namespace ps
