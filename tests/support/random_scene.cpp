#include "support/random_scene.h"

#include <array>

#include <cmath>
#include <random>

namespace ps::test {
namespace {

/// Uniform numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  Vec3d point(double low, double high) {
    const double x = between(low, high);
    const double y = between(low, high);
    return {x, y, between(low, high)};
  }
  bool chance(double share) { return between(0, 1) < share; }
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(between(0, count)); }

 private:
  std::mt19937_64 engine_;
};

Mat3d rotation(Random& random) {
  const double a = random.between(0, 6.28), b = random.between(0, 6.28);
  const Mat3d about_y{std::cos(a), 0, std::sin(a), 0, 1, 0, -std::sin(a), 0, std::cos(a)};
  const Mat3d about_x{1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b)};
  return about_x * about_y;
}

Material material(Random& random) {
  Material result;
  result.colour = random.point(0, 1);
  if (random.chance(0.6)) result.specular = random.between(5, 800);
  if (random.chance(0.5)) result.reflective = random.between(0.1, 0.9);
  if (random.chance(0.2)) result.specular_colour = random.point(0, 1);
  if (random.chance(0.2)) result.ambient_colour = random.point(0, 1);
  if (random.chance(0.5)) result.texture = 0;
  return result;
}

Light light(Random& random, LightKind kind) {
  Light result;
  result.kind = kind;
  result.intensity = random.between(0.1, 0.7);
  if (random.chance(0.5)) result.colour = random.point(0, 1);
  result.position = random.point(-6, 6);
  result.direction = random.point(-2, 2);
  return result;
}

/// A bumpy grid over the unit square: every inner edge is shared, and one triangle has no area.
Mesh grid(Random& random, int side) {
  Mesh mesh;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      const double u = double(x) / side, v = double(y) / side;
      mesh.positions.push_back({2 * u - 1, random.between(-0.3, 0.3), 2 * v - 1});
      mesh.normals.push_back({random.between(-0.5, 0.5), 1, random.between(-0.5, 0.5)});
      mesh.uvs.push_back({3 * u - 1, 2 * v});
    }
  }
  const auto corner = [side](int x, int y) { return static_cast<std::uint32_t>(y * (side + 1) + x); };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    MeshTriangle triangle;
    triangle.position = {a, b, c};
    for (std::size_t k = 0; k < 3; ++k) {
      if (random.chance(0.9)) triangle.normal[k] = static_cast<std::int32_t>(triangle.position[k]);
      triangle.uv[k] = static_cast<std::int32_t>(triangle.position[k]);
    }
    mesh.triangles.push_back(triangle);
  };
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      add(corner(x, y), corner(x, y + 1), corner(x + 1, y));
      add(corner(x + 1, y), corner(x, y + 1), corner(x + 1, y + 1));
    }
  }
  add(corner(0, 0), corner(1, 1), corner(0, 0));
  return mesh;
}

Texture checkerboard() {
  Image<Vec3f> texels(4, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) texels.at(x, y) = (x + y) % 2 == 0 ? Vec3f(1, 1, 1) : Vec3f(0.2f, 0.1f, 0.4f);
  return {"checkerboard", "", std::make_shared<const Image<Vec3f>>(std::move(texels))};
}

/// Every form, alone and in CSG trees.
Form form(Random& random, unsigned kind) {
  const Vec3d point = random.point(-3, 3);
  const Mat3d frame = rotation(random);
  switch (kind) {
  case 0:
    return Ball{point, random.between(0.3, 1.2)};
  case 1:
    return Plane{{0, -2, 0}, {random.between(-0.2, 0.2), 1, random.between(-0.2, 0.2)}};
  case 2:
    return Rectangle{point, frame[0] * random.between(0.5, 2), frame[1] * random.between(0.5, 2)};
  case 3:
    return Brick{point, random.point(0.3, 1.5), frame};
  default:
    return Cylinder{point, point + frame[0] * random.between(0.3, 2), random.between(0.2, 0.8)};
  }
}

