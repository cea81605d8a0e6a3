// The reader of glTF 2.0: TinyGLTF parses the file, and its nodes become parts.
#include <tiny_gltf.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "datasets/meshes/GltfFile.h"
#include "datasets/meshes/MeshFileText.h"
#include "datasets/meshes/PolygonMesh.h"

namespace umbra::meshfile {
namespace {

using Eigen::Vector3d;

// Nodes may show one mesh many times: a small file could ask for more than any memory holds.
constexpr std::size_t mostTriangles = 50'000'000;

// The linear value as sRGB, which materials here have.
double encoded(double linear) {
  const double value = std::clamp(linear, 0.0, 1.0);
  return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

Eigen::Affine3d placementOf(const tinygltf::Node& node) {
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();
  if (node.matrix.size() == 16) {
    placement.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());  // columns first
    return placement;
  }
  if (node.translation.size() == 3)
    placement.translate(Vector3d(node.translation[0], node.translation[1], node.translation[2]));
  if (node.rotation.size() == 4)
    placement.rotate(
        Eigen::Quaterniond(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2])
            .normalized());
  if (node.scale.size() == 3)
    placement.scale(Vector3d(node.scale[0], node.scale[1], node.scale[2]));
  return placement;
}

class GltfReader {
 public:
  GltfReader(std::string_view content, const std::string& name, const Progress& progress)
      : name_(name), progress_(progress), file_(content, name), model_(file_.model()) {}

  PolygonMesh run() {
    mesh_.notes = file_.notes();
    nameMaterials();
    isVisited_.assign(model_.nodes.size(), false);
    for (int root : roots()) visit(root, Eigen::Affine3d::Identity());
    if (leftOut_ > 0)
      mesh_.notes.push_back(std::to_string(leftOut_) + " sets of points or lines were left out");
    if (hasMorphs_) mesh_.notes.push_back("its morph targets were not applied");
    return std::move(mesh_);
  }

 private:
  void nameMaterials() {
    std::map<std::string, int> known;
    for (std::size_t m = 0; m < model_.materials.size(); ++m) {
      const tinygltf::Material& material = model_.materials[m];
      std::string name = material.name.empty() ? "material " + std::to_string(m) : material.name;
      if (known[name]++ > 0) name += " #" + std::to_string(m);
      const std::vector<double>& colour = material.pbrMetallicRoughness.baseColorFactor;
      Material& plain = mesh_.materials[name];
      for (int i = 0; i < 3; ++i)
        plain.colour[i] = encoded(colour.size() >= 3 ? colour[std::size_t(i)] : 1.0);
      materialNames_.push_back(name);
    }
  }

  // The nodes of the scene that is to be shown; all that no other node holds where none is named.
  std::vector<int> roots() const {
    if (!model_.scenes.empty()) {
      const bool named =
          model_.defaultScene >= 0 && std::size_t(model_.defaultScene) < model_.scenes.size();
      return model_.scenes[named ? std::size_t(model_.defaultScene) : 0].nodes;
    }
    std::vector<bool> isHeld(model_.nodes.size(), false);
    for (const tinygltf::Node& node : model_.nodes)
      for (int child : node.children)
        if (child >= 0 && std::size_t(child) < isHeld.size()) isHeld[std::size_t(child)] = true;
    std::vector<int> roots;
    for (std::size_t n = 0; n < isHeld.size(); ++n)
      if (!isHeld[n]) roots.push_back(int(n));
    return roots;
  }

  // All nodes below one. They form a tree; a chain of any length must not take any number of calls.
  void visit(int root, const Eigen::Affine3d& placement) {
    std::vector<std::pair<int, Eigen::Affine3d>> open{{root, placement}};
    while (!open.empty()) {
      const auto [index, parent] = open.back();
      open.pop_back();
      if (index < 0 || std::size_t(index) >= model_.nodes.size())
        refuse(name_, "refers to node " + std::to_string(index) + "; it has " +
                          std::to_string(model_.nodes.size()));
      if (isVisited_[std::size_t(index)])
        refuse(name_, "holds node " + std::to_string(index) + " twice, or in a circle");
      isVisited_[std::size_t(index)] = true;
      const tinygltf::Node& node = model_.nodes[std::size_t(index)];
      const Eigen::Affine3d own = parent * placementOf(node);
      if (node.mesh >= 0) addMesh(node, own);
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
        open.emplace_back(*child, own);
    }
  }

