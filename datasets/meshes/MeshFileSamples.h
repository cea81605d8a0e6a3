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

inline std::string cubeBuffer() {
  std::string out;
  for (int i = 0; i < 8; ++i)
    for (float x : corner(i)) appendBytes(out, x);
  for (const auto& q : quads)
    for (int v : {q[0], q[1], q[2], q[0], q[2], q[3]}) appendBytes(out, std::uint16_t(v));
  return out;
}

inline std::string base64(const std::string& bytes) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : letters[group >> (18 - 6 * k) & 63];
  }
  return out;
}

// `buffer` is what the one buffer says beside its length; `node` what the one node says beside its
// mesh, and `more` further members of the file.
inline std::string cubeGltf(const std::string& buffer, const std::string& node = "",
                            const std::string& more = "") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0)" +
         node + R"(}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
"accessors": [
{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
{"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
"buffers": [{"byteLength": 168)" +
         buffer + "}]" + more + "}\n";
}

inline std::string cubeGltfText(const std::string& node = "", const std::string& more = "") {
  return cubeGltf(
      ", \"uri\": \"data:application/octet-stream;base64," + base64(cubeBuffer()) + "\"", node,
      more);
}

inline std::string cubeGlb() {
  std::string json = cubeGltf("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = cubeBuffer();
  std::string out = "glTF";
  appendBytes(out, 2u);
  appendBytes(out, std::uint32_t(28 + json.size() + buffer.size()));
  appendBytes(out, std::uint32_t(json.size()));
  out += "JSON" + json;
  appendBytes(out, std::uint32_t(buffer.size()));
  return out + std::string("BIN\0", 4) + buffer;
}

}  // namespace umbra::meshsamples
