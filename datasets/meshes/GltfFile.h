// glTF 2.0 files, text or binary, as TinyGLTF parses them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tinygltf {
class Model;
}

namespace umbra::meshfile {

class GltfFile {
 public:
  // Pictures, textures, cameras and animations are left aside. Buffers beside the file are read
  // only from its own folder and those in it. Throws BadInput that begins with `name`, the file's
  // path: no glTF of version 2, a buffer that is missing, an extension without which its shapes
  // cannot be read.
  GltfFile(std::string_view content, const std::string& name);
  ~GltfFile();
  GltfFile(const GltfFile&) = delete;
  GltfFile& operator=(const GltfFile&) = delete;

  const tinygltf::Model& model() const { return *model_; }
  // The accessor's values, `components` for each element: 1 for a scalar, 3 for a vector. Throws
  // BadInput where it has another number of components, or lies outside of its buffer.
  std::vector<double> values(int accessor, int components) const;
  // One clause for each thing in the file that was left aside and changes its shape.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::string name_;
  std::unique_ptr<tinygltf::Model> model_;
  std::vector<std::string> notes_;
};

}  // namespace umbra::meshfile
