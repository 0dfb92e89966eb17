#include "raster/assembly/assemble.h"

#include <algorithm>
#include <cmath>

#include "math/unit.h"
#include "raster/assembly/canvas_line.h"
#include "raster/assembly/corner_attributes.h"
#include "raster/assembly/near_pixel.h"
#include "raster/base/fragment_event.h"
#include "raster/base/guard_band.h"
#include "raster/base/light_at.h"

namespace ps::raster {
namespace {

constexpr std::size_t triangles_per_run = 2048;

/// One vertex on the canvas. `depth` is what is linear there: 1 / z, or z in orthographic pictures; `weights` are those
/// of the whole triangle's vertices, not divided by anything.
template <class Real>
struct CanvasCorner {
  Vec2<Real> position{0, 0};  ///< pixels from the top left, y down
  Real depth = 0;
  Vec3<Real> weights{0, 0, 0};
};

bool box_is_empty(const TileRect& box) { return box.x0 >= box.x1 || box.y0 >= box.y1; }

/// Assembles one run. Its members are the inputs, and the one triangle that its steps work on.
template <class Real>
class Assembler {
 public:
  Assembler(const RasterInputs<Real>& inputs, const VertexBuffer<Real>& vertices, const TriangleRun& run,
            std::optional<Vec2i> inspected, Batch<Real>& batch)
      : inputs_(inputs), vertices_(vertices), run_(run), inspected_(inspected), object_(inputs.objects[run.object]),
        batch_(batch) {}

  void add_run() {
    for (std::size_t t = run_.first; t < run_.last; ++t) {
      index_ = t;
      sequence_ = run_.sequence + static_cast<std::uint32_t>(t - run_.first);
      add_triangle();
    }
    batch_.counters += recorder_.counters;
  }

 private:
  void add_triangle() {
    recorder_.count(Counter::triangles_in);
    source_ = {object_.mesh.get(), &object_.mesh->triangles[index_], &vertices_, {}};
    for (std::size_t k = 0; k < 3; ++k) corner_[k] = Vec3<Real>(vertices_.camera[source_.triangle->position[k]]);
    if (inspected_) look_at_places();
    const Vec3<Real> normal = cross(corner_[1] - corner_[0], corner_[2] - corner_[0]);
    in_double_ = !has_exact_square(dot(normal, normal));
    if (!(in_double_ ? look_in_double() : look(corner_, normal))) {
      recorder_.count(Counter::triangles_degenerate);
      return reject(RejectReason::zero_area, "");
    }
    if (back_face_ && (inputs_.settings.backface_culling || object_.front_only)) {
      recorder_.count(Counter::triangles_backfacing);
      return reject(RejectReason::back_face, "");
    }
    if (far_ && inputs_.settings.draw == Draw::filled && (outside_ == 0 || clipped_away_) && !lights_corners())
      count_far();
    else if (fills(inputs_.settings.draw))
      fill();
    else
      outline();
    if (inputs_.settings.draw == Draw::outlined) add_edges();
  }

  /// Which side of the triangle faces the eye. False: it has no area.
  template <class Number>
  bool look(const std::array<Vec3<Number>, 3>& corners, const Vec3<Number>& normal) {
    if (!(largest_component(normal) > 0)) return false;
    const auto handedness = static_cast<Number>(facing_sense(inputs_, object_));
    const Vec3<Number> to_eye = inputs_.perspective() ? -corners[0] : Vec3<Number>(0, 0, -1);
    back_face_ = !(handedness * dot(normal, to_eye) > 0);
    return true;
  }

  /// The facing of a triangle so large or so small that Real cannot square its normal: its vertices before rounding.
  bool look_in_double() {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d world = object_.world(object_.mesh->positions[source_.triangle->position[k]]);
      exact_[k] = inputs_.settings.camera_relative ? inputs_.camera_space.point(world) : Vec3d(corner_[k]);
    }
    return look(exact_, triangle_normal(exact_[0], exact_[1], exact_[2]));
  }

