// What no picture needs may be missing, wrong or odd in a model: the picture is that of the clean model, with a note.
#include <gtest/gtest.h>

#include "obj_corpus.h"

namespace ps::obj_leniency_test {
namespace {

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

/// The model reads as one triangle of vertices 1, 2 and 3 without normals and texture coordinates.
void expect_plain(const std::string& text, const std::string& note) {
  const test::ModelFolder folder;
  Scene scene;
  ASSERT_NO_THROW(scene = folder.load(text)) << text;
  const Mesh& mesh = test::mesh_of(scene);
  ASSERT_EQ(mesh.triangles.size(), 1U) << text;
  MeshTriangle plain;
  plain.position = {0, 1, 2};
  EXPECT_EQ(mesh.triangles[0], plain) << text;
  EXPECT_EQ(mesh.origins.object_of(0) + mesh.origins.group_of(0), "");
  EXPECT_NE(test::notes_of(scene).find(note), std::string::npos) << text << test::notes_of(scene);
}

TEST(ObjLeniency, ValuesThatNoFaceUses) {
  for (const std::string value : {"nan", "-nan(ind)", "inf", "1e999", "1.#QNAN", "banana"}) {
    const std::string face = "f 1 2 3\n";
    expect_plain(vertices + "vn 0 " + value + " 1\n" + face, "a normal without three numbers");
    expect_plain(vertices + "vt " + value + " 0\n" + face, "a texture coordinate that is not a number");
    expect_plain(vertices + "v " + value + " 0 0\n" + face, "a vertex without three numbers");
    expect_plain(vertices + "v 5 5 5 1 " + value + " 0\n" + face, "vertex colours are not drawn");
  }
}

TEST(ObjLeniency, IndicesOfWhatIsNotThere) {
  const std::string data = vertices + "vt 0 0\nvn 0 0 1\n";
  expect_plain(data + "f 1/0 2/0 3/0\n", "model.obj:7: an index of a texture coordinate that is not there");
  expect_plain(data + "f 1//0 2//0 3//0\n", "model.obj:7: an index of a normal that is not there");
  expect_plain(data + "f 1/7 2/7 3/7\n", "model.obj:7: an index of a texture coordinate");
  expect_plain(data + "f 1//-2 2//-2 3//-2\n", "model.obj:7: an index of a normal");
  expect_plain(vertices + "f 1/1/1 2/2/2 3/3/3\n", "model.obj:5: an index of a normal");
  expect_plain(vertices + "f 1/x/9999999999 2/y/z 3//\n", "a slash with nothing behind it is taken for no index");
  expect_plain(vertices + "vn nan 0 0\nvt nan\nf 1/1/1 2/1/1 3/1/1\n", "a normal without three numbers");
  expect_plain(vertices + "f +1 +2 +3\n", "");
}

TEST(ObjLeniency, NormalsStayWhereTextureCoordinatesAreMissing) {
  const test::ModelFolder folder;
  const Scene scene = folder.load(vertices + "vn 0 0 1\nf 1/0/1 2/0/1 3/0/1\n");
  EXPECT_EQ(test::mesh_of(scene).triangles[0].normal, (std::array<std::int32_t, 3>{0, 0, 0}));
  EXPECT_EQ(test::mesh_of(scene).triangles[0].uv, (std::array<std::int32_t, 3>{-1, -1, -1}));
}

TEST(ObjLeniency, StatementsThatNothingDraws) {
  const std::string face = vertices + "f 1 2 3\n";
  expect_plain(face + "t crease 2/1/0 0 1 2.0\n", "model.obj:6: tags of subdivision surfaces are not drawn");
  expect_plain(face + "f 1\nf 1 2\nf\n", "model.obj:6: faces with fewer than 3 vertices are not drawn");
  expect_plain(face + "l\np\n", "model.obj:6: lines are not drawn");
  expect_plain(face + "vx 1 2\n", "model.obj:6: 'vx' is not a statement of a model file; perhaps 'v'");
  expect_plain("mtllib\n" + face, "model.obj:1: 'mtllib' without a name is left out");
}

TEST(ObjLeniency, OutlinesThatCrossThemselvesAreDrawnWithANote) {
  const test::ModelFolder folder;
  const Scene tie = folder.load(vertices + "f 1 2 3 4\n"), square = folder.load(vertices + "f 1 2 4 3\n");
  EXPECT_EQ(test::notes_of(tie),
            "model.obj:5: where the outline of a face crosses itself, its triangles may overlap.\n");
  EXPECT_EQ(test::mesh_of(tie).triangles.size(), 2U);
  EXPECT_EQ(test::notes_of(square), "");
}

TEST(ObjLeniency, SmoothingGroupsOfAnySpelling) {
  // A roof of two triangles: smooth where both are of one group that is not off.
  const auto normals = [](const std::string& first, const std::string& second) {
    const test::ModelFolder folder;
    const Scene scene =
        folder.load("v 0 0 0\nv 0 0 1\nv -1 -1 0\nv 1 -1 0\ns " + first + "\nf 1 2 3\ns " + second + "\nf 2 1 4\n");
    const Mesh& mesh = test::mesh_of(scene);
    EXPECT_EQ(mesh.triangles.size(), 2U);
    if (mesh.triangles[0].normal[0] < 0) return std::string("flat");
    const bool shared = mesh.triangles[0].normal[0] == mesh.triangles[1].normal[1];
    return std::string(shared ? "smooth" : "apart");
  };
  for (const std::string group : {"1", "2147483648", "-2147483648", "-1", "on", "On", "99999999999999999999", "7 # c"})
    EXPECT_EQ(normals(group, group), "smooth") << group;
  for (const std::string off : {"off", "Off", "OFF", "0", "-0", "none", ""})
    EXPECT_EQ(normals(off, off), "flat") << off;
  EXPECT_EQ(normals("on", "1"), "smooth");
  EXPECT_EQ(normals("2147483648", "-2147483648"), "apart");
  EXPECT_EQ(normals("1", "4294967297"), "apart") << "not the same in 32 bits";
}

TEST(ObjLeniency, CommentsEndWithTheirLine) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : std::string("# C:\\models\\\nv 0 0 0# a\\\nv 1 0 0 # b\\\nv 0 1 0\nf 1 2\\\n 3# c\\\n# d \\\n"))
      text += c == '\n' ? end : std::string{c};
    expect_plain(text, "");
  }
}

