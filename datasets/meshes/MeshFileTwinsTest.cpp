// Ways in which real programs write the same mesh: each must give what its plain twin gives.
#include <gtest/gtest.h>

#include <fstream>

#include "datasets/meshes/MeshFileSamples.h"
#include "datasets/scenes/MeshScene.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;
using namespace meshsamples;

struct Twin {
  std::string name, extension, content;
  std::string note;  // a part of what the report must say; "" where it must say nothing
  UpAxis up = UpAxis::Y;
};

void PrintTo(const Twin& twin, std::ostream* out) {
  *out << twin.name;
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string everywhere(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// The plate M0: four units square at y = 2, on a pin.
using Points = std::vector<std::array<double, 3>>;
const Points platePoints{{0, 2, 0}, {4, 2, 0},    {4, 2, 4},   {0, 2, 4},
                         {2, 0, 2}, {2.01, 2, 2}, {2, 2, 2.01}};

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.12g", value);
  return buffer;
}

std::string lines(const Points& points, const std::string& before, const std::string& after = "") {
  std::string lines;
  for (const auto& p : points)
    lines += before + text(p[0]) + " " + text(p[1]) + " " + text(p[2]) + after + "\n";
  return lines;
}

std::string plateObj(const Points& points = platePoints) {
  return lines(points, "v ") + "f 1 2 3 4\nf 5 6 7\n";
}

std::string plateOff(const std::string& head, const std::string& after = "") {
  return head + "7 2 0\n" + lines(platePoints, "", after) + "4 0 1 2 3\n3 4 5 6\n";
}

std::string platePly(const std::string& faces = "element face 2",
                     const std::string& body = "4 0 1 2 3\n3 4 5 6\n") {
  return "ply\nformat ascii 1.0\nelement vertex 7\nproperty double x\nproperty double y\n"
         "property double z\n" +
         faces + "\nproperty list int int vertex_indices\nend_header\n" + lines(platePoints, "") +
         body;
}

std::string binaryPly(const std::string& lineEnd) {
  std::string out = everywhere(
      "ply\nformat binary_little_endian 1.0\nelement vertex 7\nproperty double x\n"
      "property double y\nproperty double z\nelement face 2\n"
      "property list double short vertex_indices\nend_header\n",
      "\n", lineEnd);
  for (const auto& p : platePoints)
    for (double value : p) appendBytes(out, value);
  for (const auto& face : {std::vector<short>{0, 1, 2, 3}, std::vector<short>{4, 5, 6}}) {
    appendBytes(out, double(face.size()));
    for (short v : face) appendBytes(out, v);
  }
  return out;
}

const std::array<std::array<std::size_t, 3>, 3> plateTriangles{{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}};

std::string facet(std::size_t t) {
  std::string out = "facet normal 0 0 0\n  outer loop\n";
  for (std::size_t v : plateTriangles[t])
    out += "vertex " + text(platePoints[v][0]) + " " + text(platePoints[v][1]) + " " +
           text(platePoints[v][2]) + "\n";
  return out + "  endloop\nendfacet\n";
}

std::string plateStl() {
  return "solid plate\n" + facet(0) + facet(1) + facet(2) + "endsolid plate\n";
}

std::string upper(std::string text) {
  for (char& c : text) c = char(std::toupper(c));
  return text;
}

std::string binaryStl(const std::string& head, std::uint32_t count = 3) {
  std::string out = head + std::string(80 - head.size(), ' ');
  appendBytes(out, count);
  for (const auto& triangle : plateTriangles) {
    out += std::string(12, '\0');
    for (std::size_t v : triangle)
      for (double value : platePoints[v]) appendBytes(out, float(value));
    out += std::string(2, '\0');
  }
  return out;
}

std::string utf16(const std::string& text, bool bigEnd) {
  std::string out = bigEnd ? "\xfe\xff" : "\xff\xfe";
  for (char c : text) appendBytes(out, std::uint16_t(c), bigEnd);
  return out;
}

Points scaled(double factor) {
  Points points = platePoints;
  for (auto& p : points)
    for (double& value : p) value *= factor;
  return points;
}

Points zUp() {
  Points points = platePoints;
  for (auto& p : points) p = {p[0], -p[2], p[1]};
  return points;
}

std::vector<Twin> twins() {
  const std::string bom = "\xef\xbb\xbf";
  return {
      {"objMark", ".obj", bom + plateObj(), ""},
      {"objMarkAndSpareVertex", ".obj", with(bom + plateObj(), "f 1", "v 9 9 9\nf 1"), ""},
      {"objBackslash", ".obj",
       with(with(plateObj(), "1 2 3 4", "1 2 \\\n3 4"), "v 4 2 0", "v 4\\\r\n2 0"), ""},
      {"objPathInComment", ".obj", "# C:\\models\\\n" + plateObj(), ""},
      {"objPathAfterAFace", ".obj",
       with(plateObj(), "f 1 2 3 4", "f 1 1 2 # C:\\models\\\nf 1 2 3 4"), "1 face without area"},
      {"objCommentWithoutABlank", ".obj", with(plateObj(), "1 2 3 4", "1 2 3 4#plate"), ""},
      {"objCarriageReturns", ".obj", everywhere(plateObj(), "\n", "\r"), ""},
      {"objTextureNan", ".obj", with(plateObj(), "f 1", "vt nan nan\nf 1"), ""},
      {"objColours", ".obj", everywhere(plateObj(), "\nv 4 2 0", "\nv 4 2 0 0.5 0.25 1"), ""},
      {"objWeight", ".obj", everywhere(plateObj(), "\nv 4 2 0", "\nv 4 2 0 1.0"), ""},
      {"objSmall", ".obj", plateObj(scaled(1e-6)), ""},
      {"objZUp", ".obj", plateObj(zUp()), "", UpAxis::Z},
      {"objShortFaces", ".obj", plateObj() + "f 1 2\nf 3\n",
       "2 faces of fewer than three vertices"},
      {"objMicrosoftNan", ".obj", plateObj() + "v -1.#IND 0 1.#QNAN\nf 1 2 8\n",
       "1 face with coordinates that are not finite"},
      {"objNoNumber", ".obj", plateObj() + "v 3.1+e2 0 0\nf 1 2 8\n", "the first in line 10"},
      {"objUtf16", ".obj", utf16(plateObj(), false), ""},
      {"objUtf16BigEnd", ".obj", utf16(plateObj(), true), ""},
      {"plyMark", ".ply", bom + platePly(), ""},
      {"plyBlank", ".ply", with(platePly(), "ply\n", "ply \n"), ""},
      {"plyCarriageReturns", ".ply", everywhere(platePly(), "\n", "\r"), ""},
      {"plyBinary", ".ply", binaryPly("\n"), ""},
      {"plyBinaryAfterCarriageReturns", ".ply", binaryPly("\r"), ""},
      {"plyBinaryAfterBoth", ".ply", binaryPly("\r\n"), ""},
      {"plyStrips", ".ply", platePly("element tristrips 1", "9 0 1 3 2 -1 4 5 6 -1\n"), ""},
      {"plyForgottenKeyword", ".ply",
       with(platePly(), "element", "Created by Blender3D 247\nelement"),
       "the first is 'Created by Blender3D 247'"},
      {"plyShortFaces", ".ply", platePly("element face 3", "2 0 1\n4 0 1 2 3\n3 4 5 6\n"),
       "1 face of fewer than three vertices"},
      {"offMark", ".off", bom + plateOff("OFF\n"), ""},
      {"offModelNet", ".off", plateOff("OFF"), ""},
      {"offComments", ".off",
       with(plateOff("# a\nOFF # b\n\n# c\n"), "4 2 0\n", "4 2 0 # d\n# e\n"), ""},
      {"offCountsOnLines", ".off", with(plateOff("OFF\n"), "7 2 0", "7\n2\n0"), ""},
      {"offWithoutEdges", ".off", with(plateOff("OFF\n"), "7 2 0", "7 2"), ""},
      {"offUnsaidColours", ".off", plateOff("OFF\n", " 0.5 0.5 0.5"), "more numbers than"},
      {"offColours", ".off", plateOff("COFF\n", " 255 0 0 255"), ""},
      {"offNormals", ".off", plateOff("NOFF\n", " 0 1 0"), ""},
      {"offTexture", ".off", plateOff("STOFF\n", " 0.5 0.5"), ""},
      {"offWithoutKeyword", ".off", plateOff(""), ""},
      {"stlMark", ".stl", bom + plateStl(), ""},
      {"stlCapitals", ".stl", upper(plateStl()), ""},
      {"stlBlanksBefore", ".stl", " \n\t " + plateStl(), ""},
      {"stlEndSolid", ".stl", with(plateStl(), "endsolid", "end solid"), ""},
      {"stlNoName", ".stl", everywhere(plateStl(), "solid plate", "solid"), ""},
      {"stlTwoSolids", ".stl",
       "solid a\n" + facet(0) + "endsolid a\nsolid b\n" + facet(1) + facet(2) + "endsolid\n", ""},
      {"stlBinary", ".stl", binaryStl("x"), ""},
      {"stlBinarySolid", ".stl", binaryStl("solid"), ""},
      {"stlBinarySolidFacet", ".stl", binaryStl("solid facet"), ""},
      {"stlBinaryCountNone", ".stl", binaryStl("solid facet", 0), "the header promises 0 facets"},
      {"stlFacetFirst", ".stl", facet(0) + facet(1) + facet(2), ""},
      {"stlBinaryCountNoneAndMore", ".stl", binaryStl("x", 0) + "tail", "promises 0 facets"},
      {"stlBinaryCountOnes", ".stl", binaryStl("", UINT32_MAX), "promises 4294967295 facets"}};
}

class MeshFileTwin : public testing::TestWithParam<Twin> {
 protected:
  Scene read(const std::string& name, const std::string& content, UpAxis up, MeshReport& report) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return sceneFromMeshFile(folder_ / name, up, &report);
  }
  const TemporaryFolder folder_;
};