  /// Whether the triangle is far from the inspected pixel, and where its vertices lie if nothing cuts it.
  void look_at_places() {
    outside_ = 0;
    std::uint32_t all_behind = ~VertexPlace::no_place;
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexPlace& place = vertices_.places[source_.triangle->position[k]];
      outside_ |= place.outside;
      all_behind &= place.outside;
      place_[k] = {place.column, place.row};
    }
    // The planes before the first that any vertex is behind cut nothing.
    const std::uint32_t first_plane = outside_ & (~outside_ + 1);
    clipped_away_ = (first_plane & all_behind) != 0;
    far_ = (outside_ & VertexPlace::no_place) == 0 && lies_far(place_, *inspected_, inputs_.grid.subpixel_bits);
  }

  /// Whether light falls on vertices or on the triangle as a whole, which counts as work.
  bool lights_corners() const {
    const AttributeLayout& layout = surface().layout;
    return layout.light != AttributeLayout::absent || layout.flat_light;
  }

  /// A whole triangle far from the inspected pixel: counted as fill() would, and dropped.
  void count_far() {
    ++batch_.elsewhere;
    if (clipped_away_)
      recorder_.count(Counter::triangles_clipped_away);
    else if (doubled_area(place_) == 0)
      recorder_.count(Counter::triangles_degenerate);
    else if (!box_is_empty(visible_box(sample_box(place_, inputs_.grid))))
      recorder_.count(Counter::triangles_drawn);
  }