TEST(ObjLeniency, CommentsGluedToNumbers) {
  expect_plain("v 0 0 0#1\nv 1 0 0#\nv 0 1 0 #\nvn 0 0 1#x\nvt 0#x\ns 0#x\nf 1 2 3# c\n", "");
}

TEST(ObjLeniency, AsManyVerticesAsOneLikes) {
  std::string text, face = "f";
  for (int i = 0; i < 20000; ++i) {
    text += "v " + std::to_string(i) + " " + std::to_string(i % 2 == 0 ? 0 : i + 1) + " 0\n";
    face += " " + std::to_string(i + 1) + "/1/1";
  }
  const test::ModelFolder folder;
  EXPECT_EQ(test::mesh_of(folder.load(text + face + "\n")).triangles.size(), 19998U);
}

// ---- Names -------------------------------------------------------------------------------------------------------

TEST(ObjLeniency, NamesWithNumberSigns) {
  const test::ModelFolder folder;
  folder.write("a.mtl",
               "newmtl #1 red\nKd 1 0 0\nnewmtl a#b # comment\nKd 0 1 0\nnewmtl Material #25\nKd 0 0 1\n"
               "newmtl Material #26\nKd 0 0 0.5\nnewmtl plain #comment\nKd 0.5 0 0\nnewmtl \"q r\"\nKd 0 0.5 0\n");
  const auto colour = [&](const std::string& name) {
    const Scene scene = folder.load("mtllib a.mtl #here\n" + vertices + "usemtl " + name + "\nf 1 2 3\n");
    EXPECT_EQ(test::notes_of(scene), "") << name;
    return material_of(scene, 0, 0).colour;
  };
  EXPECT_EQ(colour("#1 red"), Vec3d(1, 0, 0));
  EXPECT_EQ(colour("#1 red # comment"), Vec3d(1, 0, 0));
  EXPECT_EQ(colour("a#b"), Vec3d(0, 1, 0));
  EXPECT_EQ(colour("a#b #comment"), Vec3d(0, 1, 0));
  EXPECT_EQ(colour("Material #25"), Vec3d(0, 0, 1));
  EXPECT_EQ(colour("Material #26"), Vec3d(0, 0, 0.5));
  EXPECT_EQ(colour("plain"), Vec3d(0.5, 0, 0));
  EXPECT_EQ(colour("q r"), Vec3d(0, 0.5, 0));
  EXPECT_EQ(colour("\"a#b\""), Vec3d(0, 1, 0));
}

// ---- Material files ----------------------------------------------------------------------------------------------

