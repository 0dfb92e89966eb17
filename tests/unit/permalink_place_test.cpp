// Permalinks in files are found from any folder, with the relative paths that they hold.
#include <gtest/gtest.h>

#include <filesystem>

#include "base/check.h"
#include "document/permalink.h"
#include "document/permalink_file.h"
#include "image/file.h"
#include "support/run_cli.h"

namespace ps::permalink_place_test {
namespace {

namespace fs = std::filesystem;
using test::ScratchFolder;

constexpr const char* small_scene =
    "sphere { center = (0, 0, 3)  radius = 1 }\nlight { type = ambient  intensity = 1 }\n";

std::string link_of(const fs::path& file) { return permalink_in_file(file).value_or("none"); }

void save_with(const fs::path& file, const std::string& link) {
  save_image(file, Image<Rgb8>(1, 1), {.texts = {{"permalink", link}}});
}

// The scene lies beside the picture, above it, or in a folder beside one of these; the tests run elsewhere.
TEST(PermalinkPlace, PathsAreFoundFromTheFolderOfTheFile) {
  const ScratchFolder folder;
  fs::create_directories(folder.path() / "models");
  fs::create_directories(folder.path() / "out" / "deep");
  folder.write("beside.scene", small_scene);
  folder.write("models/a.scene", small_scene);
  const std::string beside = percent_escape(folder.file("beside.scene")),
                    inside = percent_escape(folder.file("models/a.scene"));
  for (const char* place : {"p.png", "out/p.PNG", "out/deep/p.png"}) {
    const fs::path file = folder.path() / place;
    if (file.extension() == ".PNG") {
      save_with(folder.path() / "out/q.png", "scene=models/a.scene&pixel=1,2");
      fs::rename(folder.path() / "out/q.png", file);
    } else {
      save_with(file, "scene=models/a.scene&pixel=1,2");
    }
    EXPECT_EQ(link_of(file), "scene=" + inside + "&pixel=1,2") << place;
  }
  save_with(folder.path() / "out/p.png", "pixel=1,2&picture-b=beside.scene&edit.object.0.texture=%22beside.scene%22");
  EXPECT_EQ(link_of(folder.path() / "out/p.png"), "pixel=1,2&picture-b=" + beside + "&edit.object.0.texture=" +
                                                      percent_escape("\"" + folder.file("beside.scene") + "\""));
  folder.write("out/link.permalink", "scene=beside.scene\n");
  EXPECT_EQ(link_of(folder.path() / "out/link.permalink"), "scene=" + beside);
  // Names of built-in scenes, what is absolute, and what is nowhere stay as they are.
  for (const std::string link :
       {"scene=cgfs/spheres", "scene=nowhere.scene", "scene=/nowhere/a.scene", "a.gamma=2.2"}) {
    save_with(folder.path() / "p.png", link);
    EXPECT_EQ(link_of(folder.path() / "p.png"), link);
  }
}

// Where no folder above the file leads to the scene, its path becomes absolute.
TEST(PermalinkPlace, PathsThatWouldBeLostAreAbsolute) {
  const ScratchFolder folder, elsewhere;
  folder.write("a.scene", small_scene);
  Document document;
  document.scene_name = fs::relative(folder.file("a.scene")).string();
  // A name that begins with .. may by chance lead from there to the same file.
  const std::string link = permalink_for_file(elsewhere.path() / "p.png", document);
  const fs::path led = fs::path(percent_unescape(link.substr(link.find('=') + 1)));
  EXPECT_EQ((elsewhere.path() / led).lexically_normal(), folder.file("a.scene")) << link;
  document.scene_name = "cgfs/spheres";
  EXPECT_EQ(permalink_for_file(elsewhere.path() / "p.png", document), "scene=cgfs/spheres");
  document.scene_name = "tests/corpus/files/a.scene";  // the tests run in the project's folder
  EXPECT_EQ(permalink_for_file("build/p.png", document), "scene=tests/corpus/files/a.scene");
  EXPECT_EQ(permalink_for_file(elsewhere.path() / "p.png", document),
            "scene=" + percent_escape(fs::absolute("tests/corpus/files/a.scene").string()));
}

TEST(PermalinkPlace, APictureOpensFromAnotherFolder) {
  const ScratchFolder folder;
  folder.write("a.scene", small_scene);
  save_with(folder.path() / "p.png", "scene=a.scene&size=4x4");
  test::run_cli_well({"render", "--permalink", folder.file("p.png"), "--out", folder.file("again.ppm")});
}

}  // namespace
}  // namespace ps::permalink_place_test
