// The listings that follow rays in a ray tracer's events.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "math/vec.h"
#include "textbook/book_math.h"
#include "textbook/report_parts.h"

namespace ps::textbook {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double book_levels = 255;

class RayReporter {
 public:
  RayReporter(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder)
      : book_(book), reader_(reader), recorder_(recorder) {
    const auto& objects = book.scene.geometry->objects;
    for (std::size_t i = 0; i < objects.size(); ++i)
      if (std::holds_alternative<Sphere>(objects[i].shape)) objects_.push_back(static_cast<int>(i));
  }

  void report() {
    for (const int pixel : reader_.all("pixel")) {
      const auto rays = reader_.below(pixel, bounces);
      const int first = rays.empty() ? pixel : rays.front();  // before reflections a pixel is a ray
      report_ray(first, {RayKind::eye, book_.camera.position,
                         reader_.last<Vec3d>(first, "direction").value_or(Vec3d(0)), 1, endless, 0, 1});
    }
  }

 private:
  static constexpr std::string_view bounces = "remaining bounces";

  struct Found {
    int sphere = -1;    ///< index into the book's spheres
    int triangle = -1;  ///< the instance of its test
    double t = 0;
    bool any() const { return sphere >= 0 || triangle >= 0; }
  };

  PixelId id_of(int sphere) const { return {objects_.at(static_cast<std::size_t>(sphere)), 0}; }
  PixelId id_of(const Found& found) const {
    return found.triangle >= 0 ? id_of_triangle(found.triangle) : id_of(found.sphere);
  }
  PixelId id_of_triangle(int test) const {
    PixelId id{-1, static_cast<std::int32_t>(reader_.last<std::int64_t>(test, "number").value_or(0))};
    const auto& objects = book_.scene.geometry->objects;
    for (std::size_t i = 0; i < objects.size() && id.object < 0; ++i)
      if (std::holds_alternative<Instance>(objects[i].shape) &&
          objects[i].name == std::get<std::string>(reader_.value_of(test)))
        id.object = static_cast<std::int32_t>(i);
    return id;
  }
  const BookSphere& sphere(int index) const { return book_.spheres.at(static_cast<std::size_t>(index)); }
  double number(int instance, std::string_view name, double otherwise) const {
    return reader_.last<double>(instance, name).value_or(otherwise);
  }

  /// The tests of all spheres that are right inside an instance, and the nearest of what they met.
  Found report_tests(int instance, double t_min, double t_max) {
    Found nearest;
    const auto tests = reader_.below(instance, "sphere");
    for (std::size_t k = 0; k < tests.size() && k < objects_.size(); ++k) {
      SphereTestEvent event;
      event.id = id_of(static_cast<int>(k));
      event.discriminant = number(tests[k], "discriminant", 0);
      if (const auto t = reader_.last<Vec2d>(tests[k], "t1, t2"))
        event.roots = {std::min(t->x, t->y), std::max(t->x, t->y)};
      const auto accepted = reader_.last<double>(tests[k], "closest t so far");
      if (accepted) nearest = {static_cast<int>(k), -1, *accepted};
      event.outcome = outcome(event, accepted.has_value(), t_min, t_max);
      recorder_.event([&] { return event; });
    }
    for (const int test : reader_.below(instance, "triangle of")) {
      TriangleTestEvent event;
      event.id = id_of_triangle(test);
      event.t = reader_.last<double>(test, "t");
      if (const auto w = reader_.last<Vec3d>(test, "weights")) event.weights = {w->x, w->y, w->z};
      const auto accepted = reader_.last<double>(test, "closest t so far");
      if (accepted) nearest = {-1, test, *accepted};
      event.outcome = outcome(event, accepted.has_value(), t_min, t_max);
      recorder_.event([&] { return event; });
    }
    return nearest;
  }

  TestOutcome outcome(const TriangleTestEvent& test, bool accepted, double t_min, double t_max) const {
    if (accepted) return TestOutcome::accepted;
    if (!test.weights) return TestOutcome::back_side;
    if (!test.t) return TestOutcome::missed;
    if (*test.t <= t_min) return TestOutcome::before_range;
    return *test.t >= t_max ? TestOutcome::beyond_range : TestOutcome::farther;
  }

  static TestOutcome outcome(const SphereTestEvent& test, bool accepted, double t_min, double t_max) {
    if (accepted) return TestOutcome::accepted;
    if (!test.roots) return TestOutcome::missed;
    if ((*test.roots)[1] <= t_min) return TestOutcome::before_range;
    if ((*test.roots)[0] >= t_max) return TestOutcome::beyond_range;
    return TestOutcome::farther;
  }

  void report_ray(int instance, const RayEvent& ray) {
    recorder_.begin([&] { return ray; });
    const Found hit = report_tests(instance, ray.t_min, ray.t_max);
    if (!hit.any())
      recorder_.event([&] { return MissEvent{book_.background / book_levels}; });
    else
      report_surface(instance, ray, hit);
    recorder_.end();
  }

