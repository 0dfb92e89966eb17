// OBJ and MTL files as exporters write them: what they mean is drawn, what is odd gives a note, and no oddity refuses
// a whole model.
#include <gtest/gtest.h>

#include "obj_corpus.h"

namespace ps::obj_exporters_test {
namespace {

constexpr const char* red_picture = "P3\n1 1\n255\n255 0 0\n";

/// A triangle that uses the material `a` of a.mtl.
class ObjExporters : public testing::Test {
 protected:
  Scene with_material(const std::string& mtl, const std::string& header = "mtllib a.mtl\n") {
    folder_.write("a.mtl", mtl);
    return folder_.load(header + "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
  }
  static const Material& material(const Scene& scene) { return material_of(scene, 0, 0); }

  test::ModelFolder folder_;
};

// ---- Pictures ------------------------------------------------------------------------------------------------------

TEST_F(ObjExporters, APictureThatCannotBeReadIsANote) {
  folder_.write("wood.bmp", "BM and so on");
  folder_.write("cut.png", "\x89PNG\r\n\x1a\nno more");
  folder_.write("empty.png", "");
  for (const std::string name : {"wood.bmp", "cut.png", "empty.png"}) {
    const Scene scene = with_material("newmtl a\nKd 0 1 0\nmap_Kd " + name + "\nmap_Bump " + name + "\n");
    EXPECT_EQ(test::notes_of(scene).find("a.mtl:3: the texture '" + name + "' cannot be read"), 0U)
        << test::notes_of(scene);
    EXPECT_EQ(scene.warnings.size(), 1U) << "once for each picture";
    EXPECT_EQ(material(scene).texture, -1);
    EXPECT_EQ(material(scene).normal_map, -1);
    EXPECT_EQ(material(scene).colour, Vec3d(0, 1, 0));
    EXPECT_EQ(files_of(scene).size(), 3U) << "watched, so that a repaired picture is read";
  }
}

TEST_F(ObjExporters, OptionsBehindTheNameAndNamesInQuotes) {
  folder_.write("two words.ppm", red_picture);
  folder_.write("x -s.ppm", red_picture);
  for (const std::string map : {"two words.ppm -bm 1", "\"two words.ppm\"", "-bm 0.5 \"two words.ppm\" -clamp off",
                                "two words.ppm -s 1 1 -o 0 0 0", "x -s.ppm"}) {
    const Scene scene = with_material("newmtl a\nmap_Kd " + map + "\n");
    EXPECT_EQ(test::notes_of(scene), "") << map;
    EXPECT_EQ(material(scene).texture, 0) << map;
  }
  const Scene missing = with_material("newmtl a\nmap_Kd two words.ppm -bm\n");
  EXPECT_EQ(test::notes_of(missing), "a.mtl:2: the texture 'two words.ppm -bm' is missing.\n") << "no whole option";
  const Scene shared = with_material("newmtl a\nmap_Kd gone.ppm\nmap_d gone.ppm\nnewmtl b\nmap_Kd gone.ppm\n");
  EXPECT_EQ(shared.warnings.size(), 1U) << "once, however many name it: " << test::notes_of(shared);
}

TEST_F(ObjExporters, PicturesBesideTheModelAndInAnyCase) {
  folder_.write("QUAD.PPM", red_picture);
  folder_.write("Maps/Wood.ppm", red_picture);
  folder_.write("sub/b.mtl", "newmtl a\nmap_Kd quad.ppm\n");
  for (const std::string name : {"quad.ppm", "Quad.PPM", "C:\\art\\qUAD.ppm"}) {
    const Scene scene = with_material("newmtl a\nmap_Kd " + name + "\n");
    EXPECT_EQ(material(scene).texture, 0) << name << ": " << test::notes_of(scene);
  }
  EXPECT_EQ(material(with_material("newmtl a\nmap_Kd maps\\WOOD.ppm\n")).texture, 0);
  EXPECT_EQ(material(with_material("", "mtllib sub/b.mtl\n")).texture, 0) << "beside the model, not the material file";
  EXPECT_EQ(material(with_material("newmtl a\nmap_Kd quad.ppx\n")).texture, -1);
}

TEST_F(ObjExporters, TheFileOfThatCaseIsTakenFirst) {
  folder_.write("Q.ppm", red_picture);
  folder_.write("q.ppm", "P3\n1 1\n255\n0 0 255\n");
  EXPECT_EQ(with_material("newmtl a\nmap_Kd q.ppm\n").textures->at(0).texels->at(0, 0), Vec3f(0, 0, 1));
  EXPECT_EQ(with_material("newmtl a\nmap_Kd Q.ppm\n").textures->at(0).texels->at(0, 0), Vec3f(1, 0, 0));
}

TEST_F(ObjExporters, BlackHidesAPicture) {
  folder_.write("q.ppm", red_picture);
  EXPECT_EQ(test::notes_of(with_material("newmtl a\nKd 0 0 0\nmap_Kd q.ppm\n")),
            "a.mtl:3: 'Kd 0 0 0' of 'a' hides the picture of map_Kd: texels are multiplied by Kd.\n");
  EXPECT_EQ(test::notes_of(with_material("newmtl a\nKd 0 0 0.1\nmap_Kd q.ppm\nnewmtl b\nKd 0 0 0\n")), "");
}

// ---- Colours and numbers -------------------------------------------------------------------------------------------

TEST_F(ObjExporters, WhiteLightThatPassesIsNoNews) {
  EXPECT_EQ(test::notes_of(with_material("newmtl a\nTf 1 1 1\nTf 1\nKt 1 1 1\n")), "");
  EXPECT_NE(test::notes_of(with_material("newmtl a\nTf 1 1 0.5\n")).find("'Tf' is not drawn"), std::string::npos);
  EXPECT_NE(test::notes_of(with_material("newmtl a\nKe 1 1 1\n")).find("'Ke' is not drawn"), std::string::npos);
}

TEST_F(ObjExporters, OneValueIsGrey) {
  const Scene scene = with_material("newmtl a\nKd 0.5\nKs 0.25\nNs 3\nKa 0.125\n");
  EXPECT_EQ(test::notes_of(scene), "");
  EXPECT_EQ(material(scene).colour, Vec3d(0.5));
  EXPECT_EQ(material(scene).specular_colour, Vec3d(0.25));
  EXPECT_EQ(material(scene).ambient_colour, Vec3d(0.125));
  EXPECT_EQ(test::notes_of(with_material("newmtl a\nKd 0.5 0.5\n")),
            "a.mtl:2: 'Kd' is left out: found the end of the line, expected a number.\n");
  EXPECT_EQ(test::notes_of(with_material("newmtl a\nKd 0,5\n")),
            "a.mtl:2: 'Kd' is left out: found '0,5', expected a number.\n");
}

TEST_F(ObjExporters, NumbersOutOfTheirRangeAreClamped) {
  const Scene scene = with_material("newmtl a\nd 3\nillum 11\n");
  EXPECT_EQ(test::notes_of(scene), "a.mtl:2: 'd 3' lies outside 0 to 1 and is taken as 1.\n"
                                   "a.mtl:3: 'illum 11' lies outside 0 to 10 and is taken as 10.\n");
  EXPECT_EQ(material(scene).transparency, 0);
  EXPECT_EQ(material(with_material("newmtl a\nTr -1\n")).transparency, 0);
}

TEST_F(ObjExporters, TrOfOneEverywhereMeansOpaque) {
  const Scene opaque = with_material("newmtl a\nTr 1\nnewmtl b\nTr 1.0\n");
  EXPECT_EQ(material(opaque).transparency, 0);
  EXPECT_EQ(test::notes_of(opaque), "a.mtl:2: every material has 'Tr 1' and no 'd', so 1 is taken for opaque.\n");
  // Anything else in the file shows that its author meant the transparency.
  for (const std::string other : {"newmtl b\nTr 0\n", "newmtl b\nTr 1\nd 1\n", "newmtl b\nKd 1 1 1\n"}) {
    const Scene scene = with_material("newmtl a\nTr 1\n" + other);
    EXPECT_EQ(material(scene).transparency, 1) << other;
    EXPECT_EQ(test::notes_of(scene), "a.mtl:2: 'Tr 1' makes the material invisible.\n") << other;
  }
}

// ---- The model file ------------------------------------------------------------------------------------------------

TEST_F(ObjExporters, NamesOfMaterialFilesWithBlanks) {
  folder_.write("my mat lib.mtl", "newmtl a\nKd 0 1 0\n");
  folder_.write("m.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\n");
  folder_.write("lib.mtl", "newmtl a\nKd 0 0 1\n");
  const auto load = [&](const std::string& header) { return with_material("newmtl c\n", header); };
  const Scene both = load("mtllib my mat lib.mtl m.mtl\n");
  EXPECT_EQ(test::notes_of(both), "");
  EXPECT_EQ(files_of(both).size(), 3U);
  EXPECT_EQ(material(both).colour, Vec3d(0, 1, 0)) << "the longest run of words that is a file, not lib.mtl";
  EXPECT_EQ(material(load("mtllib m.mtl my mat lib.mtl\n")).colour, Vec3d(1, 0, 0));
  EXPECT_EQ(material(load("mtllib \"my mat lib.mtl\"\n")).colour, Vec3d(0, 1, 0));
  const Scene partly = load("mtllib gone.mtl m.mtl\n");
  EXPECT_EQ(test::notes_of(partly), "model.obj:1: the material file 'gone.mtl' is missing.\n");
  EXPECT_EQ(material(partly).colour, Vec3d(1, 0, 0));
}

TEST_F(ObjExporters, FreeFormSurfacesBesideFacesAreSkipped) {
  const Scene scene =
      with_material("newmtl a\n", "mtllib a.mtl\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 1\nparm u 0 1\nend\n"
                                  "call other.obj\n");
  EXPECT_EQ(test::notes_of(scene), "model.obj:2: free-form curves and surfaces are not drawn.\n"
                                   "model.obj:7: other files and programs are not run.\n");
  EXPECT_EQ(test::mesh_of(scene).triangles.size(), 1U);
  EXPECT_THROW(folder_.load("v 0 0 0\ncall other.obj\n"), InputError) << "no faces";
}

TEST_F(ObjExporters, StatementsWithoutTheirNames) {
  folder_.write("a.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0 1\n");
  const Scene scene = folder_.load("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\ns\nf 1 2 3\nusemtl\nf 1 2 3\n"
                                   "usemtl\nusemtl b\nf 1 2 3\nusemtl a\nusemtl \nf 1 2 3\n");
  EXPECT_EQ(test::notes_of(scene), "model.obj:6: 's' without a smoothing group is taken for 's off'.\n"
                                   "model.obj:8: 'usemtl' without a name is taken for no material.\n");
  const Vec3d plain(0.8);
  const std::array<Vec3d, 4> expected{Vec3d(1, 0, 0), plain, Vec3d(0, 0, 1), plain};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(material_of(scene, 0, static_cast<int>(i)).colour, expected[i]) << i;
}

}  // namespace
}  // namespace ps::obj_exporters_test