  /// How many of the vertices lie in front of every plane; -1 if all are behind one plane.
  int corners_in_view() const {
    std::array<bool, 3> in_view{true, true, true};
    for (const auto& plane : inputs_.planes) {
      int in_front = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const bool front = plane.distance(corner_[k]) >= 0;
        in_front += front;
        in_view[k] = in_view[k] && front;
      }
      if (in_front == 0) return -1;
    }
    return in_view[0] + in_view[1] + in_view[2];
  }

  void fill() {
    if (in_double_) return fill_clipped(exact_);
    if (corners_in_view() == 3 && fill_whole()) return;
    fill_clipped(corner_);
  }

  /// The common case, a triangle that nothing cuts: the same steps without polygons. False if something does cut it.
  bool fill_whole() {
    constexpr Real reach = static_cast<Real>(guard_band);
    std::array<CanvasCorner<Real>, 3> canvas;
    for (std::size_t k = 0; k < 3; ++k) {
      canvas[k].position = inputs_.projection.from_top_left(corner_[k]);
      canvas[k].depth = inputs_.perspective() ? Real(1) / corner_[k].z : corner_[k].z;
      canvas[k].weights[static_cast<int>(k)] = 1;
      if (!(std::abs(canvas[k].position.x) <= reach && std::abs(canvas[k].position.y) <= reach) ||
          !std::isfinite(canvas[k].depth))
        return false;
    }
    emit(canvas.data(), 3, false);
    return true;
  }

  /// `Number` is Real, or double for a triangle that look_in_double() sees.
  template <class Number>
  void fill_clipped(const std::array<Vec3<Number>, 3>& corners) {
    ClipPolygon<Number> polygon;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3<Number> weights(0);
      weights[static_cast<int>(k)] = 1;
      polygon.push({corners[k], weights});
    }
    bool split = false;
    for (const auto& plane : inputs_.planes) {
      const ClipOutcome outcome = clip_polygon<Number>(
          polygon, {Vec3<Number>(plane.normal), static_cast<Number>(plane.offset), plane.reason, plane.name});
      if (outcome == ClipOutcome::outside) {
        recorder_.count(Counter::triangles_clipped_away);
        return reject(plane.reason, plane.name);
      }
      split = split || outcome == ClipOutcome::split;
    }
    std::array<CanvasCorner<Number>, ClipPolygon<Number>::capacity> canvas;
    int size = polygon.size;
    if (!project(polygon, canvas)) return reject(RejectReason::behind_camera, "no finite position on the canvas");
    if (!cut_canvas(canvas, size, split)) {
      recorder_.count(Counter::triangles_clipped_away);
      return reject(RejectReason::clipped_side, "guard band");
    }
    if (split) recorder_.count(Counter::triangles_split);
    emit(canvas.data(), size, split);
  }

  /// False if a vertex has no finite place on the canvas, which only happens without a near plane.
  template <class Number>
  bool project(const ClipPolygon<Number>& polygon, std::array<CanvasCorner<Number>, 16>& canvas) const {
    const CanvasProjection<Number> projection = make_canvas_projection<Number>(inputs_.viewport);
    for (int i = 0; i < polygon.size; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const ClipVertex<Number>& vertex = polygon.corners[k];
      canvas[k] = {projection.from_top_left(vertex.position),
                   inputs_.perspective() ? Number(1) / vertex.position.z : vertex.position.z, vertex.weights};
      if (!std::isfinite(canvas[k].position.x) || !std::isfinite(canvas[k].position.y) ||
          !std::isfinite(canvas[k].depth))
        return false;
    }
    return true;
  }

  /// Cuts the polygon on the canvas to the guard band. What is linear there is depth, and weights times 1 / z. False if
  /// nothing is left.
  template <class Number>
  bool cut_canvas(std::array<CanvasCorner<Number>, 16>& canvas, int& size, bool& split) const {
    ClipPolygon<Number> polygon;
    for (int i = 0; i < size; ++i) {
      const auto& c = canvas[static_cast<std::size_t>(i)];
      const Number share = inputs_.perspective() ? c.depth : Number(1);
      polygon.push({{c.position.x, c.position.y, c.depth}, c.weights * share});
    }
    bool cut = false;
    if (!cut_to_guard_band(polygon, cut)) return false;
    if (!cut) return true;
    split = true;
    size = polygon.size;
    for (int i = 0; i < size; ++i) {
      const auto& v = polygon.corners[static_cast<std::size_t>(i)];
      const Number share = inputs_.perspective() ? v.position.z : Number(1);
      canvas[static_cast<std::size_t>(i)] = {{v.position.x, v.position.y}, v.position.z, v.weights / share};
    }
    return true;
  }

  template <class Number>
  void emit(const CanvasCorner<Number>* canvas, int size, bool split) {
    ScreenTriangle<Real> piece;
    piece.surface = surface_index();
    piece.sequence = sequence_;
    piece.triangle = static_cast<std::int32_t>(index_);
    piece.pieces = static_cast<std::uint8_t>(size - 2);
    piece.cut = split;
    piece.back_face = back_face_;
    piece.sort_depth = mean_depth();
    bool area = false;
    bool attributes_known = false;
    std::array<CornerAttributes<Real>, 3> attributes;
    Lighting<Real> flat;
    for (int i = 1; i + 1 < size; ++i) {
      const std::array<const CanvasCorner<Number>*, 3> c{canvas, canvas + i, canvas + i + 1};
      for (std::size_t k = 0; k < 3; ++k) piece.corners[k] = to_fixed(c[k]->position, inputs_.grid.subpixel_bits);
      if (doubled_area(piece.corners) == 0) continue;
      area = true;
      piece.box = visible_box(sample_box(piece.corners, inputs_.grid));
      if (box_is_empty(piece.box)) continue;
      if (!attributes_known) {
        attributes_known = true;
        if (needs_face_normal()) source_.face_normal = face_normal<Real>(object_, *source_.triangle);
        attributes = corner_attributes(inputs_, surface(), source_, recorder_);
        if (surface().layout.flat_light) flat = flat_light();
      }
      piece.face_normal = source_.face_normal;
      piece.attributes = static_cast<std::uint32_t>(batch_.attributes.size());
      for (std::size_t k = 0; k < 3; ++k) {
        const Number depth = c[k]->depth, inverse = Number(1) / depth;
        piece.z[k] = static_cast<Real>(inputs_.perspective() ? inverse : depth);
        piece.inverse_z[k] = static_cast<Real>(inputs_.perspective() ? depth : inverse);
        store_attributes(attributes, *c[k], split);
      }
      if (surface().layout.flat_light) {
        for (int axis = 0; axis < 3; ++axis) batch_.attributes.push_back(flat.light[axis]);
        for (int axis = 0; axis < 3; ++axis) batch_.attributes.push_back(flat.extra[axis]);
      }
      if (split)
        for (std::size_t k = 0; k < 3; ++k)
          for (int axis = 0; axis < 3; ++axis) batch_.attributes.push_back(static_cast<Real>(c[k]->weights[axis]));
      recorder_.count(Counter::triangles_drawn);
      batch_.triangles.push_back(piece);
    }
    if (!area) {
      recorder_.count(Counter::triangles_degenerate);
      reject(RejectReason::zero_area, "on the canvas");
    } else if (!attributes_known && inspected_) {
      ++batch_.elsewhere;
    }
  }

  /// The scalars of a vertex, carried as value / z where interpolation is perspective-correct.
  template <class Number>
  void store_attributes(const std::array<CornerAttributes<Real>, 3>& attributes, const CanvasCorner<Number>& corner,
                        bool split) {
    const Real share = inputs_.divides() ? static_cast<Real>(corner.depth) : Real(1);
    const auto number = [](Real value) { return static_cast<Number>(value); };
    const auto count = static_cast<std::size_t>(surface().layout.count);
    const std::size_t first = batch_.attributes.size();
    batch_.attributes.resize(first + count);
    Real* stored = batch_.attributes.data() + first;
    const std::size_t k = corner.weights.x == 1 ? 0 : corner.weights.y == 1 ? 1 : 2;
    for (std::size_t a = 0; a < count; ++a) {
      const Real value = split ? static_cast<Real>(number(attributes[0][a]) * corner.weights.x +
                                                   number(attributes[1][a]) * corner.weights.y +
                                                   number(attributes[2][a]) * corner.weights.z)
                               : attributes[k][a];
      stored[a] = value * share;
    }
  }

  Lighting<Real> flat_light() {
    const FlatPoint<Real> point = flat_point(source_, inputs_.settings.normals);
    return light_at(inputs_, surface(), point.position, point.normal, recorder_);
  }

  /// The edges of the whole triangle, each cut to the clipping volume by itself; or its vertices as points. Is any
  /// left?
  bool add_edges() {
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool points = inputs_.settings.draw == Draw::points;
      // The book's order of edges: 0-1, 1-2, 0-2.
      const std::size_t from = points ? k : k == 2 ? 0 : k;
      const std::size_t to = points ? k : k == 2 ? 2 : k + 1;
      Vec3<Real> a = corner_[from];
      Vec3<Real> b = corner_[to];
      if (!clip_segment(a, b, inputs_.planes)) continue;
      any = add_line(inputs_.projection.centred(a), inputs_.projection.centred(b)) || any;
    }
    return any;
  }

  /// The triangle as its edges or vertices alone.
  void outline() {
    if (add_edges()) {
      recorder_.count(Counter::triangles_drawn);
    } else {
      recorder_.count(Counter::triangles_clipped_away);
      reject_outline();
    }
  }

  /// No edge is left of the triangle: because of one plane, or of several together.
  void reject_outline() {
    for (const auto& plane : inputs_.planes)
      if (std::none_of(corner_.begin(), corner_.end(), [&](const auto& c) { return plane.distance(c) >= 0; }))
        return reject(plane.reason, plane.name);
    reject(RejectReason::clipped_side, "no edge in view");
  }

  bool add_line(const Vec2<Real>& a, const Vec2<Real>& b) {
    ScreenLine<Real> line;
    if (!make_canvas_line(a, b, inputs_.viewport.columns, inputs_.viewport.rows, line)) return false;
    line.sort_depth = mean_depth();
    line.surface = surface_index();
    line.sequence = sequence_;
    line.triangle = static_cast<std::int32_t>(index_);
    if (box_is_empty(line.box)) return false;
    recorder_.count(Counter::lines_drawn);
    batch_.lines.push_back(line);
    return true;
  }

  void reject(RejectReason reason, std::string_view detail) {
    if (!inspected_) return;
    if (far_ || !near_pixel(inputs_, corner_, *inspected_)) {
      ++batch_.elsewhere;
      return;
    }
    RejectEvent event;
    event.id = {object_.object, static_cast<std::int32_t>(index_)};
    event.reason = reason;
    event.detail = detail;
    name_by_object(object_.sphere, event);
    batch_.rejected.push_back({sequence_, event});
  }

  bool needs_face_normal() const {
    return has(inputs_.channels, Channel::facing) || reads_face_normal(inputs_, surface(), source_);
  }
  TileRect visible_box(const TileRect& box) const {
    return {std::max(box.x0, 0), std::max(box.y0, 0), std::min(box.x1, inputs_.viewport.columns),
            std::min(box.y1, inputs_.viewport.rows)};
  }
  Real mean_depth() const { return (corner_[0].z + corner_[1].z + corner_[2].z) / Real(3); }
  std::uint32_t surface_index() const {
    const auto slot = object_.materials.size() == 1 ? 0 : source_.triangle->material;
    return inputs_.first_surface[run_.object] + slot;
  }
  const Surface<Real>& surface() const { return inputs_.surfaces[surface_index()]; }

  const RasterInputs<Real>& inputs_;
  const VertexBuffer<Real>& vertices_;
  const TriangleRun& run_;
  std::optional<Vec2i> inspected_;
  const DrawObject& object_;
  Batch<Real>& batch_;
  CountingRecorder recorder_;

  // The triangle at hand.
  std::size_t index_ = 0;
  std::uint32_t sequence_ = 0;
  CornerSource<Real> source_;
  std::array<Vec3<Real>, 3> corner_{};  ///< camera space
  bool in_double_ = false;
  std::array<Vec3d, 3> exact_{};  ///< with in_double_: camera space
  bool back_face_ = false;
  // Of an inspected pixel.
  std::array<FixedPoint, 3> place_{};
  std::uint32_t outside_ = 0;  ///< the vertices' VertexPlace::outside together
  bool clipped_away_ = false;  ///< all of them lie behind the first plane that cuts
  bool far_ = false;
};

}  // namespace