  void report_surface(int instance, const RayEvent& ray, const Found& hit) {
    HitEvent event;
    event.id = id_of(hit);
    event.t = hit.t;
    event.point = reader_.last<Vec3d>(instance, "point").value_or(ray.origin + ray.direction * hit.t);
    const Vec3d outwards = hit.sphere < 0 ? -ray.direction : event.point - sphere(hit.sphere).centre;
    event.geometric_normal = event.shading_normal =
        reader_.last<Vec3d>(instance, "normal").value_or(outwards * (1 / length(outwards)));
    recorder_.event([&] { return event; });
    for (const auto& [index, light] : numbered(reader_.below(instance, "light")))
      report_light(index, light, instance, event, ray);
    ShadeEvent shade;
    const Vec3d surface =
        hit.sphere < 0 ? reader_.last<Vec3d>(instance, "surface colour").value_or(Vec3d(0)) : sphere(hit.sphere).colour;
    shade.surface = surface / book_levels;
    shade.light = Vec3d(number(instance, "intensity", 1));
    shade.local = reader_.last<Vec3d>(instance, "radiance").value_or(shade.surface * shade.light);
    recorder_.event([&] { return shade; });
    report_mirrored(instance, ray, event, shade.local);
  }

  static std::vector<std::pair<int, int>> numbered(const std::vector<int>& instances) {
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < instances.size(); ++i) pairs.emplace_back(static_cast<int>(i), instances[i]);
    return pairs;
  }

  /// The sum of the light before one of the lights: what the one before it left.
  double sum_before(int instance, int index) const {
    const auto lights = reader_.below(instance, "light");
    for (int i = index - 1; i >= 0; --i)
      for (const char* name : {"with specular", "with diffuse", "intensity so far"})
        if (const auto sum = reader_.last<double>(lights[static_cast<std::size_t>(i)], name)) return *sum;
    return 0;
  }

  void report_light(int index, int light, int instance, const HitEvent& hit, const RayEvent& ray) {
    LightEvent event;
    event.light = index;
    event.kind = book_.lights.at(static_cast<std::size_t>(index)).kind;
    const double before = sum_before(instance, index);
    if (event.kind == LightKind::ambient) {
      event.diffuse = number(light, "intensity so far", before) - before;
      recorder_.event([&] { return event; });
      return;
    }
    event.to_light = reader_.last<Vec3d>(light, "to light").value_or(Vec3d(0));
    const auto blocked_by = reader_.last<std::string>(light, "blocked by");
    if (blocked_by) {  // this listing asks
      recorder_.begin([&] {
        return RayEvent{RayKind::shadow,
                        hit.point,
                        event.to_light,
                        book_.settings.shadow_epsilon,
                        event.kind == LightKind::point ? 1 : endless,
                        ray.depth,
                        ray.share};
      });
      const Found blocker = report_tests(light, book_.settings.shadow_epsilon, endless);
      recorder_.end();
      if (blocker.any()) {
        event.blocker = id_of(blocker);
        event.visible = 0;
      }
    }
    // A blocked light goes no further in the listing; the surface's direction is reported all the same.
    const double n_dot_l = number(light, "N . L", dot(hit.shading_normal, event.to_light));
    event.n_dot_l = n_dot_l / (length(hit.shading_normal) * length(event.to_light));
    event.below_horizon = !(n_dot_l > 0);
    const Vec3d mirrored = hit.shading_normal * (2 * n_dot_l) - event.to_light;
    event.r_dot_v = number(light, "R . V", dot(mirrored, -ray.direction)) / (length(mirrored) * length(ray.direction));
    const double with_diffuse = number(light, "with diffuse", before);
    event.diffuse = with_diffuse - before;
    event.specular = number(light, "with specular", with_diffuse) - with_diffuse;
    if (const auto arriving = reader_.last<double>(light, "arriving"))  // radiometric: Lambert's law
      event.diffuse = *arriving * std::max(0.0, event.n_dot_l) / std::numbers::pi;
    recorder_.event([&] { return event; });
  }

  void report_mirrored(int instance, const RayEvent& ray, const HitEvent& hit, const Vec3d& local) {
    const auto mirrored = reader_.below(instance, bounces);
    if (mirrored.empty()) return;
    const double share = number(instance, "r", 0);
    report_ray(mirrored.front(),
               {RayKind::reflection, hit.point, reader_.last<Vec3d>(mirrored.front(), "direction").value_or(Vec3d(0)),
                book_.settings.reflection_epsilon, endless, ray.depth + 1, ray.share * share});
    const Vec3d black(0);
    recorder_.event([&] {
      return ReflectionEvent{share, local,
                             reader_.last<Vec3d>(instance, "reflected colour").value_or(black) / book_levels,
                             reader_.last<Vec3d>(instance, "mixed").value_or(black) / book_levels};
    });
  }

  const BookScene& book_;
  const WatchReader& reader_;
  PixelRecorder& recorder_;
  std::vector<int> objects_;  // of each of the book's spheres
};

}  // namespace

void report_rays(const BookScene& book, const WatchReader& reader, PixelRecorder& recorder) {
  RayReporter(book, reader, recorder).report();
}

}  // namespace ps::textbook
