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

// A box with the triangles in it, or with eight smaller boxes.
struct Cell {
  Vec3d low{infinity}, high{-infinity};
  std::vector<const Triangle*> triangles;
  std::array<std::unique_ptr<Cell>, 8> children;
  bool leaf = true;
};

// Whether a triangle may lie in a cell: the box around it and the cell meet on all axes.
bool touches(const Triangle& triangle, const Cell& cell) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] =
        std::minmax({triangle.vertices[0][axis], triangle.vertices[1][axis], triangle.vertices[2][axis]});
    if (high < cell.low[axis] || low > cell.high[axis]) return false;
  }
  return true;
}

// Halves a cell in x, y and z, and goes on in each of the eight parts until it holds few triangles. Cells around a
// corner that many triangles share never do: `cells_left` ends that.
void split(Cell& cell, std::size_t most_triangles, int levels, int& cells_left) {
  if (cell.triangles.size() <= most_triangles || levels == 0 || cells_left < 8) return;
  cells_left -= 8;
  const Vec3d middle = (cell.low + cell.high) * 0.5;
  for (unsigned i = 0; i < 8; ++i) {
    cell.children[i] = std::make_unique<Cell>();
    Cell& child = *cell.children[i];
    for (int axis = 0; axis < 3; ++axis) {
      const bool upper = (i >> static_cast<unsigned>(axis) & 1u) != 0;
      child.low[axis] = upper ? middle[axis] : cell.low[axis];
      child.high[axis] = upper ? cell.high[axis] : middle[axis];
    }
    // A triangle on the border of two cells is entered in both.
    for (const Triangle* triangle : cell.triangles)
      if (touches(*triangle, child)) child.triangles.push_back(triangle);
    split(child, most_triangles, levels - 1, cells_left);
  }
  cell.leaf = false;
  cell.triangles.clear();
}

// Where the ray enters a box; infinity if it misses it.
double enters(const Vec3d& origin, const Vec3d& direction, const Cell& cell) {
  constexpr double rounding = 1e-9;  // boxes are a little larger than they say, or a flat one would be missed
  double first = 0, last = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    double t_in = (cell.low[axis] - rounding - origin[axis]) / direction[axis];
    double t_out = (cell.high[axis] + rounding - origin[axis]) / direction[axis];
    if (t_in > t_out) std::swap(t_in, t_out);
    first = std::max(first, t_in);
    last = std::min(last, t_out);
  }
  return first <= last ? first : infinity;
}

// The ray parameter at which a triangle is met, or infinity.
double intersect(const Vec3d& origin, const Vec3d& direction, const std::array<Vec3d, 3>& v) {
  const Vec3d e1 = v[1] - v[0], e2 = v[2] - v[0], p = cross(direction, e2), s = origin - v[0], q = cross(s, e1);
  const double determinant = dot(e1, p);
  if (determinant == 0) return infinity;
  const double w1 = dot(s, p) / determinant, w2 = dot(direction, q) / determinant;
  if (w1 < 0 || w2 < 0 || w1 + w2 > 1) return infinity;
  return dot(e2, q) / determinant;
}

struct Nearest {
  double t = infinity;
  const Triangle* triangle = nullptr;
};

// Goes down into the cells that the ray crosses, the nearest first, and leaves out those behind what was hit already.
void descend(const Cell& cell, const Vec3d& origin, const Vec3d& direction, double t_min, Nearest& nearest) {
  if (cell.leaf) {
    for (const Triangle* triangle : cell.triangles) {
      const double t = intersect(origin, direction, triangle->vertices);
      if (t <= t_min || t >= nearest.t) continue;
      nearest = {t, triangle};
      PS_WATCH("closest t so far", t);
    }
    PS_WATCH("triangles tested", cell.triangles.size());
    return;
  }
  std::array<std::pair<double, const Cell*>, 8> order;
  for (std::size_t i = 0; i < 8; ++i) order[i] = {enters(origin, direction, *cell.children[i]), cell.children[i].get()};
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [t, child] : order) {
    if (t == infinity) break;
    PS_EACH("cell entered at t", t);
    PS_WATCH("from", child->low);
    PS_WATCH("to", child->high);
    if (t > nearest.t) break;
    descend(*child, origin, direction, t_min, nearest);
  }
}

std::vector<Triangle> triangles_of(const BookScene& scene) {
  std::vector<Triangle> all;
  for (const BookInstance& instance : scene.instances) {
    const Transform& t = instance.instance->transform;
    const Mat4d place = translation_matrix(t.translation) * (rotation_matrix(t.rotation) * scale_matrix(t.scale));
    for (const MeshTriangle& triangle : instance.model->triangles) {
      Triangle made{{}, surface_of(scene, instance, triangle).colour};
      for (std::size_t k = 0; k < 3; ++k)
        made.vertices[k] = transform(place, instance.model->positions[triangle.position[k]]);
      all.push_back(made);
    }
  }
  return all;
}

void draw(const BookScene& scene, BookCanvas& canvas) {
  const std::vector<Triangle> triangles = triangles_of(scene);
  Cell root;
  for (const Triangle& triangle : triangles) {
    root.triangles.push_back(&triangle);
    for (const Vec3d& vertex : triangle.vertices)
      for (int axis = 0; axis < 3; ++axis) {
        root.low[axis] = std::min(root.low[axis], vertex[axis]);
        root.high[axis] = std::max(root.high[axis], vertex[axis]);
      }
  }
  int cells_left = 200000;
  split(root, static_cast<std::size_t>(scene.settings.octree_leaf), scene.settings.octree_depth, cells_left);

  const Camera& camera = scene.camera;
  for (int y = canvas.bottom(); y < canvas.top(); ++y) {
    for (int x = canvas.left(); x < canvas.right(); ++x) {
      PS_PIXEL(x, y);
      const Vec3d direction = camera.right * (x * camera.viewport_width / scene.width) +
                              camera.up * (y * camera.viewport_height / scene.height) +
                              camera.forward * camera.projection_plane_d;
      PS_WATCH("direction", direction);
      Nearest nearest;
      descend(root, camera.position, direction, scene.settings.near, nearest);
      canvas.put_pixel(x, y, nearest.triangle ? nearest.triangle->colour : scene.background);
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
    .shows = "Models in plain colours by rays, which go down an octree.",
    .order = ListingOrder::pixel_by_pixel,
    .reads = {"octree-leaf", "octree-depth", "near"},
    .draws = {.models = true},
    .as_settings =
        [](Settings& settings) {
          settings.accelerator = Accelerator::octree;
          settings.triangle_test = TriangleTest::moeller_trumbore;
        },
    .suits = [](const SceneTraits& traits, const Settings&) { return traits.triangles ? 1 : 0; },
    .draw = ps::oct_dont_test_everything::draw,
};
}  // namespace textbook
}  // namespace ps
