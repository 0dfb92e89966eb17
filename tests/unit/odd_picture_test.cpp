// Picture files that other programs read although something is odd about them: read, with a note.
#include <gtest/gtest.h>

#include "base/atomic_file.h"
#include "image/codec.h"
#include "image/file.h"
#include "image/png_chunks.h"
#include "image/pnm.h"
#include "scene/load.h"
#include "support/png_parts.h"
#include "support/run_cli.h"

namespace ps::odd_picture_test {
namespace {

using test::run_cli_well;
using test::ScratchFolder;

std::string whole_jpeg() { return read_whole_file("tests/unit/data/flat.jpg"); }

std::string small_png() {
  Image<Rgb8> image(3, 2, {1, 2, 3});
  image.at(2, 1) = {200, 100, 50};
  return stb_encode_png(image);
}

/// An EXIF block with nothing but an orientation, in either byte order.
std::string exif(char order, char orientation) {
  if (order == 'I')
    return std::string("II\x2a\0\x08\0\0\0\1\0\x12\1\3\0\1\0\0\0", 18) + orientation + std::string(7, '\0');
  return std::string("MM\0\x2a\0\0\0\x08\0\1\1\x12\0\3\0\0\0\1\0", 19) + orientation + std::string(6, '\0');
}

/// The notes, or the error that the file gives.
std::string said_of(const std::string& bytes, const std::string& name) {
  try {
    std::string all;
    for (const std::string& note : decode_picture(bytes, name).notes) all += note + ";";
    return all;
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Cut anywhere, a file is refused or gives the whole picture and a note; at `least` bytes and more it is read.
void expect_whole_or_refused(const std::string& bytes, const std::string& name, std::size_t least) {
  const Image<Vec3f> whole = decode_picture(bytes, name).colour;
  for (std::size_t length = 1; length < bytes.size(); ++length) {
    std::optional<StoredPicture> read;
    try {
      read = decode_picture(bytes.substr(0, length), name);
    } catch (const InputError&) {
    }
    if (length >= least) {
      ASSERT_TRUE(read) << length << " of " << bytes.size() << " bytes";
    }
    if (!read) continue;
    EXPECT_EQ(read->colour, whole) << length << " of " << bytes.size() << " bytes";
    EXPECT_EQ(read->notes.size(), 1U);
  }
}

TEST(OddPictures, APngWithoutItsLastChunkIsRead) {
  const std::string png = small_png();
  constexpr std::size_t last_chunk = 12;
  expect_whole_or_refused(png, "a.png", png.size() - last_chunk);
  EXPECT_EQ(said_of(png.substr(0, png.size() - 5), "a.png"), "ends without an IEND chunk, but has all of its pixels;");
  // Pixels in two chunks, of which the second is missing; and a text behind the pixels that is cut off.
  const std::string head = png.substr(0, 33), pixels = png.substr(41, png.size() - 41 - 4 - last_chunk);
  const std::string first = test::png_chunk("IDAT", pixels.substr(0, pixels.size() - 9)),
                    second = test::png_chunk("IDAT", pixels.substr(pixels.size() - 9));
  EXPECT_EQ(said_of(head + first + second + png.substr(png.size() - last_chunk), "a.png"), "");
  EXPECT_NE(said_of(head + first, "a.png").find("cut off"), std::string::npos) << said_of(head + first, "a.png");
  const std::string text = test::png_chunk("tEXt", "Comment of the author");
  EXPECT_NE(said_of(head + first + second + text.substr(0, 15), "a.png").find("ends without"), std::string::npos);
}

TEST(OddPictures, AJpegWithoutItsEndIsReadIfAllPixelsAreThere) {
  const std::string jpeg = whole_jpeg();
  expect_whole_or_refused(jpeg, "a.jpg", jpeg.size() - 2);
  EXPECT_EQ(said_of(jpeg.substr(0, jpeg.size() - 2), "a.jpg"),
            "ends without an end marker, but has all of its pixels;");
  const std::string progressive = read_whole_file("tests/corpus/jpeg/progressive.jpg");
  EXPECT_NE(said_of(progressive.substr(0, progressive.size() - 2), "a.jpg").find("cut off"), std::string::npos)
      << "further scans may be missing";
}

TEST(OddPictures, TheContentDecidesTheFormat) {
  const Image<Rgb8> image(2, 1, {10, 20, 30});
  const std::string tga("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x18\0abcdef", 24);
  struct Content {
    const char *extension, *format;
    std::string bytes;
  };
  const Content contents[] = {{".png", "PNG", stb_encode_png(image)},
                              {".jpg", "JPEG", whole_jpeg()},
                              {".tga", "TGA", tga},
                              {".ppm", "PNM", ppm_bytes(image, {})},
                              {".pfm", "PFM", pfm_bytes(Image<float>(2, 1, 5.0f))}};
  for (const Content& content : contents)
    for (const char* extension : {".png", ".jpg", ".tga", ".ppm", ".pfm", ".bmp", ".jfif", ""}) {
      const std::string name = std::string("a") + extension;
      const std::string expected = extension == std::string(content.extension)
                                       ? ""
                                       : "is read as " + std::string(content.format) + ", as its content says;";
      EXPECT_EQ(said_of(content.bytes, name), expected) << content.extension << " as " << name;
      const Image<Vec3f> right = decode_picture(content.bytes, std::string("a") + content.extension).colour;
      EXPECT_EQ(decode_picture(content.bytes, name).colour, right);
    }
  EXPECT_NE(said_of("GIF89a and more than a header", "a.gif").find("found the extension \".gif\""), std::string::npos);
  EXPECT_NE(said_of("GIF89a and more than a header", "a.png").find("no PNG signature"), std::string::npos);
}

TEST(OddPictures, OrientationAndScaleAreSaidAndNotApplied) {
  const std::string jpeg = whole_jpeg();
  const Image<Vec3f> right = decode_picture(jpeg, "a.jpg").colour;
  for (const char order : {'I', 'M'})
    for (char orientation = 0; orientation < 10; ++orientation) {
      const std::string block = exif(order, orientation);
      const std::string data = std::string("Exif\0\0", 6) + block;
      const std::string segment = std::string("\xff\xe1\0", 3) + static_cast<char>(data.size() + 2) + data;
      const bool turned = orientation >= 2 && orientation <= 8;
      const std::string note =
          turned ? "has the EXIF orientation " + std::to_string(orientation) + ", which is not applied;" : "";
      const std::string with_exif = std::string(jpeg).insert(2, segment);
      EXPECT_EQ(said_of(with_exif, "a.jpg"), note);
      EXPECT_EQ(decode_picture(with_exif, "a.jpg").colour, right);
      EXPECT_EQ(said_of(small_png().insert(33, test::png_chunk("eXIf", block)), "a.png"), note);
      for (std::size_t cut = 0; cut < block.size(); ++cut)
        EXPECT_NO_THROW(decode_picture(small_png().insert(33, test::png_chunk("eXIf", block.substr(0, cut))), "a.png"));
    }
  const std::string sample("\0\0\x80\x3f", 4);  // 1
  EXPECT_EQ(said_of("Pf 1 1 -1\n" + sample, "a.pfm"), "");
  EXPECT_EQ(said_of("Pf 1 1 -5\n" + sample, "a.pfm"), "has the PFM scale 5, which is not applied;");
  EXPECT_EQ(decode_picture("Pf 1 1 -5\n" + sample, "a.pfm").colour.at(0, 0), Vec3f(1));
}

TEST(OddPictures, NotesReachScenesModelsAndTheCommandLine) {
  const ScratchFolder folder;
  folder.write("photo.png", whole_jpeg());
  const std::string scene = folder.write("a.scene", "texture { name = t  file = \"photo.png\" }\nsphere { center = (0, "
                                                    "0, 3)  radius = 1 }\nlight { type = ambient  intensity = 1 }\n");
  const std::string model =
      folder.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
  folder.write("a.mtl", "newmtl m\nmap_Kd photo.png\n");
  const auto expect_one = [](const std::vector<std::string>& warnings, const std::string& end) {
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_TRUE(warnings[0].ends_with(end)) << warnings[0];
  };
  expect_one(load_scene(scene).warnings, "photo.png' is read as JPEG, as its content says.");
  expect_one(load_scene(model).warnings, "a.mtl:2: the texture 'photo.png' is read as JPEG, as its content says.");
  const auto said = run_cli_well({"render", scene, "--size", "4x4", "--out", folder.file("out.ppm")});
  EXPECT_NE(said.err.find("a.scene:1: the picture '"), std::string::npos) << said.err;
  const auto edited = run_cli_well({"render", "cgfs/crates", "--size", "4x4", "--out", folder.file("out.ppm"), "--edit",
                                    "object.0.texture=\"" + folder.file("photo.png") + "\""});
  EXPECT_NE(edited.err.find("is read as JPEG"), std::string::npos) << edited.err;
}

}  // namespace
}  // namespace ps::odd_picture_test