// The areas that all objects but the ground show to the light above them and beneath, and their
// bounds.
struct Figure {
  double up = 0.0, down = 0.0;
  Eigen::AlignedBox3d bounds;
};

Figure figureOf(const Scene& scene) {
  Figure figure;
  for (const SceneObject& object : scene.objects) {
    if (object.name == "paving" || object.name == "ground") continue;
    figure.bounds.extend(object.mesh.bounds());
    for (const auto& t : object.mesh.triangles) {
      const Eigen::Vector3d a = object.mesh.positions[t[0]].cast<double>();
      const double y = 0.5 * (object.mesh.positions[t[1]].cast<double>() - a)
                                 .cross(object.mesh.positions[t[2]].cast<double>() - a)
                                 .y();
      (y > 0.0 ? figure.up : figure.down) += std::abs(y);
    }
  }
  return figure;
}

TEST_P(MeshFileTwin, GivesWhatThePlainFileGives) {
  MeshReport none, report;
  const Figure plain = figureOf(read("plain.obj", plateObj(), UpAxis::Y, none));
  EXPECT_EQ(none.summary(), "");
  const Twin& twin = GetParam();
  const Figure figure = figureOf(read("twin" + twin.extension, twin.content, twin.up, report));
  // Floats of a mesh of four units have steps of 2.4e-7; areas add up products with 4.
  EXPECT_NEAR(figure.up, plain.up, 1e-5);
  EXPECT_NEAR(figure.down, plain.down, 1e-5);
  EXPECT_NEAR(figure.up + figure.down, 16.0, 0.001);
  EXPECT_TRUE(figure.bounds.isApprox(plain.bounds, 1e-6));
  if (twin.note.empty())
    EXPECT_EQ(report.summary(), "");
  else
    EXPECT_NE(report.summary().find(twin.note), std::string::npos) << report.summary();
}

