// Pictures of a few bytes that would take gigabytes once read, and pictures that a scene names and nobody can read.
#include <gtest/gtest.h>

#include "image/file.h"
#include "image/png_chunks.h"
#include "scene/load.h"
#include "scene/scene_file.h"
#include "support/refusal.h"
#include "support/run_cli.h"

namespace ps::picture_limit_test {
namespace {

std::string big_endian_word(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::string png_chunk(const std::string& kind, const std::string& data) {
  return big_endian_word(static_cast<std::uint32_t>(data.size())) + kind + data + big_endian_word(crc32(kind + data));
}

/// A PNG file whose header promises 2^28 pixels of one bit each; its data are never looked at.
std::string png_bomb() {
  return "\x89PNG\r\n\x1a\n" +
         png_chunk("IHDR", big_endian_word(16384) + big_endian_word(16384) + std::string("\1\0\0\0\0", 5)) +
         png_chunk("IDAT", "x") + png_chunk("IEND", "");
}

constexpr const char* refusal = "found a picture of 16384 x 16384 pixels, which takes 3072 MiB of memory, "
                                "expected at most 67108864 pixels";

TEST(PictureLimit, HoldsForEveryFormatBeforeItIsDecoded) {
  const test::ScratchFolder folder;
  EXPECT_EQ(test::refusal_of([&] { load_image(folder.write("a.png", png_bomb())); }),
            folder.file("a.png") + ": " + refusal);
  std::string tga(18, '\0');
  tga.replace(12, 6, std::string("\0\x40\0\x40\x18\0", 6));
  tga[2] = 10;
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"a.ppm", "P6 16384 16384 255\n"},
                                    {"a.pgm", "P2 16384 16384 255\n"},
                                    {"a.pfm", "PF\n16384 16384\n-1\n"},
                                    {"a.tga", tga + std::string((std::size_t{1} << 21) * 4, '\0')}}) {
    const std::string error =
        test::refusal_of([&, &name = name, &bytes = bytes] { load_image(folder.write(name, bytes)); });
    EXPECT_NE(error.find(refusal), std::string::npos) << error;
  }
}

TEST(PictureLimit, LetsThroughWhatFits) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("a.pgm", "P2 3 3 1\n0 0 0 0 1 0 0 0 0\n");
  EXPECT_EQ(load_image(file, {.most_pixels = 9}).at(1, 1), Vec3f(1));
  EXPECT_THROW(load_image(file, {.most_pixels = 8}), InputError);
}

TEST(PictureLimit, HoldsForCompare) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("a.png", png_bomb());
  const auto result = test::run_cli({"compare", file, file});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find(refusal), std::string::npos) << result.err;
}

TEST(PictureLimit, IsANoteInAModel) {
  const test::ScratchFolder folder;
  folder.write("a.png", png_bomb());
  folder.write("a.mtl", "newmtl a\nmap_Kd a.png\n");
  const Scene scene =
      load_scene(folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n"));
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_NE(scene.warnings[0].find("a.mtl:2: the texture 'a.png' cannot be read"), std::string::npos);
  EXPECT_NE(scene.warnings[0].find(refusal), std::string::npos) << scene.warnings[0];
}

TEST(ScenePictures, FaultsNameFileLineAndColumn) {
  const test::ScratchFolder folder;
  folder.write("bomb.png", png_bomb());
  folder.write("wood.bmp", "BM");
  for (const auto& [name, reason] : {std::pair<std::string, std::string>{"gone.png", "no such file"},
                                     {"wood.bmp", "found the extension \".bmp\""},
                                     {"bomb.png", refusal}}) {
    const std::string words = test::refusal_of([&, &name = name] {
      parse_scene("# a scene\ntexture { name = t  file = \"" + name + "\" }\n", "s.scene", folder.file(""));
    });
    EXPECT_TRUE(words.starts_with("s.scene:2:28: found ")) << words;
    EXPECT_NE(words.find(name + "' (" + reason), std::string::npos) << words;
    EXPECT_TRUE(words.ends_with(", expected one that can be read")) << words;
  }
}

}  // namespace
}  // namespace ps::picture_limit_test
