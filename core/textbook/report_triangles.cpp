// The listings of CGFS ch. 10 to 15 in a rasterizer's events.
#include <algorithm>
#include <cmath>

#include "math/vec.h"
#include "textbook/book_math.h"
#include "textbook/report_parts.h"

namespace ps::textbook {
namespace {

constexpr double full_level = 255;
constexpr double left_by_rounding = 1e-12;  // of differences of sums that are about 1

/// Twice the area of a, b, c on a canvas whose y goes down; positive where they turn clockwise on the screen.
double doubled_area(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class TriangleReporter {
 public:
  TriangleReporter(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder)
      : book_(book), reader_(reader), recorder_(recorder), colour_(book.background / full_level) {}

  void report() {
    for (const int pixel : reader_.all("pixel")) {
      const int triangle = reader_.around(pixel, "triangle");
      if (triangle < 0) continue;
      const bool fills = reader_.last<double>(pixel, "1/z") || reader_.last<Vec3d>(pixel, "u/z, v/z, 1/z here");
      if (fills)
        report_fragment(pixel, triangle);
      else
        report_outline(pixel, triangle);
    }
  }

 private:
  /// A place as the book counts it, in pixels from the top left.
  Vec2d on_canvas(const Vec2d& p) const {
    const int middle = book_.width / 2, centre_row = book_.height - book_.height / 2;
    return {p.x + middle, centre_row - p.y};
  }

  PixelId id_of(int triangle) const {
    PixelId id{-1, static_cast<std::int32_t>(std::get<std::int64_t>(reader_.value_of(triangle)))};
    const int instance = reader_.around(triangle, "instance");
    const auto& objects = book_.scene.geometry->objects;
    for (std::size_t i = 0; instance >= 0 && i < objects.size() && id.object < 0; ++i)
      if (std::holds_alternative<Instance>(objects[i].shape) &&
          objects[i].name == std::get<std::string>(reader_.value_of(instance)))
        id.object = static_cast<std::int32_t>(i);
    return id;
  }

  const BookInstance* instance_of(int triangle) const {
    const int instance = reader_.around(triangle, "instance");
    for (const BookInstance& one : book_.instances)
      if (instance >= 0 && one.name == std::get<std::string>(reader_.value_of(instance))) return &one;
    return nullptr;
  }

  FragmentEvent fragment(int pixel, int triangle) const {
    FragmentEvent event;
    event.id = id_of(triangle);
    event.clipped_into = 1;
    const auto corners = reader_.below(triangle, "vertex");
    for (std::size_t k = 0; k < 3 && k < corners.size(); ++k) {
      event.corners[k] = on_canvas(reader_.last<Vec2d>(corners[k], "on the canvas").value_or(Vec2d(0)));
      event.corner_depth[k] = reader_.last<Vec3d>(corners[k], "from the camera").value_or(Vec3d(0, 0, 1)).z;
    }
    const auto& places = event.corners;
    const Vec2d sample = on_canvas(std::get<Vec2d>(reader_.value_of(pixel)));
    const double area = doubled_area(places[0], places[1], places[2]), turn = area < 0 ? -1 : 1;
    double sum = 0;
    std::array<double, 3>& edges = event.edges.emplace();
    std::array<bool, 3>& tie_owned = event.tie_owned.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
      // Rows are filled with both ends, so that what lies outside by less than a pixel is drawn as well.
      edges[k] = turn * doubled_area(places[(k + 1) % 3], places[(k + 2) % 3], sample);
      tie_owned[k] = edges[k] == 0;
      event.weights_2d[k] = area != 0 ? edges[k] / std::abs(area) : 0;
      event.weights[k] = event.weights_2d[k] / event.corner_depth[k];
      sum += event.weights[k];
    }
    if (sum != 0)
      for (double& weight : event.weights) weight /= sum;
    if (const auto all = reader_.last<Vec3d>(pixel, "u/z, v/z, 1/z here")) event.inverse_z = all->z;
    if (const auto own = reader_.last<double>(pixel, "1/z")) event.inverse_z = *own;
    event.z = 1 / event.inverse_z;
    return event;
  }

  void report_fragment(int pixel, int triangle) {
    FragmentEvent event = fragment(pixel, triangle);
    const auto visible = reader_.last<bool>(pixel, "nearer than the stored depth");
    const auto colour = reader_.last<Vec3d>(visible ? triangle : pixel, "colour");
    const bool drawn = visible ? *visible : colour.has_value();
    const bool tested = book_.settings.visibility == Visibility::depth_buffer || !visible;
    event.depth = !tested ? FragmentEvent::Depth::off
                  : drawn ? FragmentEvent::Depth::passed
                          : FragmentEvent::Depth::failed;
    event.depth_stored = nearest_;
    event.depth_new = event.inverse_z;
    recorder_.begin([&] { return event; });
    if (drawn) {
      nearest_ = event.inverse_z;
      report_light(pixel, triangle);
      write(event.id, colour.value_or(Vec3d(0)) / full_level);
    }
    recorder_.end();
  }

  void write(const PixelId& id, const Vec3d& colour) {
    recorder_.event([&] { return WriteEvent{id, colour_, colour, colour}; });
    colour_ = colour;
  }

  void report_light(int pixel, int triangle) {
    const BookInstance* instance = instance_of(triangle);
    const auto intensity = reader_.last<double>(pixel, "intensity");
    if (!instance || !intensity) return;
    const MeshTriangle& drawn =
        instance->model->triangles[static_cast<std::size_t>(std::get<std::int64_t>(reader_.value_of(triangle)))];
    const BookSurface surface = surface_of(book_, *instance, drawn);
    const Vec3d own = reader_.last<Vec3d>(pixel, "local colour").value_or(surface.colour) / full_level;
    report_texture(pixel, *instance, drawn, own);
    for (const int place : lit_at(pixel, triangle)) report_lights(place);
    recorder_.event([&] { return ShadeEvent{own, Vec3d(*intensity), Vec3d(0), own * *intensity}; });
  }

  void report_texture(int pixel, const BookInstance& instance, const MeshTriangle& drawn, const Vec3d& own) {
    const auto uv = reader_.last<Vec2d>(pixel, "u, v");
    const auto texel = reader_.last<Vec2d>(pixel, "texel");
    if (!uv || !texel) return;
    const std::uint32_t material = instance.instance->material.value_or(instance.model->materials.at(drawn.material));
    TextureEvent event;
    event.texture = book_.scene.materials->at(material).texture;
    event.uv = *uv;
    event.texels = {{static_cast<int>(texel->x), static_cast<int>(texel->y), 0, 1, own}};
    event.result = own;
    recorder_.event([&] { return event; });
  }

  /// Where the lighting was evaluated: at the pixel, at the vertices from below, or once for the triangle.
  std::vector<int> lit_at(int pixel, int triangle) const {
    if (!reader_.below(pixel, "light").empty()) return {pixel};
    if (auto corners = reader_.below(triangle, "vertex, from below");
        !corners.empty() && !reader_.below(corners.front(), "light").empty())
      return corners;
    return {triangle};
  }

  void report_lights(int place) {
    int index = 0;
    double before = 0;
    for (const int light : reader_.below(place, "light")) {
      LightEvent event;
      event.light = index;
      event.kind = book_.lights.at(static_cast<std::size_t>(index++)).kind;
      const double after = reader_.last<double>(light, "intensity so far").value_or(before);
      const double full = book_.lights[static_cast<std::size_t>(event.light)].intensity;
      event.diffuse = after - before;
      report_map_lookup(event.light, light);
      if (reader_.last<bool>(light, "in shadow") == true) event.visible = 0;
      if (const auto cosine = reader_.last<double>(light, "cosine to the light")) {
        event.to_light = reader_.last<Vec3d>(light, "to light").value_or(Vec3d(0));
        event.n_dot_l = *cosine;
        event.r_dot_v = reader_.last<double>(light, "cosine to the viewer").value_or(0);
        const auto with_diffuse = reader_.last<double>(light, "with diffuse");
        event.diffuse = with_diffuse == before ? 0 : std::max(0.0, *cosine) * full;
        event.specular = after - before - event.diffuse;
        if (std::abs(event.specular) < left_by_rounding) event.specular = 0;
        event.below_horizon = !(*cosine > 0);
      }
      before = after;
      recorder_.event([&] { return event; });
    }
  }

  /// The texel of a shadow map that decides about one light.
  void report_map_lookup(int index, int light) {
    const auto seen = reader_.last<Vec3d>(light, "column, row, depth");
    if (!seen) return;
    const auto stored = reader_.last<double>(light, "stored depth");
    const bool shadow = reader_.last<bool>(light, "in shadow").value_or(false);
    ShadowMapEvent event;
    event.light = index;
    event.outside = !stored;
    event.position = {seen->x, seen->y};
    event.depth = seen->z;
    event.bias = reader_.last<double>(light, "bias").value_or(0);
    event.visible = shadow ? 0 : 1;
    if (stored) event.taps = {{static_cast<int>(seen->x), static_cast<int>(seen->y), *stored, !shadow}};
    recorder_.event([&] { return event; });
  }

  /// An edge of a triangle: the one that passes nearest to the pixel.
  void report_outline(int pixel, int triangle) {
    const auto corners = reader_.below(triangle, "vertex");
    const auto place = reader_.last<Vec2d>(pixel, "place");
    if (corners.size() < 3 || !place) return;
    std::array<Vec2d, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = reader_.last<Vec2d>(corners[k], "on the canvas").value_or(Vec2d(0));
    std::size_t best = 0;
    double least = INFINITY;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2d &from = p[k], &to = p[(k + 1) % 3];
      const Vec2d along = to - from;
      const double size = std::sqrt(along.x * along.x + along.y * along.y);
      const double away = size > 0 ? std::abs(doubled_area(from, to, *place)) / size : INFINITY;
      if (away < least) {
        least = away;
        best = k;
      }
    }
    const Vec3d colour = reader_.last<Vec3d>(pixel, "colour").value_or(Vec3d(0)) / full_level;
    recorder_.event([&] {
      return LineEvent{id_of(triangle), on_canvas(p[best]), on_canvas(p[(best + 1) % 3]), 0, colour};
    });
    colour_ = colour;
  }

  const BookScene& book_;
  const WatchReader& reader_;
  PixelRecorder& recorder_;
  Vec3d colour_;        // of the pixel so far
  double nearest_ = 0;  // 1/z in its depth buffer
};

}  // namespace

void report_triangles(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder) {
  TriangleReporter(book, reader, recorder).report();
}

}  // namespace ps::textbook
