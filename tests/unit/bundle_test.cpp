// A bundle: the screen with the files of its scene in one archive, for other machines.
#include "document/bundle.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/archived_file.h"
#include "base/atomic_file.h"
#include "base/tar.h"
#include "document/permalink.h"
#include "document/permalink_file.h"
#include "document/scene_edits.h"
#include "frame/display_frame.h"
#include "image/file.h"
#include "render/render.h"
#include "scene/load.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace ps::bundle_test {
namespace {
namespace fs = std::filesystem;
using test::ScratchFolder;

std::vector<TarEntry> entries_of(const std::string& file) { return read_tar(read_whole_file(file), file); }

Document opened(const std::string& link) {
  Document document = parse_permalink(link);
  attach_scene(document, load_scene(document.scene_name));
  return document;
}

Image<Rgb8> picture(const Document& document) {
  return display_frame(render(document.scene, {document.scene.camera, 40, 40}, document.a.settings),
                       document.a.settings);
}

void save_texture(const fs::path& file, Rgb8 colour) {
  Image<Rgb8> texture(2, 2, Rgb8{200, 100, 50});
  texture.at(1, 0) = colour;
  save_image(file, texture);
}

/// A triangle with a texture two folders away, in letters of another case than its material file has, and exposed twice
/// as long.
Document own_model(const ScratchFolder& folder) {
  fs::create_directories(folder.path() / "pictures");
  fs::create_directories(folder.path() / "models");
  save_texture(folder.path() / "pictures" / "Wood.png", {10, 220, 90});
  folder.write("models/wood.mtl", "newmtl wood\nmap_Kd ../pictures/wood.png\n");
  const std::string model = folder.write(
      "models/a model.obj", "mtllib wood.mtl\nusemtl wood\nv -1 -1 -3\nv 1 -1 -3\nv 0 1 -3\nvt 0 0\nvt 1 0\n"
                            "vt 0 1\nf 1/1 2/2 3/3\n");
  Document document = open_document(model, load_scene(model));
  document.a.settings.exposure = 2;
  document.pixel = {12, 13};
  return document;
}

void expect_same(const Document& after, const Document& before, const Image<Rgb8>& shown) {
  EXPECT_TRUE(after.scene.warnings.empty()) << after.scene.warnings.front();
  EXPECT_TRUE(picture(after) == shown);
  EXPECT_EQ(after.pixel, before.pixel);
  EXPECT_EQ(after.a.settings, before.a.settings);
}

TEST(Bundle, ShowsTheSameWhereTheFilesAreGone) {
  const ScratchFolder here, there;
  const Document before = own_model(here);
  const Image<Rgb8> shown = picture(before);
  save_bundle(there.path() / "mine.tar", before);
  fs::remove_all(here.path() / "models");
  fs::remove_all(here.path() / "pictures");
  const std::string link = permalink_in_file(there.path() / "mine.tar").value_or("");
  const Document after = opened(link);
  expect_same(after, before, shown);
  EXPECT_EQ(there.names(), std::vector<std::string>{"mine.tar"}) << "it is not unpacked";
  // The open scene has a permalink, and can be bundled again.
  EXPECT_EQ(after.scene_name, there.file("mine.tar/files/models/a model.obj"));
  expect_same(opened(permalink(after)), before, shown);
  save_bundle(there.path() / "again.tar", after);
  fs::remove(there.path() / "mine.tar");
  expect_same(opened(permalink_in_file(there.path() / "again.tar").value_or("")), before, shown);
}

/// Scenes that include others, a texture of an edit, and a scene of the same name elsewhere.
TEST(Bundle, HoldsWhatIsIncludedAndEdited) {
  const ScratchFolder here, there;
  fs::create_directories(here.path() / "deep");
  save_texture(here.path() / "edit.png", {1, 2, 250});
  here.write("common.scene", "light { type = ambient intensity = 1 }\ninclude = deep/more.scene\n");
  here.write("deep/more.scene", "sphere { center = (0, 0, 3) radius = 1 color = (255, 255, 255) }\n");
  const std::string scene = here.write("deep/own.scene", "include = ../common.scene\n");
  Document before = open_document(scene, load_scene(scene));
  edit_scene(before, {"object.0.texture", "\"" + here.file("edit.png") + "\""});
  const Image<Rgb8> shown = picture(before);
  save_bundle(there.path() / "b.tar", before);
  EXPECT_EQ(entries_of(there.file("b.tar")).size(), 5u);
  for (const auto& entry : fs::directory_iterator(here.path())) fs::remove_all(entry.path());
  expect_same(opened(permalink_in_file(there.path() / "b.tar").value_or("")), before, shown);
}

/// The archive is one for the tool that everybody has, in all formats that it writes.
TEST(Bundle, IsAnArchiveForTar) {
  const ScratchFolder folder;
  const auto run = [&](const std::string& command) {
    ASSERT_EQ(std::system(("cd '" + folder.path().string() + "' && " + command).c_str()), 0) << command;
  };
  Document document = own_model(folder);
  const std::string deep = std::string(60, 'a') + "/" + std::string(60, 'b');
  fs::create_directories(folder.path() / "models" / deep);
  folder.write("models/own.scene", "include = " + deep + "/long.scene\n");
  folder.write("models/" + deep + "/long.scene", "light { type = ambient intensity = 1 }\n");
  document = open_document(folder.file("models/own.scene"), load_scene(folder.file("models/own.scene")));
  save_bundle(folder.path() / "b.tar", document);
  run("mkdir out && tar -xf b.tar -C out && tar -tf b.tar | grep -qx 'files/own.scene'");
  const auto entries = entries_of(folder.file("b.tar"));
  EXPECT_EQ(entries.size(), 3u);
  for (const TarEntry& entry : entries)
    EXPECT_EQ(read_whole_file(folder.path() / "out" / entry.name), entry.bytes) << entry.name;
  for (const std::string format : {"gnu", "pax", "ustar"}) {
    run("tar --format=" + format + " -cf " + format + ".tar -C out .");
    const Document again = opened(permalink_in_file(folder.path() / (format + ".tar")).value_or(""));
    EXPECT_EQ(again.scene.lights->size(), 1u) << format;
  }
  // A folder that was never a bundle opens, too, if it has one scene.
  run("mkdir plain && cp models/wood.mtl plain && cp 'models/a model.obj' plain && tar -cf plain.tar plain");
  EXPECT_EQ(permalink_in_file(folder.path() / "plain.tar"),
            "scene=" + percent_escape(folder.file("plain.tar/plain/a model.obj")));
}

TEST(Bundle, OfABuiltInSceneIsThePermalinkAlone) {
  const ScratchFolder folder;
  const Document document = open_document("cgfs/spheres", load_scene("cgfs/spheres"));
  save_bundle(folder.path() / "b.tar", document);
  EXPECT_EQ(entries_of(folder.file("b.tar")).size(), 1u);
  EXPECT_EQ(permalink_in_file(folder.path() / "b.tar"), permalink(document));
}

TEST(Bundle, OpensOnTheCommandLine) {
  const ScratchFolder here;
  save_bundle(here.path() / "b.tar", own_model(here));
  const std::string whole = here.file("files.png"), bundled = here.file("bundle.png"), linked = here.file("link.png");
  test::run_cli_well(
      {"render", here.file("models/a model.obj"), "--set", "exposure=2", "--size", "40x40", "--out", whole});
  fs::remove_all(here.path() / "models");
  test::run_cli_well({"render", here.file("b.tar"), "--size", "40x40", "--out", bundled});
  test::run_cli_well({"render", "--permalink", here.file("b.tar"), "--size", "40x40", "--out", linked});
  EXPECT_TRUE(load_levels(whole) == load_levels(bundled));
  EXPECT_TRUE(load_levels(whole) == load_levels(linked));
  here.write("bad.tar", "no archive");
  const auto result = test::run_cli({"render", here.file("bad.tar"), "--out", here.file("x.png")});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("bad.tar: this is not a tar archive"), std::string::npos) << result.err;
}