TEST(ObjLeniency, MaterialStatementsWithoutValues) {
  const test::ModelFolder folder;
  const auto load = [&](const std::string& lines) {
    folder.write("a.mtl", "newmtl a\nKd 0.25 0.5 0.75\n" + lines);
    return folder.load("mtllib a.mtl\n" + vertices + "usemtl a\nf 1 2 3\n");
  };
  for (const std::string lines : {"map_Kd\n",
                                  "map_Bump -bm\n",
                                  "Kd\n",
                                  "Kd nan 0 0\n",
                                  "Kd 1 0\n",
                                  "Ks nan nan nan\n",
                                  "Ka spectral x.rfl\n",
                                  "Ns\n",
                                  "Ns nan\n",
                                  "d\n",
                                  "Tr x\n",
                                  "illum\n",
                                  "illum two\n",
                                  "refl -type cylinder a.ppm\n",
                                  "map_Kd -foo 1 a.ppm\n",
                                  "Ke nan\n",
                                  "Ni\n",
                                  "norm\n",
                                  "newmtl\nKd 1 1 1\nd 0\n",
                                  "newmtl #\nKd 1 1 1\n"}) {
    const Scene scene = load(lines);
    EXPECT_EQ(scene.warnings.size(), 1U) << lines << test::notes_of(scene);
    EXPECT_EQ(test::notes_of(scene).find("a.mtl:3: '"), 0U) << test::notes_of(scene);
    EXPECT_EQ(material_of(scene, 0, 0).colour, Vec3d(0.25, 0.5, 0.75)) << lines;
    EXPECT_FALSE(material_of(scene, 0, 0).specular) << lines;
    EXPECT_EQ(material_of(scene, 0, 0).transparency, 0) << lines;
  }
  const Scene four = load("Kd 1 0.5 0 0.25\n");
  EXPECT_EQ(material_of(four, 0, 0).colour, Vec3d(1, 0.5, 0));
  EXPECT_EQ(test::notes_of(four), "a.mtl:3: 'Kd' has three numbers; what follows is not used.\n");
}

TEST(ObjLeniency, MaterialFilesThatAreNoText) {
  const test::ModelFolder folder;
  folder.write("a.mtl", std::string("newmtl a\0\n", 10));
  const Scene scene = folder.load("mtllib a.mtl\n" + vertices + "f 1 2 3\n");
  EXPECT_NE(test::notes_of(scene).find("a NUL byte"), std::string::npos) << test::notes_of(scene);
}

TEST(ObjLeniency, CommentsOfMaterialFilesEndWithTheirLine) {
  const test::ModelFolder folder;
  folder.write("a.mtl", "# C:\\maps\\\r\nnewmtl a # D:\\\r\nKd 1 0#x\\\r\n 0\r\nKd 0 1 0 # \\\r\n");
  const Scene scene = folder.load("mtllib a.mtl\n" + vertices + "usemtl a\nf 1 2 3\n");
  EXPECT_EQ(material_of(scene, 0, 0).colour, Vec3d(0, 1, 0)) << test::notes_of(scene);
}

// ---- Where faces stand -------------------------------------------------------------------------------------------

TEST(ObjOrigins, KeepLineNamesAndIndices) {
  const test::ModelFolder folder;
  folder.write("a.mtl", "newmtl a\nmap_Kd -s 2 2 p.ppm\n");
  folder.write("p.ppm", "P3\n1 1\n255\n255 0 0\n");
  const Scene scene = folder.load("mtllib a.mtl\n" + vertices +
                                  "vt 0 0\nvt 1 0\nvn 0 0 1\nf 1 2 3\no first thing\ng left top\n"
                                  "f 1/1/1 2/2/1 \\\n4/2/1 3/1/1\ng\ns 1\nusemtl a\nf 1/2 2/1 3/2\no\nf 1//1 2 3/9\n");
  const Mesh& mesh = test::mesh_of(scene);
  ASSERT_EQ(mesh.triangles.size(), 5U);
  EXPECT_EQ(mesh.origins.lines, (std::vector<std::uint32_t>{9, 12, 12, 17, 19}));
  EXPECT_EQ(mesh.origins.object_of(0) + "|" + mesh.origins.group_of(0), "|");
  EXPECT_EQ(mesh.origins.object_of(2) + "|" + mesh.origins.group_of(2), "first thing|left top");
  EXPECT_EQ(mesh.origins.object_of(3) + "|" + mesh.origins.group_of(3), "first thing|");
  EXPECT_EQ(mesh.origins.object_of(4), "");
  const auto triple = [](int a, int b, int c) { return std::array<std::int32_t, 3>{a, b, c}; };
  EXPECT_EQ(file_indices(mesh, 0), FileIndices{});
  EXPECT_EQ(file_indices(mesh, 1), (FileIndices{triple(0, 1, 1), triple(0, 0, 0)}));
  EXPECT_EQ(file_indices(mesh, 3), (FileIndices{triple(1, 0, 1), triple(-1, -1, -1)})) << "moved and smoothed";
  EXPECT_EQ(file_indices(mesh, 4), (FileIndices{triple(-1, -1, 8), triple(0, -1, -1)})) << "not used";
}

}  // namespace
}  // namespace ps::obj_leniency_test
