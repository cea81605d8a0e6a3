// Small meshes in every format, for tests: a unit cube of eight vertices, as quads where the
// format has polygons.
#pragma once

#include <array>
#include <cstring>
#include <string>

namespace umbra::meshsamples {

inline constexpr std::array<std::array<int, 4>, 6> quads{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

inline std::array<float, 3> corner(int i) {
  return {float(i % 4 == 1 || i % 4 == 2), float(i % 4 >= 2), float(i >= 4)};
}

inline std::string pointText(int i) {
  const std::array<float, 3> p = corner(i);
  return std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]);
}

inline std::string cubeObj() {
  std::string text = "# a cube\nmtllib cube.mtl\no cube\n";
  for (int i = 0; i < 8; ++i) text += "v " + pointText(i) + "\n";
  text += "vt 0 0\nusemtl grey\n";
  for (const auto& q : quads) {
    text += "f";
    for (int v : q) text += " " + std::to_string(v + 1) + "/1";
    text += "\n";
  }
  return text;
}

inline std::string plyHeader(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\n"
         "property float z\nproperty uchar red\nelement face 6\nproperty uchar flags\n"
         "property list uchar int vertex_indices\nend_header\n";
}

inline std::string cubePlyText() {
  std::string text = plyHeader("ascii");
  for (int i = 0; i < 8; ++i) text += pointText(i) + " 200\n";
  for (const auto& q : quads) {
    text += "7 4";
    for (int v : q) text += " " + std::to_string(v);
    text += "\n";
  }
  return text;
}

// The bytes of a value in the byte order that is asked for, on a little-endian machine.
template <class T>
void appendBytes(std::string& out, T value, bool bigEnd = false) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) out += bytes[bigEnd ? sizeof(T) - 1 - i : i];
}

inline std::string cubePlyBinary(bool bigEnd = false) {
  std::string out = plyHeader(bigEnd ? "binary_big_endian" : "binary_little_endian");
  for (int i = 0; i < 8; ++i) {
    for (float x : corner(i)) appendBytes(out, x, bigEnd);
    out += char(200);
  }
  for (const auto& q : quads) {
    out += char(7);
    out += char(4);
    for (int v : q) appendBytes(out, v, bigEnd);
  }
  return out;
}

inline std::string cubeOff() {
  std::string text = "OFF\n# vertices faces edges\n8 6 12\n";
  for (int i = 0; i < 8; ++i) text += pointText(i) + "\n";
  for (const auto& q : quads) {
    text += "4 ";
    for (int v : q) text += " " + std::to_string(v);
    text += " 0.5 0.5 0.5\n";
  }
  return text;
}

inline std::string cubeStlText() {
  std::string text = "solid cube\n";
  for (const auto& q : quads)
    for (int half = 0; half < 2; ++half) {
      text += "  facet normal 0 0 0\n    outer loop\n";
      for (int v : {q[0], q[std::size_t(1 + half)], q[std::size_t(2 + half)]})
        text += "      vertex " + pointText(v) + "\n";
      text += "    endloop\n  endfacet\n";
    }
  return text + "endsolid cube\n";
}

inline std::string cubeStlBinary() {
  std::string out(80, ' ');
  appendBytes(out, 12u);
  for (const auto& q : quads)
    for (int half = 0; half < 2; ++half) {
      for (int i = 0; i < 3; ++i) appendBytes(out, 0.0f);
      for (int v : {q[0], q[std::size_t(1 + half)], q[std::size_t(2 + half)]})
        for (float x : corner(v)) appendBytes(out, x);
      out += std::string(2, '\0');
    }
  return out;
}

}  // namespace umbra::meshsamples
