#include "accel/bounding_spheres.h"

#include <algorithm>
#include <numeric>

#include "base/stop.h"
#include "math/unit.h"

namespace ps {
namespace {

constexpr std::uint32_t leaf_size = 4;

class SphereTreeBuilder {
 public:
  explicit SphereTreeBuilder(std::span<const BoundedPrimitive> primitives) : primitives_(primitives) {}

  BoundingSpheres build() {
    const auto count = static_cast<std::uint32_t>(primitives_.size());
    if (count == 0) return {};
    spheres_.order.resize(count);
    std::iota(spheres_.order.begin(), spheres_.order.end(), 0u);
    std::vector<Item> objects;
    for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
      for (end = begin; end < count && primitives_[end].object == primitives_[begin].object; ++end) {
      }
      objects.push_back({begin, end, bound(begin, end).centre});
    }
    spheres_.nodes.emplace_back();
    add_objects(0, objects);
    return std::move(spheres_);
  }

 private:
  /// An object: its range of primitives.
  struct Item {
    std::uint32_t begin, end;
    Vec3d centre;
  };

  /// A sphere around the entries [begin, end) of the order: about the centre of their bounding box.
  SphereNode bound(std::uint32_t begin, std::uint32_t end) const {
    Box<double> box;
    for (std::uint32_t i = begin; i < end; ++i) {
      const BoundedPrimitive& primitive = primitives_[spheres_.order[i]];
      box.include(primitive.centre - primitive.radius);
      box.include(primitive.centre + primitive.radius);
    }
    SphereNode node;
    node.centre = (box.low + box.high) * 0.5;
    for (std::uint32_t i = begin; i < end; ++i) {
      const BoundedPrimitive& primitive = primitives_[spheres_.order[i]];
      const Vec3d away = primitive.centre - node.centre;
      node.radius = std::max(node.radius, length_of(away) + primitive.radius);
    }
    node.radius *= 1 + 1e-14;  // the rounding of the above
    return node;
  }

  template <class Iterator, class CentreOf>
  static Iterator halve(Iterator begin, Iterator end, CentreOf&& centre_of) {
    Box<double> box;
    for (Iterator i = begin; i != end; ++i) box.include(centre_of(*i));
    const Vec3d size = box.high - box.low;
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
                     [&](const auto& a, const auto& b) { return centre_of(a)[axis] < centre_of(b)[axis]; });
    return middle;
  }

  std::uint32_t make_children(std::uint32_t index) {
    const auto first = static_cast<std::uint32_t>(spheres_.nodes.size());
    spheres_.nodes.resize(spheres_.nodes.size() + 2);
    spheres_.nodes[index].first = first;
    return first;
  }

  /// The hierarchy above the objects. Its nodes are bounded when their children are.
  void add_objects(std::uint32_t index, std::span<Item> objects) {
    check_stop();
    if (objects.size() == 1) return add_primitives(index, objects[0].begin, objects[0].end);
    const auto middle = halve(objects.begin(), objects.end(), [](const Item& item) { return item.centre; });
    const auto half = static_cast<std::size_t>(middle - objects.begin());
    const std::uint32_t first = make_children(index);
    add_objects(first, objects.first(half));
    add_objects(first + 1, objects.subspan(half));
    const SphereNode around = around_two(spheres_.nodes[first], spheres_.nodes[first + 1]);
    spheres_.nodes[index].centre = around.centre;
    spheres_.nodes[index].radius = around.radius;
  }

  /// The smallest sphere around two.
  static SphereNode around_two(const SphereNode& a, const SphereNode& b) {
    const Vec3d apart = b.centre - a.centre;
    const double distance = length_of(apart);
    if (a.radius >= distance + b.radius) return a;
    if (b.radius >= distance + a.radius) return b;
    SphereNode node;
    node.radius = 0.5 * (distance + a.radius + b.radius);
    node.centre = a.centre + apart * ((node.radius - a.radius) / distance);
    node.radius *= 1 + 1e-14;
    return node;
  }

  void add_primitives(std::uint32_t index, std::uint32_t begin, std::uint32_t end) {
    check_stop();
    SphereNode node = bound(begin, end);
    if (end - begin <= leaf_size) {
      node.first = begin;
      node.count = end - begin;
      spheres_.nodes[index] = node;
      return;
    }
    spheres_.nodes[index] = node;
    const auto order = spheres_.order.begin();
    const auto middle = halve(order + begin, order + end, [&](std::uint32_t i) { return primitives_[i].centre; });
    const auto half = static_cast<std::uint32_t>(middle - order);
    const std::uint32_t first = make_children(index);
    add_primitives(first, begin, half);
    add_primitives(first + 1, half, end);
  }

  std::span<const BoundedPrimitive> primitives_;
  BoundingSpheres spheres_;
};

}  // namespace

BoundingSpheres build_bounding_spheres(std::span<const BoundedPrimitive> primitives) {
  return SphereTreeBuilder(primitives).build();
}

}  // namespace ps
