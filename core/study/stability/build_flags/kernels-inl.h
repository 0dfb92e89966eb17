// Included once by each file that compiles it with its own flags. It uses nothing but these lines and square roots:
// any function shared with the rest of the program could be the copy that the linker keeps.
#include "study/stability/build_flags/kernels.h"

namespace ps::stability {
namespace {

struct V {
  float x, y, z;
};
inline V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V operator*(float s, V a) { return {s * a.x, s * a.y, s * a.z}; }
inline float product(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline V crossed(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline V vector(const float (&v)[3]) { return {v[0], v[1], v[2]}; }
inline float size(float v) { return v < 0 ? -v : v; }

/// The vertices as the ray sees them: it runs along z through x = y = 0.
struct Sheared {
  float x[3], y[3];
};
Sheared sheared(const FlagRay& ray, const FlagTriangle& triangle) {
  const float* d = ray.direction;
  const int kz = size(d[0]) > size(d[1]) ? (size(d[0]) > size(d[2]) ? 0 : 2) : (size(d[1]) > size(d[2]) ? 1 : 2);
  int kx = (kz + 1) % 3, ky = (kx + 1) % 3;
  if (d[kz] < 0) {
    const int other = kx;
    kx = ky;
    ky = other;
  }
  const float sx = d[kx] / d[kz], sy = d[ky] / d[kz];
  Sheared result;
  for (int i = 0; i < 3; ++i) {
    const float* corner = triangle.corner[i];
    const float z = corner[kz] - ray.origin[kz];
    result.x[i] = corner[kx] - ray.origin[kx] - sx * z;
    result.y[i] = corner[ky] - ray.origin[ky] - sy * z;
  }
  return result;
}
inline bool one_side(float u, float v, float w) { return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0); }

/// Woop's test without the fallback to double, as its paper prints it.
bool flag_watertight(const FlagRay& ray, const FlagTriangle& triangle) {
  const auto [x, y] = sheared(ray, triangle);
  const float u = x[2] * y[1] - y[2] * x[1];
  const float v = x[0] * y[2] - y[0] * x[2];
  const float w = x[1] * y[0] - y[1] * x[0];
  return one_side(u, v, w);
}

/// The same, but each edge function's two products are compared and not subtracted, as Embree does: there is nothing to
/// fuse.
bool flag_compared_products(const FlagRay& ray, const FlagTriangle& triangle) {
  const auto [x, y] = sheared(ray, triangle);
  const auto side = [](float p, float q) { return p > q ? 1.0f : p < q ? -1.0f : 0.0f; };
  return one_side(side(x[2] * y[1], y[2] * x[1]), side(x[0] * y[2], y[0] * x[2]), side(x[1] * y[0], y[1] * x[0]));
}

/// The same with Kahan's difference of products, as pbrt does: what rounding took from the second product is added
/// again (Jeannerod et al., Mathematics of Computation 82, 2013).
bool flag_kahan_products(const FlagRay& ray, const FlagTriangle& triangle) {
  const auto [x, y] = sheared(ray, triangle);
  const auto difference = [](float a, float b, float c, float d) {
    const float rounded = c * d;
    return __builtin_fmaf(a, b, -rounded) + __builtin_fmaf(-c, d, rounded);
  };
  return one_side(difference(x[2], y[1], y[2], x[1]), difference(x[0], y[2], y[0], x[2]),
                  difference(x[1], y[0], y[1], x[0]));
}

bool flag_moeller_trumbore(const FlagRay& ray, const FlagTriangle& triangle) {
  const V a = vector(triangle.corner[0]), d = vector(ray.direction);
  const V b = vector(triangle.corner[1]) - a, c = vector(triangle.corner[2]) - a;
  const V p = crossed(d, c);
  const float determinant = product(b, p);
  if (!(determinant != 0)) return false;
  const V s = vector(ray.origin) - a, q = crossed(s, b);
  const float u = product(s, p) / determinant, v = product(d, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && product(c, q) / determinant > 0;
}

struct Ball {
  V centre;
  float radius;
  V colour;
  float specular, reflective;
};
constexpr Ball balls[4] = {{{0, -1, 3}, 1, {255, 0, 0}, 500, 0.2f},
                           {{-2, 0, 4}, 1, {0, 255, 0}, 10, 0.4f},
                           {{2, 0, 4}, 1, {0, 0, 255}, 500, 0.3f},
                           {{0, -5001, 0}, 5000, {255, 255, 0}, 1000, 0.5f}};
constexpr float beyond = 1e30f, start_epsilon = 0.001f;

struct Meeting {
  int ball = -1;
  float t = beyond;
};
Meeting nearest(V origin, V direction, float t_min, float t_max) {
  Meeting best{-1, t_max};
  for (int i = 0; i < 4; ++i) {
    const V f = origin - balls[i].centre;
    const float a = product(direction, direction), b = 2 * product(f, direction);
    const float c = product(f, f) - balls[i].radius * balls[i].radius;
    const float discriminant = b * b - 4 * a * c;
    if (discriminant < 0) continue;
    const float root = __builtin_sqrtf(discriminant);
    const float t1 = (-b + root) / (2 * a), t2 = (-b - root) / (2 * a);
    if (t1 > t_min && t1 < best.t) best = {i, t1};
    if (t2 > t_min && t2 < best.t) best = {i, t2};
  }
  return best;
}
V mirrored(V ray, V normal) { return 2 * product(normal, ray) * normal - ray; }

/// `base` to a whole power, without a call that another file might bring.
float power(float base, int exponent) {
  float result = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result *= base;
    base *= base;
  }
  return result;
}

float light_at(V point, V normal, V view, float specular) {
  float sum = 0.2f;
  for (int light = 0; light < 2; ++light) {
    const V to_light = light == 0 ? V{2, 1, 0} - point : V{1, 4, 4};
    const float intensity = light == 0 ? 0.6f : 0.2f;
    if (nearest(point, to_light, start_epsilon, light == 0 ? 1.0f : beyond).ball >= 0) continue;
    const float facing = product(normal, to_light);
    const float length = __builtin_sqrtf(product(to_light, to_light));
    if (facing > 0) sum += intensity * facing / (__builtin_sqrtf(product(normal, normal)) * length);
    const V r = mirrored(to_light, normal);
    const float along = product(r, view);
    if (along > 0)
      sum += intensity * power(along / (__builtin_sqrtf(product(r, r)) * __builtin_sqrtf(product(view, view))),
                               static_cast<int>(specular));
  }
  return sum;
}

V traced(V origin, V direction, float t_min, int depth) {
  const Meeting met = nearest(origin, direction, t_min, beyond);
  if (met.ball < 0) return {0, 0, 0};
  const Ball& ball = balls[met.ball];
  const V point = origin + met.t * direction;
  V normal = point - ball.centre;
  normal = (1.0f / __builtin_sqrtf(product(normal, normal))) * normal;
  const V view = -1.0f * direction;
  const V local = light_at(point, normal, view, ball.specular) * ball.colour;
  if (depth <= 0) return local;
  const V reflected = traced(point, mirrored(view, normal), start_epsilon, depth - 1);
  return (1 - ball.reflective) * local + ball.reflective * reflected;
}

std::uint8_t level(float value) {
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): lround() would be a call into code with other flags
  return static_cast<std::uint8_t>(value < 0 ? 0 : value > 255 ? 255 : static_cast<int>(value + 0.5f));
}

void flag_book_picture(int side, std::uint8_t* pixels) {
  const int half = side / 2;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const V direction{static_cast<float>(column - half) / static_cast<float>(side),
                        static_cast<float>(half - 1 - row) / static_cast<float>(side), 1};
      const V colour = traced({0, 0, 0}, direction, 1, 3);
      *pixels++ = level(colour.x);
      *pixels++ = level(colour.y);
      *pixels++ = level(colour.z);
    }
}

/// What this file was compiled to.
FlagBuild flag_build(
    const char* name, bool (*available)() = [] { return true; }) {
  return {name,
          available,
          flag_watertight,
          flag_compared_products,
          flag_kahan_products,
          flag_moeller_trumbore,
          flag_book_picture};
}

}  // namespace
}  // namespace ps::stability