INSTANTIATE_TEST_SUITE_P(Table, MeshFileTwin, testing::ValuesIn(twins()),
                         [](const auto& test) { return test.param.name; });

TEST(MeshFileFarAway, KeepsTheShapeOfAMeshInMapCoordinates) {
  const TemporaryFolder folder;
  // Eight slats of 0.2 beside each other: as floats so far out, they have no width or twice as
  // much.
  const double east = 4'649'776.0;
  std::string obj, faces;
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 35\nproperty double x\nproperty double y\n"
      "property double z\nelement face 9\nproperty list uchar int vertex_indices\nend_header\n";
  Points points;
  for (int i = 0; i < 8; ++i)
    for (const auto& [x, z] : {std::pair(0.0, 0.0), {0.2, 0.0}, {0.2, 4.0}, {0.0, 4.0}})
      points.push_back({east + 0.5 * i + x, 2.0, z});
  for (std::size_t v = 4; v < 7; ++v)
    points.push_back({east + platePoints[v][0], platePoints[v][1], platePoints[v][2]});
  for (int i = 0; i < 8; ++i) {
    faces += "4";
    obj += "f";
    for (int k = 0; k < 4; ++k) {
      faces += " " + std::to_string(4 * i + k);
      obj += " " + std::to_string(4 * i + k + 1);
    }
    faces += "\n";
    obj += "\n";
  }
  std::ofstream(folder / "far.obj") << lines(points, "v ") + obj + "f 33 34 35\n";
  std::ofstream(folder / "far.ply") << ply + lines(points, "") + faces + "3 32 33 34\n";
  for (const char* name : {"far.obj", "far.ply"}) {
    const Figure figure = figureOf(sceneFromMeshFile(folder / name));
    // The longest side is 4, so that the scale is 1.
    EXPECT_NEAR(figure.up + figure.down, 6.4, 1e-3) << name;
    EXPECT_NEAR(figure.bounds.sizes().x(), 3.7, 1e-6) << name;
  }
}

