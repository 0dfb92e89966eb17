#include "scene_random.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/rotation.h"
#include "scene/texture_generator.h"

namespace ps::test {
namespace {

class Dice {
 public:
  explicit Dice(std::mt19937_64& random) : random_(random) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  bool coin() { return below(2) == 0; }
  Vec3d vec() { return {number(-9, 9), number(-9, 9), number(-9, 9)}; }
  /// Sometimes levels as people write them, sometimes any shares, beyond 1 too.
  Vec3d colour() {
    if (coin()) return Vec3d{below(256), below(256), below(256)} / 255.0;
    return {number(0, 1.5), number(0, 1), number(0, 1)};
  }
  Mat3d rotation() {
    const auto axis = static_cast<Axis>(below(3));
    if (coin()) return rotation_about(axis, below(360));
    return rotation_about(axis, number(-180, 180)) * rotation_about(Axis::y, number(-180, 180));
  }

 private:
  std::mt19937_64& random_;
};

Material random_material(Dice& dice, const std::string& name) {
  Material material;
  material.name = name;
  material.colour = dice.colour();
  if (dice.coin()) material.specular = dice.number(0.1, 1000);
  if (dice.coin()) material.transparency = dice.number(0, 1);
  if (dice.coin()) material.refraction_index = dice.number(1, 2);
  if (dice.coin()) material.reflective = dice.number(0, 1);
  if (dice.coin()) material.specular_colour = dice.colour();
  if (dice.coin()) material.ambient_colour = dice.colour();
  return material;
}

Mesh random_mesh(Dice& dice, const std::string& name, std::uint32_t materials) {
  Mesh mesh;
  mesh.name = name;
  const int corners = 3 + dice.below(5);
  for (int i = 0; i < corners; ++i) {
    mesh.positions.push_back(dice.vec());
    mesh.normals.push_back(dice.vec());
    mesh.uvs.emplace_back(dice.number(-1, 2), dice.number(-1, 2));
  }
  for (std::uint32_t slot = 0; slot < materials; ++slot) mesh.materials.push_back(materials - 1 - slot);
  for (int i = 0; i <= dice.below(6); ++i) {
    MeshTriangle triangle;
    const bool normals = dice.coin(), uvs = dice.coin();
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.position[k] = static_cast<std::uint32_t>(dice.below(corners));
      if (normals) triangle.normal[k] = dice.below(corners);
      if (uvs) triangle.uv[k] = dice.below(corners);
    }
    triangle.material = static_cast<std::uint32_t>(dice.below(static_cast<int>(materials)));
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// Of kinds 0 = box, 1 = cylinder, 2 = plane, 3 = rectangle, 4 = ball (inside CSG only).
Solid random_solid(Dice& dice, std::uint32_t materials, int kind) {
  Solid solid;
  if (kind == 0) solid.form = Brick{dice.vec(), Vec3d{dice.number(0.1, 3), 1, 2}, dice.rotation()};
  if (kind == 1) solid.form = Cylinder{dice.vec(), dice.vec(), dice.number(0.1, 3)};
  if (kind == 2) solid.form = Plane{dice.vec(), dice.vec()};
  if (kind == 3) solid.form = Rectangle{dice.vec(), {dice.number(0.1, 5), 0, 0}, {0, dice.number(-5, -0.1), 2}};
  if (kind == 4) solid.form = Ball{dice.vec(), dice.number(0.1, 5)};
  solid.material = static_cast<std::uint32_t>(dice.below(static_cast<int>(materials)));
  return solid;
}

CsgNode random_tree(Dice& dice, std::uint32_t materials, int depth) {
  CsgNode node;
  if (depth == 0 || (depth == 1 && dice.coin())) {
    const int kind = dice.below(4);
    node.part = random_solid(dice, materials, kind == 3 ? 4 : kind);
    return node;
  }
  node.operation = static_cast<CsgOperation>(dice.below(3));
  for (int i = 0; i < 2 + dice.below(2); ++i) node.children.push_back(random_tree(dice, materials, depth - 1));
  return node;
}

/// Its vertices lie on an ellipse, so it is convex.
CanvasPolygon random_polygon(Dice& dice, Blend blend) {
  CanvasPolygon polygon;
  const Vec2d middle{dice.number(-300, 300), dice.number(-300, 300)}, radius{dice.number(1, 90), dice.number(1, 90)};
  const int count = 3 + dice.below(7);
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * (i + 0.5 * dice.number(0, 1)) / count;
    polygon.vertices.push_back(
        {middle + radius * Vec2d{std::cos(angle), std::sin(angle)}, dice.colour(), dice.number(-1, 2)});
  }
  polygon.filled = dice.coin();
  polygon.blend = blend;
  if (dice.coin()) polygon.outline = dice.colour();
  return polygon;
}

CanvasItem random_item(Dice& dice) {
  const auto point = [&] { return Vec2d{dice.number(-300, 300), dice.number(-300, 300)}; };
  const auto blend = static_cast<Blend>(dice.below(3));
  if (dice.coin()) return CanvasLine{{point(), point()}, dice.colour(), blend};
  if (dice.coin()) return random_polygon(dice, blend);
  CanvasTriangle triangle{
      {point(), point(), point()}, {dice.colour(), dice.colour(), dice.colour()}, {}, true, blend, {}};
  triangle.h = {dice.number(-1, 2), 1, 0};
  triangle.filled = dice.coin();
  if (dice.coin()) triangle.outline = dice.colour();
  return triangle;
}

}  // namespace

Scene scene_with_everything(std::mt19937_64& random) {
  Dice dice(random);
  Scene scene;
  scene.title = "A \"title\" with \\ and # in it";
  scene.keywords = "z-buffer, \"AA\"";
  scene.canvas_width = 1 + dice.below(2000);
  scene.canvas_height = 1 + dice.below(2000);
  scene.start_pixel =
      dice.coin() ? Vec2i{dice.below(scene.canvas_width), dice.below(scene.canvas_height)} : Vec2i{-1, -1};
  scene.background = dice.colour();
  const Mat3d frame = dice.coin() ? dice.rotation() : Mat3d(dice.vec(), dice.vec(), dice.vec());
  scene.camera = {dice.vec(),          frame[0],           frame[1], frame[2], dice.number(0.1, 9),
                  dice.number(0.1, 9), dice.number(0.1, 9)};
  if (dice.coin()) scene.settings = {{"shading", "flat"}, {"shadow-epsilon", "0.01"}};

  std::vector<Texture> textures;
  const int size = 1 + dice.below(8);
  textures.push_back(
      {"some tiles", "", std::make_shared<const Image<Vec3f>>(generate_texture("tiles", size)), "tiles"});
  std::vector<Material> materials;
  Geometry geometry;
  const auto shared = static_cast<std::uint32_t>(1 + dice.below(4));
  for (std::uint32_t i = 0; i < shared; ++i) materials.push_back(random_material(dice, "shared " + std::to_string(i)));
  for (int i = 0; i < dice.below(3); ++i)
    geometry.meshes.push_back(std::make_shared<const Mesh>(random_mesh(dice, "mesh-" + std::to_string(i), shared)));
  for (int i = 0; i < dice.below(8); ++i) {
    Object object{"thing " + std::to_string(i), {}};
    const int shape = dice.below(6);
    if (shape < 2) {
      object.shape = shape == 0 ? decltype(object.shape)(random_solid(dice, shared, dice.below(4)))
                                : decltype(object.shape)(Csg{random_tree(dice, shared, 2)});
      geometry.objects.push_back(object);
      continue;
    }
    if (geometry.meshes.empty() || dice.coin()) {
      Sphere sphere{dice.vec(), dice.number(1e-6, 5000),
                    static_cast<std::uint32_t>(dice.below(static_cast<int>(shared)))};
      if (dice.coin()) {  // one of its own, as the book's spheres have
        sphere.material = static_cast<std::uint32_t>(materials.size());
        materials.push_back(random_material(dice, object.name));
        if (dice.coin()) materials.back().texture = 0;
        if (dice.coin()) materials.back().normal_map = 0;
        if (dice.coin()) materials.back().height_map = 0;
        if (dice.coin()) materials.back().relief_depth = dice.number(0, 1);
      }
      object.shape = sphere;
    } else {
      Instance instance;
      instance.mesh = static_cast<std::uint32_t>(dice.below(static_cast<int>(geometry.meshes.size())));
      if (dice.coin()) instance.transform.scale = dice.coin() ? Vec3d(dice.number(0.1, 3)) : dice.vec();
      if (dice.coin()) instance.transform.rotation = dice.rotation();
      instance.transform.translation = dice.vec();
      if (dice.coin()) instance.sides = Sides::front;
      if (dice.coin()) instance.material = static_cast<std::uint32_t>(dice.below(static_cast<int>(shared)));
      object.shape = instance;
    }
    geometry.objects.push_back(object);
  }
  std::vector<Light> lights;
  for (int i = 0; i < dice.below(4); ++i) {
    Light light;
    light.kind = static_cast<LightKind>(dice.below(3));
    light.intensity = dice.number(0, 2);
    if (dice.coin()) light.colour = dice.colour();
    if (light.kind == LightKind::point) light.position = dice.vec();
    if (light.kind == LightKind::point && dice.coin()) light.attenuation = {dice.number(0, 1), 0.5, dice.number(0, 2)};
    if (light.kind == LightKind::point && dice.coin()) light.radius = dice.number(0, 1);
    if (light.kind != LightKind::ambient && dice.coin()) light.specular_colour = dice.colour();
    if (light.kind != LightKind::ambient && dice.coin()) light.ambient_colour = dice.colour();
    if (light.kind == LightKind::directional) light.direction = dice.vec();
    lights.push_back(light);
  }
  std::vector<CanvasItem> items;
  items.reserve(4);
  for (int i = 0; i < dice.below(4); ++i) items.push_back(random_item(dice));

  scene.geometry = Part<Geometry>(geometry);
  scene.materials = Part<std::vector<Material>>(materials);
  scene.textures = Part<std::vector<Texture>>(textures);
  scene.lights = Part<std::vector<Light>>(lights);
  scene.canvas_items = Part<std::vector<CanvasItem>>(items);
  return scene;
}

void expect_equal_scenes(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.keywords, b.keywords);
  EXPECT_EQ(a.canvas_width, b.canvas_width);
  EXPECT_EQ(a.canvas_height, b.canvas_height);
  EXPECT_TRUE(a.camera == b.camera);
  EXPECT_EQ(a.background, b.background);
  EXPECT_EQ(a.settings, b.settings);
  EXPECT_EQ(a.start_pixel, b.start_pixel);
  EXPECT_TRUE(*a.lights == *b.lights);
  EXPECT_TRUE(*a.materials == *b.materials);
  EXPECT_TRUE(*a.canvas_items == *b.canvas_items);
  EXPECT_TRUE(a.geometry->objects == b.geometry->objects);
  ASSERT_EQ(a.geometry->meshes.size(), b.geometry->meshes.size());
  for (std::size_t i = 0; i < a.geometry->meshes.size(); ++i) {
    Mesh mesh = *b.geometry->meshes[i];
    mesh.source = a.geometry->meshes[i]->source;
    EXPECT_TRUE(*a.geometry->meshes[i] == mesh) << "mesh " << i;
  }
  ASSERT_EQ(a.textures->size(), b.textures->size());
  for (std::size_t i = 0; i < a.textures->size(); ++i) {
    EXPECT_EQ(a.textures->at(i).name, b.textures->at(i).name);
    EXPECT_EQ(a.textures->at(i).generator, b.textures->at(i).generator);
    EXPECT_TRUE(*a.textures->at(i).texels == *b.textures->at(i).texels);
  }
}

}  // namespace ps::test
