// Checks what a mesh file promises before a reader sees it. OpenMesh's readers take a truncated
// file for a whole one, skip a number that they cannot read, and trust any count.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace umbra {

struct CheckedMesh {
  // The same mesh in the same format, with nothing but positions, normals and faces: the reader
  // gets this. Text coordinates that are not finite numbers are written as 0.
  std::string content;
  bool binary = false;
  std::size_t vertices = 0, faces = 0;   // in `content`; STL readers share equal vertices
  std::vector<std::uint32_t> nonFinite;  // vertices that were written as 0, ascending
  std::size_t degenerateFaces = 0, nonFiniteFaces = 0;  // left out of `content`
  // OBJ: for each face the index of its material's name; materials[0] is "", none.
  std::vector<std::uint32_t> faceMaterials;
  std::vector<std::string> materials;
};

// Messages call the file `name`. All of these throw BadInput where the content is no mesh of that
// format, is truncated (with what was read and what was promised), or has a face that refers to a
// missing vertex.
CheckedMesh checkPly(const std::string& content, const std::string& name);
CheckedMesh checkOff(const std::string& content, const std::string& name);
CheckedMesh checkObj(const std::string& content, const std::string& name);
CheckedMesh checkStl(const std::string& content, const std::string& name);

}  // namespace umbra