TEST(MeshFileParts, BecomeObjectsOfTheirNames) {
  const TemporaryFolder folder;
  const auto names = [&](const std::string& file, const std::string& content) {
    std::ofstream(folder / file) << content;
    std::vector<std::string> found;
    MeshReport report;
    for (const SceneObject& object : sceneFromMeshFile(folder / file, UpAxis::Y, &report).objects)
      found.push_back(object.name);
    if (!report.notes.empty()) found.push_back(report.notes[0]);
    return found;
  };
  using Names = std::vector<std::string>;
  const std::string faces = "f 1 2 3 4\n", pin = "f 5 6 7\n", vertices = lines(platePoints, "v ");
  EXPECT_EQ(names("a.obj", vertices + "o top plate\n" + faces + "g pin\n" + pin),
            (Names{"top plate", "pin", "paving", "ground"}));
  EXPECT_EQ(names("b.obj", vertices + "usemtl red\n" + faces + "usemtl blue\n" + pin),
            (Names{"red", "blue", "paving", "ground"}));
  EXPECT_EQ(names("c.obj", vertices + "o x\nusemtl red\n" + faces + "usemtl blue\n" + pin),
            (Names{"x (red)", "x (blue)", "paving", "ground"}));
  EXPECT_EQ(names("d.obj", vertices + "o paving\n" + faces + "o paving\n" + pin),
            (Names{"paving (2)", "paving", "ground"}));
  EXPECT_EQ(
      names("e.stl", "solid one\n" + facet(0) + "endsolid\nsolid two\n" + facet(2) + "endsolid\n"),
      (Names{"one", "two", "paving", "ground"}));
  std::string many = vertices;
  for (int i = 0; i < 70; ++i) many += "o part" + std::to_string(i) + "\n" + faces;
  EXPECT_EQ(names("f.obj", many),
            (Names{"f", "paving", "ground",
                   "its 70 named parts became one object, since more than 64 could not be told "
                   "apart"}));
}

// A vertex at 1e6 scales all others to nothing: that is said.
TEST(MeshFileStrays, AreNamed) {
  const TemporaryFolder folder;
  const auto notesOf = [&](const std::string& last) {
    std::ofstream(folder / "a.obj")
        << lines(platePoints, "v ") << "v 1 2 1\nv " << last << "\nf 1 2 3 4\nf 5 6 7\nf 1 8 9\n";
    MeshReport report;
    sceneFromMeshFile(folder / "a.obj", UpAxis::Y, &report);
    return report.notes;
  };
  EXPECT_TRUE(notesOf("9 2 9").empty());
  // A triangle far from many others.
  std::string many;
  for (int i = 0; i < 40; ++i)
    many += "v " + std::to_string(i % 7) + " 0 " + std::to_string(i % 5) + "\n";
  for (int i = 1; i < 39; ++i)
    many +=
        "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  std::ofstream(folder / "b.obj") << many << "v 1e9 0 0\nv 1e9 1e6 0\nv 1e9 0 1e6\nf 41 42 43\n";
  MeshReport report;
  sceneFromMeshFile(folder / "b.obj", UpAxis::Y, &report);
  ASSERT_FALSE(report.notes.empty());
  EXPECT_TRUE(report.notes.back().starts_with("3 vertices lie")) << report.notes.back();
  EXPECT_EQ(notesOf("1e6 2 3"),
            std::vector<std::string>{"1 vertex lies more than a thousand times as far out as all "
                                     "others are wide, which makes a dot of these"});
}

TEST(MeshFileHeader, RefusesAPlyWhoseUnknownLineMayHaveLaidOutValues) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.ply") << with(platePly(), "element face",
                                          "proprety uchar red\nelement face");
  std::string binary = binaryPly("\n");
  binary = with(binary, "element face", "proprety uchar red\nelement face");
  EXPECT_NO_THROW(readMeshFile(folder / "a.ply"));  // no value is left over
  std::ofstream(folder / "b.ply", std::ios::binary) << binary + std::string(7, 'x');
  EXPECT_THROW(readMeshFile(folder / "b.ply"), Error);
  std::ofstream(folder / "c.ply", std::ios::binary) << binaryPly("\r\r\n");
  EXPECT_THROW(readMeshFile(folder / "c.ply"), Error);
}

}  // namespace
}  // namespace umbra