  void addMesh(const tinygltf::Node& node, const Eigen::Affine3d& placement) {
    if (std::size_t(node.mesh) >= model_.meshes.size())
      refuse(name_, "refers to mesh " + std::to_string(node.mesh) + "; it has " +
                        std::to_string(model_.meshes.size()));
    const tinygltf::Mesh& mesh = model_.meshes[std::size_t(node.mesh)];
    for (const tinygltf::Primitive& primitive : mesh.primitives) {
      hasMorphs_ = hasMorphs_ || !primitive.targets.empty();
      const auto position = primitive.attributes.find("POSITION");
      const bool isSurface = primitive.mode == TINYGLTF_MODE_TRIANGLES ||
                             primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                             primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
      if (!isSurface || position == primitive.attributes.end()) {
        ++leftOut_;
        continue;
      }
      const bool hasMaterial =
          primitive.material >= 0 && std::size_t(primitive.material) < materialNames_.size();
      mesh_.beginPart({node.name.empty() ? mesh.name : node.name,
                       hasMaterial ? materialNames_[std::size_t(primitive.material)] : ""});
      addPrimitive(primitive, position->second, placement);
    }
  }

  void addPrimitive(const tinygltf::Primitive& primitive, int positions,
                    const Eigen::Affine3d& placement) {
    const std::vector<double>& points = values(positions_, positions);
    const std::size_t count = points.size() / 3;
    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) {
      for (double index : file_.values(primitive.indices, 1)) {
        if (!(index >= 0.0 && index < double(count)))
          refuse(name_, "has a face that refers to vertex " + std::to_string(std::int64_t(index)) +
                            "; its mesh has " + std::to_string(count) + ", counted from 0");
        corners.push_back(std::uint32_t(index));
      }
    } else {
      for (std::size_t v = 0; v < count; ++v) corners.push_back(std::uint32_t(v));
    }
    triangles_ += corners.size() / (primitive.mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1);
    if (triangles_ > mostTriangles)
      refuse(name_, "shows more than " + std::to_string(mostTriangles / 1'000'000) +
                        " million triangles, its instances counted");
    addVertices(primitive, points, corners, placement);
    addFaces(primitive.mode, corners, placement.linear().determinant() < 0.0);
  }

  // The values of an accessor that the primitive before often had, too: many draw parts of one
  // list.
  struct Values {
    int accessor = -1;
    std::vector<double> numbers;  // three for each vertex
  };
  const std::vector<double>& values(Values& last, int accessor) const {
    if (last.accessor != accessor) last = {accessor, file_.values(accessor, 3)};
    return last.numbers;
  }

  // Adds the vertices that the corners refer to, each once and no others, and makes the corners
  // refer to those of the whole mesh.
  void addVertices(const tinygltf::Primitive& primitive, const std::vector<double>& points,
                   std::vector<std::uint32_t>& corners, const Eigen::Affine3d& placement) {
    const auto given = primitive.attributes.find("NORMAL");
    const bool hasNormals = given != primitive.attributes.end();
    const std::vector<double>& normals = hasNormals ? values(normals_, given->second) : points;
    const Eigen::Matrix3d turn = placement.linear().inverse().transpose();
    std::vector<std::uint32_t> places(points.size() / 3, UINT32_MAX);
    for (std::uint32_t& corner : corners) {
      const std::size_t v = 3 * std::size_t(corner);
      std::uint32_t& place = places[corner];
      if (place == UINT32_MAX) {
        place = std::uint32_t(mesh_.positions.size());
        mesh_.positions.push_back(placement * Vector3d(points[v], points[v + 1], points[v + 2]));
        if (hasNormals && v + 2 < normals.size())
          mesh_.setNormal(place, turn * Vector3d(normals[v], normals[v + 1], normals[v + 2]));
      }
      corner = place;
    }
  }

  // A placement that mirrors turns faces round.
  void addFaces(int mode, const std::vector<std::uint32_t>& corners, bool mirrored) {
    const bool isList = mode == TINYGLTF_MODE_TRIANGLES;
    progress_.tell(0.5);  // the file has been taken apart; its buffers are quickly read
    for (std::size_t i = isList ? 0 : 2; isList ? i + 2 < corners.size() : i < corners.size();
         i += isList ? 3 : 1) {
      std::array<std::uint32_t, 3> face{};
      if (isList)
        face = {corners[i], corners[i + 1], corners[i + 2]};
      else if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        face = {corners[0], corners[i - 1], corners[i]};
      else if (i % 2 == 0)
        face = {corners[i - 2], corners[i - 1], corners[i]};
      else
        face = {corners[i - 1], corners[i - 2], corners[i]};
      if (mirrored) std::swap(face[1], face[2]);
      for (std::uint32_t corner : face) mesh_.corners.push_back(corner);
      mesh_.endFace();
    }
  }

  const std::string& name_;
  const Progress progress_;
  const GltfFile file_;
  const tinygltf::Model& model_;
  Values positions_, normals_;
  std::vector<std::string> materialNames_;
  std::vector<bool> isVisited_;  // each node
  std::size_t leftOut_ = 0, triangles_ = 0;
  bool hasMorphs_ = false;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh readGltf(std::string_view content, const std::string& name, const Progress& progress) {
  return GltfReader(content, name, progress).run();
}

}  // namespace umbra::meshfile
