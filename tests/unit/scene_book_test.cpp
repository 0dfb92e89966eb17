#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include <nlohmann/json.hpp>

#include "scene/load.h"
#include "scene/rotation.h"
#include "scene/scene_file.h"

namespace scene_book_test {
namespace {

using nlohmann::json;

ps::Vec3d vec(const json& j) { return {j.at(0), j.at(1), j.at(2)}; }

/// The numbers of the book author's own programs.
const json& reference() {
  static const json data = json::parse(std::ifstream("tests/golden/reference/scenes.json"));
  return data;
}

ps::Mat3d rotation_of(const json& thing) {
  if (thing.contains("rotation_rows"))
    return ps::from_rows(vec(thing["rotation_rows"][0]), vec(thing["rotation_rows"][1]),
                         vec(thing["rotation_rows"][2]));
  return ps::rotation_about(ps::Axis::y, thing.value("oy_rotation_degrees", 0.0));
}

void expect_camera_and_lights(const ps::Scene& scene, const json& expected) {
  const json& camera = expected.at("camera");
  EXPECT_EQ(scene.camera.position, vec(camera.at("position")));
  EXPECT_EQ(ps::Mat3d(scene.camera.right, scene.camera.up, scene.camera.forward), rotation_of(camera));
  const json lights = expected.value("lights", json::array());
  ASSERT_EQ(scene.lights->size(), lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const ps::Light& light = scene.lights->at(i);
    EXPECT_EQ(light.intensity, lights[i].at("intensity").get<double>());
    EXPECT_EQ(light.kind == ps::LightKind::point, lights[i].contains("position"));
    EXPECT_EQ(light.kind == ps::LightKind::directional, lights[i].contains("toward_light"));
    if (lights[i].contains("position")) {
      EXPECT_EQ(light.position, vec(lights[i]["position"]));
    }
    if (lights[i].contains("toward_light")) {
      EXPECT_EQ(light.direction, vec(lights[i]["toward_light"]));
    }
  }
}

struct Pair {
  const char* ours;
  const char* theirs;
};

TEST(SceneBook, SphereScenesHaveTheProgramsNumbers) {
  for (const Pair pair :
       {Pair{"cgfs/spheres", "raytracer-01"}, Pair{"cgfs/lights", "raytracer-03"}, Pair{"cgfs/shadows", "raytracer-04"},
        Pair{"cgfs/reflections", "raytracer-05"}, Pair{"cgfs/camera", "raytracer-06"}}) {
    SCOPED_TRACE(pair.ours);
    const ps::Scene scene = ps::load_scene(pair.ours);
    const json& expected = reference()["scenes"][pair.theirs];
    EXPECT_EQ(scene.background, vec(expected.at("background")) / 255.0);
    expect_camera_and_lights(scene, expected);
    const json& spheres = expected.at("spheres");
    ASSERT_EQ(scene.geometry->objects.size(), spheres.size());
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      const auto& sphere = std::get<ps::Sphere>(scene.geometry->objects[i].shape);
      const ps::Material& material = scene.materials->at(sphere.material);
      EXPECT_EQ(sphere.centre, vec(spheres[i].at("center")));
      EXPECT_EQ(sphere.radius, spheres[i].at("radius").get<double>());
      EXPECT_EQ(material.colour, vec(spheres[i].at("color")) / 255.0);
      EXPECT_EQ(material.specular.value_or(-1), spheres[i].value("specular", -1.0));
      EXPECT_EQ(material.reflective, spheres[i].value("reflective", 0.0));
    }
  }
}

void expect_cube(const ps::Scene& scene, const ps::Mesh& mesh, const json& triangles, bool with_normals) {
  const json& vertices = reference()["cube"]["vertices"];
  ASSERT_EQ(mesh.positions.size(), vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) EXPECT_EQ(mesh.positions[i], vec(vertices[i]));
  ASSERT_EQ(mesh.triangles.size(), triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const ps::MeshTriangle& triangle = mesh.triangles[i];
    const ps::Material& material = scene.materials->at(mesh.materials.at(triangle.material));
    if (material.texture < 0) {
      EXPECT_EQ(material.colour, vec(triangles[i].at("color")) / 255.0);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(triangle.position[k], triangles[i]["vertices"][k].get<std::uint32_t>());
      EXPECT_EQ(triangle.normal[k] >= 0, with_normals);
      if (with_normals) {
        EXPECT_EQ(mesh.normals.at(static_cast<std::size_t>(triangle.normal[k])), vec(triangles[i].at("face_normal")));
      }
      if (material.texture < 0) continue;
      const ps::Vec2d uv = mesh.uvs.at(static_cast<std::size_t>(triangle.uv[k]));
      EXPECT_EQ(uv, ps::Vec2d(triangles[i]["uv"][k][0], triangles[i]["uv"][k][1]));
    }
  }
}

TEST(SceneBook, CubeScenesHaveTheProgramsNumbers) {
  struct Row {
    const char* ours;
    const char* theirs;
    const char* triangles;
    bool normals;
  };
  for (const Row row : {Row{"cgfs/wireframe", "raster-07", "triangles_raster_06_to_09", false},
                        Row{"cgfs/cubes", "raster-10", "triangles_raster_10", false},
                        Row{"cgfs/shading", "raster-11", "triangles_raster_11_to_13", true},
                        Row{"cgfs/crates", "raster-12", "triangles_raster_11_to_13", true}}) {
    SCOPED_TRACE(row.ours);
    const ps::Scene scene = ps::load_scene(row.ours);
    const json& expected = reference()["scenes"][row.theirs];
    expect_camera_and_lights(scene, expected);
    expect_cube(scene, *scene.geometry->meshes.at(0), reference()["cube"][row.triangles], row.normals);
    const json& instances = expected.at("instances");
    ASSERT_EQ(scene.geometry->objects.size(), instances.size());
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const auto& instance = std::get<ps::Instance>(scene.geometry->objects[i].shape);
      EXPECT_EQ(instance.mesh, instances[i].at("model") == "cube" ? 0U : 1U);
      EXPECT_EQ(instance.transform.translation, vec(instances[i].at("position")));
      EXPECT_EQ(instance.transform.scale, ps::Vec3d(instances[i].value("scale", 1.0)));
      EXPECT_EQ(instance.transform.rotation, rotation_of(instances[i]));
    }
    for (const ps::Material& material : *scene.materials)
      EXPECT_EQ(material.specular.value_or(-1), expected.value("specular", -1.0));
  }
}

