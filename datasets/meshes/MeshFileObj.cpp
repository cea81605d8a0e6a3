// The check of an OBJ file. Such a file promises no count, so that one that was cut at a line's end
// looks whole; a face whose vertices are missing is found.
#include <algorithm>
#include <map>

#include "datasets/meshes/MeshFileCheck.h"
#include "datasets/meshes/MeshFileText.h"

namespace umbra {
namespace {

using namespace meshfile;

class ObjCheck {
 public:
  ObjCheck(const std::string& content, const std::string& name) : content_(content), name_(name) {}

  CheckedMesh run() {
    countElements();
    mesh_.materials = {""};
    std::string_view rest = content_;
    for (line_ = 1; const auto line = nextLine(rest); ++line_) element(*line);
    return std::move(mesh_);
  }

 private:
  // Faces may refer to vertices that follow them.
  void countElements() {
    std::string_view rest = content_;
    while (auto line = nextLine(rest)) {
      const std::string_view key = nextWord(*line);
      if (key == "v") ++mesh_.vertices;
      if (key == "vn") ++normals_;
    }
  }

  void element(std::string_view line) {
    const std::string_view key = nextWord(line);
    if (key == "v" || key == "vn") {
      vector(key, line);
    } else if (key == "f") {
      face(line);
    } else if (key == "usemtl") {
      const std::string material(nextWord(line));
      const auto [found, isNew] = materialIndex_.try_emplace(material, mesh_.materials.size());
      if (isNew) mesh_.materials.push_back(material);
      material_ = found->second;
    }
  }

  void vector(std::string_view key, std::string_view line) {
    (mesh_.content += key);
    const std::optional<bool> finite = copyVector(line, mesh_.content);
    if (!finite) refuseLine(name_, line_, "has no three numbers after '" + std::string(key) + "'");
    mesh_.content += '\n';
    if (key == "vn") {
      ++normalsSoFar_;
      return;
    }
    if (!*finite) mesh_.nonFinite.push_back(std::uint32_t(verticesSoFar_));
    ++verticesSoFar_;
  }

  // The 1-based index that a reference such as "12" or "-1" means.
  std::int64_t resolved(std::string_view word, std::size_t soFar, std::size_t all,
                        const char* what) const {
    const std::optional<std::int64_t> given = wholeFrom(word);
    const std::int64_t index = given ? (*given < 0 ? std::int64_t(soFar) + *given + 1 : *given) : 0;
    if (index < 1 || index > std::int64_t(all))
      refuseLine(name_, line_,
                 "has a face that refers to " + std::string(what) + " '" + std::string(word) +
                     "'; the file has " + std::to_string(all));
    return index;
  }

  void face(std::string_view line) {
    std::vector<std::int64_t> indices;
    std::string text = "f";
    for (std::string_view corner = nextWord(line); !corner.empty() && corner.front() != '#';
         corner = nextWord(line)) {
      const std::size_t slash = corner.find('/'), last = corner.rfind('/');
      indices.push_back(
          resolved(corner.substr(0, slash), verticesSoFar_, mesh_.vertices, "vertex"));
      (text += ' ') += std::to_string(indices.back());
      if (last != slash && last + 1 < corner.size()) {
        const auto normal = resolved(corner.substr(last + 1), normalsSoFar_, normals_, "normal");
        (text += "//") += std::to_string(normal);
      }
    }
    if (indices.size() < 3) refuseLine(name_, line_, "has a face of fewer than three vertices");
    std::vector<std::int64_t> distinct = indices;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    if (distinct.size() < 3) {
      ++mesh_.degenerateFaces;
      return;
    }
    (mesh_.content += text) += '\n';
    ++mesh_.faces;
    mesh_.faceMaterials.push_back(material_);
  }

  const std::string& content_;
  const std::string& name_;
  CheckedMesh mesh_;
  std::size_t line_ = 0, normals_ = 0, verticesSoFar_ = 0, normalsSoFar_ = 0;
  std::map<std::string, std::uint32_t> materialIndex_{{"", 0}};
  std::uint32_t material_ = 0;
};

}  // namespace

CheckedMesh checkObj(const std::string& content, const std::string& name) {
  return ObjCheck(content, name).run();
}

}  // namespace umbra