CsgNode csg_tree(Random& random, int depth) {
  CsgNode node;
  if (depth == 0) {
    constexpr std::array<unsigned, 3> bodies{0, 3, 4};
    node.part = {form(random, bodies[random.below(3)]), random.below(6), Sides::two};
    return node;
  }
  node.operation = static_cast<CsgOperation>(random.below(3));
  for (int i = 0; i < 2; ++i) node.children.push_back(csg_tree(random, depth - 1));
  return node;
}

/// Turned, stretched and mirrored.
PartPlace place(Random& random) {
  PartPlace place;
  const Mat3d turn = rotation(random);
  place.linear =
      Mat3d(turn[0] * random.between(0.5, 2), turn[1] * random.between(0.5, 2), turn[2] * random.between(-2, -0.5));
  place.translation = random.point(-0.5, 0.5);
  return place;
}

/// Bodies as a group that stretches leaves them behind.
void stretch_bodies(unsigned seed, Geometry& geometry) {
  Random random(seed + 15485863);  // of its own, so that all else stays as it was
  for (Object& object : geometry.objects)
    if (auto* solid = std::get_if<Solid>(&object.shape))
      if (!is_flat(solid->form) && random.chance(0.5)) solid->place = place(random);
}

void add_solids(unsigned seed, Geometry& geometry) {
  Random random(seed + 7919);
  for (unsigned kind = 1; kind < 5; ++kind)
    if (random.chance(0.3))
      geometry.objects.push_back(
          {"solid", Solid{form(random, kind), random.below(6), random.chance(0.5) ? Sides::two : Sides::front}});
  stretch_bodies(seed, geometry);
  if (!random.chance(0.3)) return;
  Csg csg{csg_tree(random, 2)};
  Random placing(seed + 104729);  // of its own, so that all else stays as it was
  for (Solid* part : csg_parts(csg.root))
    if (placing.chance(0.3)) part->place = place(placing);
  geometry.objects.push_back({"csg", std::move(csg)});
}

}  // namespace

Scene random_scene(unsigned seed) {
  Random random(seed);
  Scene scene;
  scene.name = "random";
  scene.background = random.point(0, 1);
  scene.camera.position = random.point(-1, 1) + Vec3d(0, 1, -6);
  const Mat3d turn = rotation(random);
  if (random.chance(0.5)) scene.camera = {turn * scene.camera.position, turn[0], turn[1], turn[2], 1, 1, 1};

  std::vector<Material> materials;
  materials.reserve(6);
  for (int i = 0; i < 6; ++i) materials.push_back(material(random));
  scene.materials = Part(std::move(materials));
  scene.textures = Part(std::vector<Texture>{checkerboard()});

  Geometry geometry;
  Mesh mesh = grid(random, 6);
  mesh.materials = {random.below(6)};
  geometry.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
  if (random.chance(0.7)) geometry.objects.push_back({"ground", Sphere{{0, -5001.5, 0}, 5000, random.below(6)}});
  const int spheres = random.chance(0.3) ? 0 : static_cast<int>(random.below(40));
  for (int i = 0; i < spheres; ++i)
    geometry.objects.push_back({"sphere", Sphere{random.point(-3, 3), random.between(0.02, 0.8), random.below(6)}});
  const int placements = spheres > 0 && random.chance(0.3) ? 0 : 2;
  for (int i = 0; i < placements; ++i) {
    Instance instance;
    instance.transform = {random.point(0.5, 2), rotation(random), random.point(-2, 2)};
    if (random.chance(0.5)) instance.material = random.below(6);
    geometry.objects.push_back({"grid", instance});
  }
  add_solids(seed, geometry);
  scene.geometry = Part(std::move(geometry));

  std::vector<Light> lights{light(random, LightKind::ambient), light(random, LightKind::point)};
  if (random.chance(0.7)) lights.push_back(light(random, LightKind::directional));
  scene.lights = Part(std::move(lights));
  return scene;
}

}  // namespace ps::test