template <class Real>
std::vector<TriangleRun> make_runs(const RasterInputs<Real>& inputs, const std::vector<bool>& culled) {
  std::vector<TriangleRun> runs;
  std::uint32_t sequence = 0;
  for (std::size_t i = 0; i < inputs.objects.size(); ++i) {
    if (culled[i]) continue;
    const std::size_t count = inputs.objects[i].mesh->triangles.size();
    for (std::size_t first = 0; first < count; first += triangles_per_run)
      runs.push_back(
          {i, first, std::min(first + triangles_per_run, count), sequence + static_cast<std::uint32_t>(first)});
    sequence += static_cast<std::uint32_t>(count);
  }
  return runs;
}

template <class Real>
Batch<Real> assemble(const RasterInputs<Real>& inputs, const VertexBuffer<Real>& vertices, const TriangleRun& run,
                     std::optional<Vec2i> inspected) {
  Batch<Real> batch;
  if (!inspected && fills(inputs.settings.draw) && !inputs.settings.backface_culling)
    batch.triangles.reserve(run.last - run.first);
  Assembler<Real>(inputs, vertices, run, inspected, batch).add_run();
  return batch;
}

template <class Real>
void assemble_triangle(const RasterInputs<Real>& inputs, const VertexBuffer<Real>& vertices, std::size_t object,
                       std::size_t triangle, Batch<Real>& batch) {
  const TriangleRun run{object, triangle, triangle + 1, 0};
  Assembler<Real>(inputs, vertices, run, {}, batch).add_run();
}

#define PS_INSTANTIATE(Real)                                                                                           \
  template std::vector<TriangleRun> make_runs(const RasterInputs<Real>&, const std::vector<bool>&);                    \
  template void assemble_triangle(const RasterInputs<Real>&, const VertexBuffer<Real>&, std::size_t, std::size_t,      \
                                  Batch<Real>&);                                                                       \
  template Batch<Real> assemble(const RasterInputs<Real>&, const VertexBuffer<Real>&, const TriangleRun&,              \
                                std::optional<Vec2i>);
PS_INSTANTIATE(float)
PS_INSTANTIATE(double)
#undef PS_INSTANTIATE

}  // namespace ps::raster