double from_hex(const std::string& hex) {
  const auto bits = static_cast<std::uint64_t>(std::stoull(hex, nullptr, 16));
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

TEST(SceneBook, TheBallIsTheProgramsBall) {
  const ps::Scene scene = ps::load_scene("cgfs/shading");
  const ps::Mesh& ball = *scene.geometry->meshes.at(1);
  ASSERT_EQ(ball.positions.size(), 240U);
  ASSERT_EQ(ball.triangles.size(), 450U);
  const json& turns = reference()["sphere15"]["cos_sin_hex_ieee754_be_from_v8"];
  for (std::size_t ring = 0; ring <= 15; ++ring) {
    const double y = 2.0 / 15 * (static_cast<double>(ring) - 7.5);
    const double radius = std::sqrt(1 - y * y);
    for (std::size_t i = 0; i < 15; ++i) {
      const ps::Vec3d& position = ball.positions[ring * 15 + i];
      const json& turn = turns[i];
      EXPECT_NEAR(position.x, radius * from_hex(turn["cos"]), 1e-14);
      EXPECT_DOUBLE_EQ(position.y, y);
      EXPECT_NEAR(position.z, radius * from_hex(turn["sin"]), 1e-14);
    }
  }
  // Ring 3, quad 14: the one that closes the ring.
  const auto& closing = ball.triangles[2 * (3 * 15 + 14)];
  EXPECT_EQ(closing.position, (std::array<std::uint32_t, 3>{59, 60, 45}));
  EXPECT_EQ(closing.normal, (std::array<std::int32_t, 3>{59, 60, 45}));
}

TEST(SceneBook, RotationsAreTheProgramsRotations) {
  for (const json& row : reference()["oy_rotation_cos_sin_hex_from_v8"]) {
    const ps::Mat3d rotation = ps::rotation_about(ps::Axis::y, row["degrees"].get<double>());
    const double c = from_hex(row["cos"]), s = from_hex(row["sin"]);
    EXPECT_EQ(ps::row_of(rotation, 1), ps::Vec3d(0, 1, 0));
    const ps::Vec3d first = ps::row_of(rotation, 0), third = ps::row_of(rotation, 2);
    for (const double difference : {first.x - c, first.z + s, third.x - s, third.z - c})
      EXPECT_NEAR(difference, 0, 2e-16);
  }
  // Exchanging the axes in a circle turns each rotation into the next.
  const ps::Mat3d circle = ps::from_rows({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
  const ps::Mat3d back = glm::transpose(circle);
  EXPECT_EQ(circle * ps::rotation_about(ps::Axis::x, 25) * back, ps::rotation_about(ps::Axis::y, 25));
  EXPECT_EQ(circle * ps::rotation_about(ps::Axis::y, 25) * back, ps::rotation_about(ps::Axis::z, 25));
}

TEST(SceneBook, ModelsInAllPrintedForms) {
  const std::string listed = "model { name = a  vertices { 0 = ( 1,  1,  1)\n1 = (-1,  1,  1)\n2 = (-1, -1,  1) }\n"
                             "triangles {\n 0 = 0, 1, 2, red\n 1 = 2, 1, 0, purple } }\n";
  const std::string bare = "model { name = b  vertices { (1, 1, 1) (-1, 1, 1) (-1, -1, 1) }\n"
                           "triangles { (0, 1, 2, red) (2, 1, 0, (255, 0, 255)) } }\n";
  const std::string named = "model { name = c  vertices { A = (1, 1, 1)  B = (-1, 1, 1)  C = (-1, -1, 1) }\n"
                            "triangles { A, B, C, red\n C, B, A, purple } }\n";
  const std::string blocks = "model { name = d  vertices = [(1, 1, 1), (-1, 1, 1), (-1, -1, 1)]\n"
                             "triangles { 0 = { vertices = [0, 1, 2] color = red }\n"
                             "1 = { vertices = [2, 1, 0] color = purple } } }\n";
  const ps::Scene scene = ps::parse_scene(listed + bare + named + blocks, "forms.scene", ".");
  ASSERT_EQ(scene.geometry->meshes.size(), 4U);
  for (const auto& mesh : scene.geometry->meshes) {
    EXPECT_EQ(mesh->positions, scene.geometry->meshes[0]->positions);
    EXPECT_EQ(mesh->triangles, scene.geometry->meshes[0]->triangles);
    EXPECT_EQ(scene.materials->at(mesh->materials.at(0)).colour, ps::Vec3d(1, 0, 0));
    EXPECT_EQ(scene.materials->at(mesh->materials.at(1)).colour, ps::Vec3d(1, 0, 1));
  }
}

TEST(SceneBook, NormalsAsPrintedInChapter13) {
  const ps::Scene scene = ps::parse_scene(
      "model {\n name = cube\n vertices {\n 0 = (-1, -1, -1)\n 1 = (-1, -1,  1)\n 2 = (-1,  1,  1)\n }\n"
      "triangles {\n 0 = {\n vertices = [0, 1, 2]\n normals = [(-1, 0, 0), (-1, 0, 0), (-1, 0, 0)]\n }\n }\n}",
      "normals.scene", ".");
  const ps::Mesh& mesh = *scene.geometry->meshes.at(0);
  EXPECT_EQ(mesh.normals, std::vector<ps::Vec3d>{ps::Vec3d(-1, 0, 0)});
  EXPECT_EQ(mesh.triangles.at(0).normal, (std::array<std::int32_t, 3>{0, 0, 0}));
}

TEST(SceneBook, OneLineExampleAndInstanceTransform) {
  const ps::Scene scene =
      ps::parse_scene("viewport_size = 1 x 1 projection_plane_d = 1\n"
                      "sphere { center = (0, -1, 3) radius = 1 color = (255, 0, 0) # Red\n} light { type = point "
                      "intensity = 0.6 position "
                      "= (2, 1, 0) }\n"
                      "model { name = cube vertices { (0,0,0) (1,0,0) (0,1,0) } triangles { 0, 1, 2, cyan } }\n"
                      "instance { model = cube transform { scale = 1.5 rotation = <45 degrees around the Y axis> "
                      "translation = (1, 2, 3) "
                      "} }",
                      "line.scene", ".");
  const double h = std::sqrt(0.5);
  const auto& transform = std::get<ps::Instance>(scene.geometry->objects.at(1).shape).transform;
  EXPECT_EQ(transform.scale, ps::Vec3d(1.5));
  EXPECT_EQ(transform.translation, ps::Vec3d(1, 2, 3));
  EXPECT_NEAR(ps::row_of(transform.rotation, 0).z, -h, 1e-15);
  EXPECT_NEAR(ps::row_of(transform.rotation, 2).x, h, 1e-15);
}

TEST(SceneBook, LookAtKeepsTheHand) {
  const auto camera = [](const std::string& hand) {
    return ps::parse_scene("camera { position = (0, 0, 5) look_at = (0, 0, 0) up = (0, 2, 0.5) handedness = " + hand +
                               " }",
                           "eye.scene", ".")
        .camera;
  };
  EXPECT_EQ(camera("right").right, ps::Vec3d(1, 0, 0));
  EXPECT_EQ(camera("left").right, ps::Vec3d(-1, 0, 0));
  for (const char* hand : {"left", "right"}) {
    EXPECT_EQ(camera(hand).up, ps::Vec3d(0, 1, 0));
    EXPECT_EQ(camera(hand).forward, ps::Vec3d(0, 0, -1));
  }
}

}  // namespace
}  // namespace scene_book_test
