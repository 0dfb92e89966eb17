// Lines through single forms against closed forms, and against asking points whether they are inside.
#include "raytrace/clear/solid_line.h"

#include "scene/uv_maps.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <random>

namespace ps::solid_line_test {
namespace {

template <class Real>
TracedForm<Real> traced(const Form& form) {
  const FormFrame f = form_frame(form);
  return {f.kind,
          Vec3<Real>(f.centre),
          {Vec3<Real>(f.axes[0]), Vec3<Real>(f.axes[1]), Vec3<Real>(f.axes[2])},
          Vec3<Real>(f.half),
          0};
}

template <class Real = double>
LineSpan<Real> line(const Form& form, const Vec3d& origin, const Vec3d& direction, int start = no_face) {
  const Vec3<Real> d(direction);
  return form_line(Vec3<Real>(origin), d, dot(d, d), traced<Real>(form), SphereTest::robust, start);
}

TEST(SolidLine, PlaneIsMetWhereItsEquationSays) {
  const auto span = line(Plane{{0, -1, 0}, {0, 5, 0}}, {0, 1, 0}, {1, -0.5, 0});
  EXPECT_DOUBLE_EQ(span.enter, 4);  // 1 - t / 2 = -1
  EXPECT_TRUE(std::isinf(span.leave));
  EXPECT_DOUBLE_EQ(line(Plane{{0, -1, 0}, {0, 5, 0}}, {0, -2, 0}, {0, 1, 0}).leave, 1);
  EXPECT_TRUE(line(Plane{{0, -1, 0}, {0, 1, 0}}, {0, 0, 0}, {1, 0, 0}).empty);
}

TEST(SolidLine, RectangleEndsAtItsSides) {
  const Rectangle rectangle{{1, 1, 5}, {2, 0, 0}, {0, 1, 0}};
  EXPECT_DOUBLE_EQ(line(rectangle, {2, 1.5, 0}, {0, 0, 2}).enter, 2.5);
  EXPECT_FALSE(line(rectangle, {2.999, 1.999, 0}, {0, 0, 1}).empty);
  for (const Vec3d& outside : {Vec3d{3.001, 1.5, 0}, {0.999, 1.5, 0}, {2, 2.001, 0}, {2, 0.999, 0}})
    EXPECT_TRUE(line(rectangle, outside, {0, 0, 1}).empty);
}

TEST(SolidLine, BoxAndCylinderByHand) {
  const auto box = line(Brick{{0, 0, 5}, {2, 2, 2}, Mat3d(1.0)}, {0, 0, 0}, {0.1, 0, 1});
  EXPECT_DOUBLE_EQ(box.enter, 4);
  EXPECT_EQ(box.enter_face, 4);
  EXPECT_DOUBLE_EQ(box.leave, 6);
  const Cylinder cylinder{{0, -1, 5}, {0, 1, 5}, 0.5};
  const auto across = line(cylinder, {0, 0, 0}, {0, 0, 1});
  EXPECT_NEAR(across.enter, 4.5, 1e-14);
  EXPECT_NEAR(across.leave, 5.5, 1e-14);
  const auto along = line(cylinder, {0.2, 3, 5}, {0, -1, 0});
  EXPECT_DOUBLE_EQ(along.enter, 2);
  EXPECT_EQ(along.enter_face, 1);
  EXPECT_DOUBLE_EQ(along.leave, 4);
  EXPECT_TRUE(line(cylinder, {0.6, 3, 5}, {0, -1, 0}).empty);
}

bool inside(const Form& form, const Vec3d& p) {
  if (const auto* ball = std::get_if<Ball>(&form)) return glm::length(p - ball->centre) < ball->radius;
  if (const auto* plane = std::get_if<Plane>(&form)) return dot(p - plane->point, plane->normal) < 0;
  if (const auto* brick = std::get_if<Brick>(&form)) {
    const Vec3d local = glm::transpose(brick->rotation) * (p - brick->centre);
    return glm::all(glm::lessThan(glm::abs(local), brick->size * 0.5));
  }
  const auto& cylinder = std::get<Cylinder>(form);
  const Vec3d axis = cylinder.to - cylinder.from;
  const double along = dot(p - cylinder.from, axis) / dot(axis, axis);
  return along > 0 && along < 1 && glm::length(p - cylinder.from - axis * along) < cylinder.radius;
}

class Forms {
 public:
  explicit Forms(unsigned seed) : random_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3d vec(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }
  Mat3d frame() {
    const Vec3d a = glm::normalize(vec(1)), b = glm::normalize(cross(a, vec(1)));
    return Mat3d(a, b, cross(a, b));
  }
  Form form(int kind) {
    if (kind == 0) return Ball{vec(2), number(0.2, 2)};
    if (kind == 1) return Plane{vec(2), vec(1)};
    if (kind == 2) return Brick{vec(2), Vec3d{number(0.2, 3), number(0.2, 3), number(0.2, 3)}, frame()};
    const Vec3d from = vec(2);
    return Cylinder{from, from + vec(2), number(0.2, 1)};
  }

