#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/check.h"
#include "obj_corpus.h"
#include "scene/load.h"
#include "scene/scene_file.h"

namespace scene_mutation_test {
namespace {

/// Cuts, doubles, exchanges and replaces pieces of a text at random places.
std::string mutated(std::string text, std::mt19937_64& random) {
  static const std::vector<std::string> pieces{"{",     "}",     "(",        ")",    "=",  ",",
                                               "<",     ">",     "\"",       "#",    "-1", "0",
                                               "1e400", "nan",   "99999999", "name", "\n", std::string(1, '\0'),
                                               "\xFF",  "linear"};
  const auto below = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  for (std::size_t change = 0; change <= below(4) && !text.empty(); ++change) {
    const std::size_t at = below(text.size());
    const std::size_t length = std::min(1 + below(12), text.size() - at);
    switch (below(5)) {
    case 0:
      text.resize(at);
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.replace(at, length, pieces[below(pieces.size())]);
      break;
    case 3:
      text.insert(below(text.size()), text.substr(at, length * 8));
      break;
    default:
      text[at] = static_cast<char>(below(256));
      break;
    }
  }
  return text;
}

// Whatever stands in a scene file: it is read or refused, never a crash and never another exception.
TEST(SceneMutation, ScenesAreReadOrRefused) {
  const std::uint64_t seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  int read = 0, refused = 0;
  for (const auto& listed : ps::builtin_scenes()) {
    const ps::Scene scene = ps::load_scene(listed.name);
    const std::filesystem::path path = scene.files.front();
    const std::string text = ps::read_text_file(path, ps::max_scene_file_bytes);
    for (int i = 0; i < 60; ++i) {
      const std::string wrong = mutated(text, random);
      try {
        ps::parse_scene(wrong, path.string(), path.parent_path());
        ++read;
      } catch (const ps::InputError& error) {
        ++refused;
        EXPECT_NE(std::string(error.what()), "");
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what() << "\n" << wrong;
      }
    }
  }
  EXPECT_GT(read, 0) << "mutations in comments do no harm";
  EXPECT_GT(refused, read) << "the mutations have teeth";
}

TEST(SceneMutation, ModelsAreReadOrRefused) {
  const std::uint64_t seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  const ps::test::ModelFolder folder;
  folder.write("m.mtl", "newmtl a b\nKd 1 0 0\nNs 20\n");
  const std::string text =
      "mtllib m.mtl\no x\nv 0 0 0\nv 1 0 0\nv 1 1 0 1 1 1\nv 0 1e0 0\nvt 0 1\nvn 0 0 1\nusemtl a b\n"
      "f 1/1/1 2/1/1 3/1/1 4/1/1\ng y\nf -1 -2 -3\nf 1//1 2//1 \\\n3//1\n";
  int read = 0, refused = 0;
  for (int i = 0; i < 400; ++i) {
    const std::string wrong = mutated(text, random);
    try {
      const ps::Scene scene = folder.load(wrong);
      ++read;
      const ps::Mesh& mesh = ps::test::mesh_of(scene);
      for (const auto& triangle : mesh.triangles) {
        for (const auto corner : triangle.position) EXPECT_LT(corner, mesh.positions.size()) << wrong;
        EXPECT_LT(mesh.materials.at(triangle.material), scene.materials->size());
      }
      for (const auto& p : mesh.positions) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z)) << wrong;
    } catch (const ps::InputError&) {
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\n" << wrong;
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, 0);
}

TEST(SceneMutation, IncludesInACircleAreRefused) {
  const ps::test::ModelFolder folder;
  folder.write("b.scene", "background = red\ninclude = \"a.scene\"\n");
  const std::string first = folder.write("a.scene", "# one\ninclude = b.scene\n");
  try {
    ps::load_scene(first);
    FAIL() << "was accepted";
  } catch (const ps::InputError& error) {
    EXPECT_EQ(error.place().file, (folder.path() / "b.scene").string());
    EXPECT_EQ(error.place().line, 2);
    EXPECT_EQ(error.expected(), "a file that does not include this one");
  }
}

TEST(SceneMutation, IncludedFilesAreListed) {
  const ps::test::ModelFolder folder;
  folder.write("parts/lamp.scene", "light { type = ambient intensity = 0.5 }\n");
  const std::string first = folder.write("room.scene", "include = parts/lamp.scene\n");
  const ps::Scene scene = ps::load_scene(first);
  EXPECT_EQ(scene.lights->size(), 1U);
  EXPECT_EQ(ps::files_of(scene), (std::vector<std::string>{first, (folder.path() / "parts/lamp.scene").string()}));
}

}  // namespace
}  // namespace scene_mutation_test
