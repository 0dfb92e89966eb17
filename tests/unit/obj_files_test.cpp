// The models of tests/corpus/obj, each with what it must give in expected.json: counts, single corners, materials and
// warnings, or the error with its place.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "scene/obj.h"
#include "support/refusal.h"

namespace obj_files_test {
namespace {

using nlohmann::json;
using ps::ObjModel;
using ps::Vec3d;

const std::string folder = "tests/corpus/obj/";

json expectations() {
  std::ifstream file(folder + "expected.json");
  return json::parse(file);
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  const json all = expectations();
  for (const auto& [name, ignored] : all.items()) result.push_back(name);
  return result;
}

void expect_near(const json& expected, const Vec3d& actual, const std::string& what) {
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(actual[static_cast<int>(i)], expected[i].get<double>(),
                1e-14 * std::max(1.0, std::abs(expected[i].get<double>())))
        << what;
}

/// Sum of (b - a) x (c - a) / 2 over all triangles: its length is the area of what is flat and not folded.
Vec3d area_vector(const ps::Mesh& mesh) {
  Vec3d sum(0);
  for (const auto& triangle : mesh.triangles) {
    const Vec3d& a = mesh.positions[triangle.position[0]];
    sum += cross(mesh.positions[triangle.position[1]] - a, mesh.positions[triangle.position[2]] - a) / 2.0;
  }
  return sum;
}

double area(const ps::Mesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vec3d& a = mesh.positions[triangle.position[0]];
    sum += glm::length(cross(mesh.positions[triangle.position[1]] - a, mesh.positions[triangle.position[2]] - a)) / 2;
  }
  return sum;
}

void check_mesh(const json& expected, const ps::Mesh& mesh) {
  EXPECT_EQ(mesh.triangles.size(), expected.at("triangles").get<std::size_t>());
  if (expected.contains("positions")) {
    EXPECT_EQ(mesh.positions.size(), expected["positions"].get<std::size_t>());
  }
  if (expected.contains("normals")) {
    EXPECT_EQ(mesh.normals.size(), expected["normals"].get<std::size_t>());
  }
  if (expected.contains("uvs")) {
    EXPECT_EQ(mesh.uvs.size(), expected["uvs"].get<std::size_t>());
  }
  const auto index = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  for (const json& c : expected.value("corners", json::array()))
    expect_near(c[2], mesh.positions.at(mesh.triangles.at(c[0]).position.at(c[1])), c.dump());
  for (const json& c : expected.value("corner_normals", json::array()))
    expect_near(c[2], mesh.normals.at(index(mesh.triangles.at(c[0]).normal.at(c[1]))), "normal " + c.dump());
  for (const json& c : expected.value("corner_uvs", json::array())) {
    const auto& uv = mesh.uvs.at(index(mesh.triangles.at(c[0]).uv.at(c[1])));
    EXPECT_DOUBLE_EQ(uv.x, c[2][0].get<double>()) << c;
    EXPECT_DOUBLE_EQ(uv.y, c[2][1].get<double>()) << c;
  }
  const std::array<std::int32_t, 3> none{-1, -1, -1};
  for (const json& t : expected.value("without_normals", json::array())) {
    EXPECT_EQ(mesh.triangles.at(t).normal, none) << "triangle " << t;
  }
  for (const json& t : expected.value("without_uvs", json::array())) {
    EXPECT_EQ(mesh.triangles.at(t).uv, none) << "triangle " << t;
  }
  // A polygon cut rightly has the polygon's area, without triangles that overlap or face the other way.
  if (expected.contains("area")) {
    EXPECT_NEAR(area(mesh), expected["area"].get<double>(), 1e-8);
    EXPECT_NEAR(glm::length(area_vector(mesh)), expected["area"].get<double>(), 1e-8);
  }
  if (expected.contains("facing")) {
    expect_near(expected["facing"], glm::normalize(area_vector(mesh)), "facing");
  }
}

void check_material(const json& expected, const ps::Material& material) {
  if (expected.contains("colour")) expect_near(expected["colour"], material.colour, "colour");
  if (expected.contains("specular")) {
    EXPECT_EQ(material.specular.has_value(), !expected["specular"].is_null());
    if (material.specular && !expected["specular"].is_null()) {
      EXPECT_DOUBLE_EQ(*material.specular, expected["specular"].get<double>());
    }
  }
  if (expected.contains("specular_colour")) expect_near(expected["specular_colour"], *material.specular_colour, "Ks");
  if (expected.contains("ambient_colour")) expect_near(expected["ambient_colour"], *material.ambient_colour, "Ka");
  if (expected.contains("transparency")) {
    EXPECT_DOUBLE_EQ(material.transparency, expected["transparency"].get<double>());
  }
  if (expected.contains("refraction_index")) {
    EXPECT_DOUBLE_EQ(material.refraction_index, expected["refraction_index"].get<double>());
  }
  if (expected.contains("reflective")) {
    EXPECT_DOUBLE_EQ(material.reflective, expected["reflective"].get<double>());
  }
  if (expected.contains("texture")) {
    EXPECT_EQ(material.texture, expected["texture"].get<int>());
  }
}

void check_model(const json& expected, const ObjModel& model) {
  check_mesh(expected, model.mesh);
  const auto material_of = [&](std::size_t triangle) -> const ps::Material& {
    return model.materials.at(model.mesh.materials.at(model.mesh.triangles.at(triangle).material));
  };
  for (const json& pair : expected.value("material_of", json::array()))
    EXPECT_EQ(material_of(pair[0]).name, pair[1].get<std::string>());
  const json materials = expected.value("materials", json::object());
  for (const auto& [name, values] : materials.items()) {
    SCOPED_TRACE(name);
    bool used = false;
    for (std::size_t i = 0; i < model.mesh.triangles.size() && !used; ++i) {
      used = material_of(i).name == name;
      if (used) check_material(values, material_of(i));
    }
    EXPECT_TRUE(used);
  }
  if (expected.contains("textures")) {
    EXPECT_EQ(model.textures.size(), expected["textures"].get<std::size_t>());
  }
  if (expected.contains("warnings")) {
    std::vector<std::string> warnings;
    for (const std::string& warning : model.warnings)
      warnings.push_back(warning.starts_with(folder) ? warning.substr(folder.size()) : warning);
    EXPECT_EQ(warnings, expected["warnings"].get<std::vector<std::string>>());
  }
}

class ObjFiles : public testing::TestWithParam<std::string> {};

TEST_P(ObjFiles, GiveWhatIsExpected) {
  const json expected = expectations().at(GetParam());
  if (!expected.contains("error")) return check_model(expected, ps::load_obj(folder + GetParam()));
  const json& error = expected["error"];
  const ps::SourcePlace place{folder + expected.value("file", GetParam()), error[0], error[1]};
  const ps::InputError refusal(place, error[2], error[3]);
  EXPECT_EQ(ps::test::refusal_of([&] { ps::load_obj(folder + GetParam()); }), refusal.what());
}

INSTANTIATE_TEST_SUITE_P(Corpus, ObjFiles, testing::ValuesIn(names()),
                         [](const auto& file) { return file.param.substr(0, file.param.find('.')); });

TEST(ObjFilesFolder, HoldsTheFilesOfTheTableAndNoOthers) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".obj") found.push_back(entry.path().filename().string());
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, names());
  EXPECT_GE(found.size(), 30U);
}

}  // namespace
}  // namespace obj_files_test