 private:
  std::mt19937 random_;
};

TEST(SolidLine, SpansAreWherePointsAreInside) {
  constexpr unsigned seed = 11;
  SCOPED_TRACE(seed);
  Forms forms(seed);
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    const Form form = forms.form(i % 4);
    const Vec3d origin = forms.vec(4), direction = forms.vec(1);
    const auto span = line(form, origin, direction);
    const auto narrow = line<float>(form, origin, direction);
    hits += span.empty ? 0 : 1;
    for (int k = 0; k < 20; ++k) {
      const double t = forms.number(-12, 12);
      if (std::abs(t - span.enter) < 1e-9 || std::abs(t - span.leave) < 1e-9) continue;
      ASSERT_EQ(inside(form, origin + direction * t), !span.empty && t > span.enter && t < span.leave) << i;
    }
    if (!span.empty && !narrow.empty && span.leave - span.enter > 0.2) {
      const double tolerance = 1e-4 * (1 + 10 / glm::length(direction));
      if (std::abs(span.enter) < 100) {
        EXPECT_NEAR(static_cast<double>(narrow.enter), span.enter, tolerance + 1e-4 * std::abs(span.enter));
      }
      if (std::abs(span.leave) < 100) {
        EXPECT_NEAR(static_cast<double>(narrow.leave), span.leave, tolerance + 1e-4 * std::abs(span.leave));
      }
    }
  }
  EXPECT_GT(hits, 500);
}

// A ray that starts on a face meets that face at t = 0 by definition, and nothing else changes.
TEST(SolidLine, TheFaceThatARayStartsOnIsAtZero) {
  Forms forms(12);
  int checked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Form form = forms.form(i % 4);
    const Vec3d origin = forms.vec(4), direction = forms.vec(1);
    const auto span = line<float>(form, origin, direction);
    if (span.empty || !std::isfinite(span.enter) || !std::isfinite(span.leave) || span.leave - span.enter < 0.1f)
      continue;
    const Vec3d point = origin + direction * static_cast<double>(span.enter);
    const auto again = line<float>(form, point, direction, span.enter_face);
    EXPECT_EQ(again.enter, 0) << i;
    EXPECT_NEAR(again.leave, span.leave - span.enter, 1e-3f * (1 + std::abs(span.leave)));
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(UvMaps, CornersOfTheCubeCrossMeet) {
  const auto at = [](int face, Vec3d p) { return cube_cross_uv(face, p); };
  EXPECT_EQ(at(4, {-1, 1, -1}), (Vec2d{0.25, 1.0 / 3}));  // the front's top left
  EXPECT_EQ(at(0, {-1, 1, -1}), (Vec2d{0.25, 1.0 / 3}));  // is the left's top right
  EXPECT_EQ(at(3, {-1, 1, -1}), (Vec2d{0.25, 1.0 / 3}));  // and the top's bottom left
  EXPECT_EQ(at(1, {1, -1, -1}), (Vec2d{0.5, 2.0 / 3}));
  EXPECT_EQ(at(2, {1, -1, -1}), (Vec2d{0.5, 2.0 / 3}));
  EXPECT_EQ(at(5, {1, 1, 1}), (Vec2d{0.75, 1.0 / 3}));
}

TEST(UvMaps, WorldMapHasItsMiddleInFront) {
  EXPECT_EQ(world_map_uv(Vec3d{0, 0, -1}), (Vec2d{0.5, 0.5}));
  EXPECT_DOUBLE_EQ(world_map_uv(Vec3d{1, 0, 0}).x, 0.75);
  EXPECT_DOUBLE_EQ(world_map_uv(Vec3d{0, 1, 0}).y, 0);
  EXPECT_DOUBLE_EQ(world_map_uv(Vec3d{0, -1, 0}).y, 1);
}

}  // namespace
}  // namespace ps::solid_line_test
