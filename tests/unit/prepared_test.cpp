#include "frame/prepared.h"

#include <memory>

#include <gtest/gtest.h>

#include "options/scene_settings.h"
#include "render/render.h"
#include "scene/load.h"
#include "scene/part.h"

namespace ps::prepared_test {
namespace {

Key key_of(std::uint64_t revision, Precision precision) { return Key("product").add(revision).add(precision); }

TEST(Prepared, BuildsOncePerKey) {
  Prepared prepared;
  int builds = 0;
  const auto build = [&] { return ++builds; };
  EXPECT_EQ(*prepared.get<int>(key_of(1, Precision::float32), build), 1);
  EXPECT_EQ(*prepared.get<int>(key_of(1, Precision::float32), build), 1);
  EXPECT_EQ(*prepared.get<int>(key_of(2, Precision::float32), build), 2);
  EXPECT_EQ(*prepared.get<int>(key_of(1, Precision::float64), build), 3);
  EXPECT_EQ(*prepared.get<int>(key_of(1, Precision::float32), build), 1);
  EXPECT_EQ(builds, 3);
}

TEST(Prepared, ForgetsOldVersionsOfAProductButNotOtherProducts) {
  Prepared prepared;
  int builds = 0;
  const auto build = [&] { return ++builds; };
  const auto other = prepared.get<int>(Key("other"), [] { return 7; });
  const std::weak_ptr<const int> first = prepared.get<int>(key_of(100, Precision::float32), build);
  for (std::uint64_t revision = 0; revision < 50; ++revision)
    prepared.get<int>(key_of(revision, Precision::float32), build);
  EXPECT_TRUE(first.expired());
  EXPECT_EQ(prepared.get<int>(Key("other"), [] { return 8; }), other);
}

TEST(Prepared, KeysDistinguishRealsAndOrder) {
  EXPECT_EQ(Key("a").add(0.5), Key("a").add(0.5));
  EXPECT_NE(Key("a").add(0.5), Key("a").add(0.25));
  EXPECT_NE(Key("a").add(0.0), Key("a").add(-0.0));
  EXPECT_NE(Key("a").add(std::uint64_t{1}).add(std::uint64_t{2}), Key("a").add(std::uint64_t{2}).add(std::uint64_t{1}));
  EXPECT_NE(Key("a"), Key("b"));
}

TEST(Prepared, CountsTheBytesOfWhatItKeeps) {
  Prepared prepared;
  EXPECT_EQ(prepared.bytes(), 0u);
  prepared.get<std::vector<double>>(Key("plain"), [] { return std::vector<double>(1000); });
  EXPECT_EQ(prepared.bytes(), sizeof(std::vector<double>) + 8000);
  prepared.get<std::vector<std::vector<float>>>(
      Key("nested"), [] { return std::vector<std::vector<float>>(3, std::vector<float>(100)); });
  EXPECT_EQ(prepared.bytes(), 5 * sizeof(std::vector<double>) + 8000 + 1200);
  prepared.clear();
  EXPECT_EQ(prepared.bytes(), 0u);
}

TEST(Prepared, ARenderedSceneOccupiesAtLeastItsTrianglesAndItsTree) {
  Prepared prepared;
  Progress progress;
  const Scene scene = load_scene("cgpp/teapot");
  render(scene, {scene.camera, 40, 30}, settings_for(scene), {}, prepared, progress);
  std::size_t triangles = 0;
  for (const auto& mesh : scene.geometry->meshes) triangles += mesh->triangles.size();
  const std::size_t corners = triangles * 9 * sizeof(float);
  EXPECT_GT(triangles, 1000u);
  EXPECT_GT(prepared.bytes(), 2 * corners);  // the traced geometry and the wide tree each hold the corners
  EXPECT_LT(prepared.bytes(), 30 * corners);
}

TEST(Part, SharesUntilEdited) {
  Part<int> original(5);
  Part<int> copy = original;
  EXPECT_EQ(copy.revision(), original.revision());
  EXPECT_EQ(&*copy, &*original);
  copy.edit([](int& value) { value = 6; });
  EXPECT_EQ(*original, 5);
  EXPECT_EQ(*copy, 6);
  EXPECT_NE(copy.revision(), original.revision());
  EXPECT_NE(copy.revision(), 0u);
}

}  // namespace
}  // namespace ps::prepared_test
