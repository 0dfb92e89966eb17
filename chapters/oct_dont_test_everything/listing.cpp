#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "options/listing.h"
#include "record/watch.h"
#include "textbook/book_canvas.h"
#include "textbook/book_math.h"
#include "textbook/book_scene.h"

namespace ps {
namespace oct_dont_test_everything {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Triangle {
  std::array<Vec3d, 3> vertices;  // in the world
  Vec3d colour;
};

struct Ray {
  Vec3d origin, direction;
  double t_min = 1;
};

// A box with the triangles in it, or with eight smaller boxes.
struct Cell {
  Vec3d low{infinity}, high{-infinity};
  std::vector<const Triangle*> triangles;
  std::array<std::unique_ptr<Cell>, 8> children;
  bool leaf = true;
};

// Whether a triangle may lie in a cell: the box around it and the
// cell meet on all axes.
bool touches(const Triangle& triangle, const Cell& cell) {
  const auto& [a, b, c] = triangle.vertices;
  for (int i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax({a[i], b[i], c[i]});
    if (high < cell.low[i] || low > cell.high[i]) return false;
  }
  return true;
}

// When cells are split no further.
struct Limits {
  std::size_t most_triangles = 8;
  // Cells around a corner that many triangles share never hold few.
  int cells_left = 200000;
};

// Halves a cell in x, y and z, and goes on in each of the eight
// parts until it holds few triangles.
void split(Cell& cell, int levels, Limits& limits) {
  if (cell.triangles.size() <= limits.most_triangles) return;
  if (levels == 0 || limits.cells_left < 8) return;
  limits.cells_left -= 8;
  const Vec3d middle = (cell.low + cell.high) * 0.5;
  for (unsigned i = 0; i < 8; ++i) {
    cell.children[i] = std::make_unique<Cell>();
    Cell& child = *cell.children[i];
    for (int axis = 0; axis < 3; ++axis) {
      const unsigned bit = 1u << static_cast<unsigned>(axis);
      const bool upper = (i & bit) != 0;
      child.low[axis] = upper ? middle[axis] : cell.low[axis];
      child.high[axis] = upper ? cell.high[axis] : middle[axis];
    }
    // A triangle on the border of two cells is entered in both.
    for (const Triangle* triangle : cell.triangles)
      if (touches(*triangle, child))
        child.triangles.push_back(triangle);
    split(child, levels - 1, limits);
  }
  cell.leaf = false;
  cell.triangles.clear();
}

// Where the ray enters a box; infinity if it misses it.
double enters(const Ray& ray, const Cell& cell) {
  // Boxes are a little larger than they say, or a flat one would be
  // missed.
  constexpr double rounding = 1e-9;
  double first = 0, last = infinity;
  for (int i = 0; i < 3; ++i) {
    const double start = ray.origin[i], pace = ray.direction[i];
    double t_in = (cell.low[i] - rounding - start) / pace;
    double t_out = (cell.high[i] + rounding - start) / pace;
    if (t_in > t_out) std::swap(t_in, t_out);
    first = std::max(first, t_in);
    last = std::min(last, t_out);
  }
  return first <= last ? first : infinity;
}

// The ray parameter at which a triangle is met, or infinity.
double intersect(const Ray& ray, const std::array<Vec3d, 3>& v) {
  const Vec3d e1 = v[1] - v[0], e2 = v[2] - v[0];
  const Vec3d p = cross(ray.direction, e2);
  const Vec3d s = ray.origin - v[0];
  const Vec3d q = cross(s, e1);
  const double determinant = dot(e1, p);
  if (determinant == 0) return infinity;
  const double w1 = dot(s, p) / determinant;
  const double w2 = dot(ray.direction, q) / determinant;
  if (w1 < 0 || w2 < 0 || w1 + w2 > 1) return infinity;
  return dot(e2, q) / determinant;
}

struct Nearest {
  double t = infinity;
  const Triangle* triangle = nullptr;
};

// Goes down into the cells that the ray crosses, the nearest first,
// and leaves out those behind what was hit already.
void descend(const Cell& cell, const Ray& ray, Nearest& nearest) {
  if (cell.leaf) {
    for (const Triangle* triangle : cell.triangles) {
      const double t = intersect(ray, triangle->vertices);
      if (t <= ray.t_min || t >= nearest.t) continue;
      nearest = {t, triangle};
      PS_WATCH("closest t so far", t);
    }
    PS_WATCH("triangles tested", cell.triangles.size());
    return;
  }
  std::array<std::pair<double, const Cell*>, 8> order;
  for (std::size_t i = 0; i < 8; ++i) {
    const Cell* child = cell.children[i].get();
    order[i] = {enters(ray, *child), child};
  }
  const auto sooner = [](const auto& a, const auto& b) {
    return a.first < b.first;
  };
  std::stable_sort(order.begin(), order.end(), sooner);
  for (const auto& [t, child] : order) {
    if (t == infinity) break;
    PS_EACH("cell entered at t", t);
    PS_WATCH("from", child->low);
    PS_WATCH("to", child->high);
    if (t > nearest.t) break;
    descend(*child, ray, nearest);
  }
}

std::vector<Triangle> triangles_of(const BookScene& scene) {
  std::vector<Triangle> all;
  for (const BookInstance& instance : scene.instances) {
    const Transform& t = instance.instance->transform;
    const Mat4d to_world = model_to_world(t);
    const auto& positions = instance.model->positions;
    for (const MeshTriangle& face : instance.model->triangles) {
      Triangle made;
      made.colour = surface_of(scene, instance, face).colour;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3d& vertex = positions[face.position[k]];
        made.vertices[k] = transform(to_world, vertex);
      }
      all.push_back(made);
    }
  }
  return all;
}

// The cell around all triangles.
Cell root_of(const std::vector<Triangle>& triangles) {
  Cell root;
  for (const Triangle& triangle : triangles) {
    root.triangles.push_back(&triangle);
    for (const Vec3d& vertex : triangle.vertices)
      for (int axis = 0; axis < 3; ++axis) {
        double &low = root.low[axis], &high = root.high[axis];
        low = std::min(low, vertex[axis]);
        high = std::max(high, vertex[axis]);
      }
  }
  return root;
}

// From the eye through a place of the canvas.
Vec3d eye_direction(const BookScene& scene, int x, int y) {
  const Camera& camera = scene.camera;
  const double across = x * camera.viewport_width / scene.width;
  const double up = y * camera.viewport_height / scene.height;
  return camera.right * across + camera.up * up +
         camera.forward * camera.projection_plane_d;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const Settings& settings = scene.settings;
  const std::vector<Triangle> triangles = triangles_of(scene);
  Cell root = root_of(triangles);
  Limits limits;
  limits.most_triangles =
      static_cast<std::size_t>(settings.octree_leaf);
  split(root, settings.octree_depth, limits);

  const Vec3d origin = scene.camera.position;
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      PS_PIXEL(x, y);
      const Vec3d direction = eye_direction(scene, x, y);
      PS_WATCH("direction", direction);
      const Ray ray{origin, direction, settings.near};
      Nearest nearest;
      descend(root, ray, nearest);
      Vec3d colour = scene.background;
      if (nearest.triangle) colour = nearest.triangle->colour;
      canvas.put_pixel(x, y, colour);
    }
  }
}

}  // namespace
}  // namespace oct_dont_test_everything

namespace textbook {
extern const Listing oct_dont_test_everything;
const Listing oct_dont_test_everything{
    .label = "octree",
    .source = "OCT",
    .shows =
        "Models in plain colours by rays, which go down an octree.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {"octree-leaf", "octree-depth", "near"},
    .draws = {.models = true},
    .as_settings =
        [](Settings& settings) {
          settings.accelerator = Accelerator::octree;
          settings.triangle_test = TriangleTest::moeller_trumbore;
        },
    .suits =
        [](const SceneTraits& traits, const Settings&) {
          return traits.triangles ? 1 : 0;
        },
    .draw = ps::oct_dont_test_everything::draw,
};
}  // namespace textbook
}  // namespace ps