TEST(Bundle, ChangesAreSeenInAnArchiveThatIsWrittenAgain) {
  const ScratchFolder folder;
  const std::vector<TarEntry> first{{"a.scene", "background = red\n"}},
      second{{"a.scene", "background = (0, 255, 0)\n"}};
  write_file_atomically(folder.path() / "b.tar", tar_bytes(first));
  EXPECT_EQ(read_whole_file(folder.path() / "b.tar" / "a.scene"), first[0].bytes);
  write_file_atomically(folder.path() / "b.tar", tar_bytes(second));
  fs::last_write_time(folder.path() / "b.tar", fs::file_time_type::clock::now() + std::chrono::seconds(2));
  EXPECT_EQ(read_whole_file(folder.path() / "b.tar" / "a.scene"), second[0].bytes);
}

TEST(Bundle, OthersAreRefused) {
  const ScratchFolder folder;
  const auto refusal = [&](const std::string& bytes) {
    const std::string file = folder.write("bad.tar", bytes);
    const std::string text = test::refusal_of([&] { permalink_in_file(file); });
    EXPECT_TRUE(text.starts_with(file + ": ")) << text;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"bad.tar"});
    return text.substr(std::min(text.size(), file.size() + 2));
  };
  const std::vector<TarEntry> good{{"screen.permalink", "scene=files/a.scene\n"},
                                   {"files/a.scene", "background = red\n"}};
  const std::string bytes = tar_bytes(good);
  EXPECT_EQ(refusal(""), "this is not a tar archive");
  EXPECT_EQ(refusal("no archive"), "this is not a tar archive");
  EXPECT_EQ(refusal(std::string(2000, 'x')), "this is not a tar archive");
  EXPECT_EQ(refusal(std::string(2048, '\0')), "the archive holds no file");
  for (const std::size_t length : {512u, 520u, 1000u, 1024u, 1030u, 1600u, 2048u})
    EXPECT_EQ(refusal(bytes.substr(0, length)), "the archive is cut off") << length;
  std::string damaged = bytes;
  damaged[1024 + 3] = '?';
  EXPECT_EQ(refusal(damaged), "the archive is damaged");
  for (const std::string name : {"files/../../b", "..", "/tmp/b"}) {
    const std::vector<TarEntry> outside{good[0], {name, "x"}};
    EXPECT_EQ(refusal(tar_bytes(outside)), "'" + name + "' leads out of the archive");
  }
  const std::vector<TarEntry> other{{"a", "x"}};
  EXPECT_EQ(refusal(tar_bytes(other)),
            "found an archive of 1 files, expected one with 'screen.permalink', or with one scene or model");
  // A size beyond the file, with the right sum of the header.
  std::string large = bytes;
  large.replace(124, 11, "77777777777");
  large.replace(148, 8, "        ");
  unsigned sum = 0;
  for (std::size_t i = 0; i < 512; ++i) sum += static_cast<unsigned char>(large[i]);
  std::array<char, 8> digits{};
  std::snprintf(digits.data(), digits.size(), "%06o", sum);
  large.replace(148, 7, std::string(digits.data(), 7));
  EXPECT_EQ(refusal(large), "the archive is cut off");
  folder.write("bad.tar", "");
  fs::resize_file(folder.path() / "bad.tar", largest_archive + 1);
  EXPECT_EQ(test::refusal_of([&] { permalink_in_file(folder.path() / "bad.tar"); }),
            folder.file("bad.tar") + ": has 100000001 bytes, expected at most 100000000");
}

TEST(Bundle, LinksInAnArchiveAreRefused) {
  const ScratchFolder folder;
  const std::string make = "cd '" + folder.path().string() + "' && ln -s /etc/passwd a.scene && tar -cf l.tar a.scene";
  ASSERT_EQ(std::system(make.c_str()), 0);
  EXPECT_EQ(test::refusal_of([&] { permalink_in_file(folder.path() / "l.tar"); }),
            folder.file("l.tar") + ": 'a.scene' is a link or a device, expected files alone");
}

}  // namespace
}  // namespace ps::bundle_test
