// Halves the edges of a surface mesh until they are short on the map.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "analysis/surfaces/SurfaceMesh.h"

namespace umbra {

class SurfaceDivider {
 public:
  // Divides `mesh`, which must outlive it.
  SurfaceDivider(SurfaceMesh& mesh, const LightFrame& light, int mapSize);

  // The longest edge, in texels, of the faces on the map that are turned to the light; 0 where
  // there are none.
  double longestEdge() const;

  // Divides until no edge on the map is longer than `edge` texels. Returns false, and leaves the
  // mesh as it is, where that takes more than `most` faces.
  bool divide(double edge, std::size_t most, const std::function<void()>& check);

 private:
  using Corners = std::array<std::uint32_t, 3>;
  static constexpr std::uint32_t none = UINT32_MAX;

  struct Edge {
    std::uint32_t first = 0;           // one of its ends
    float length = 0.0f;               // on the map, texels
    std::uint32_t middle = none;       // the position that halves it
    std::uint32_t halves[2] = {0, 0};  // the edges at the first end and at the other one
    bool marked = false;               // to be halved
  };

  void numberEdges();
  std::uint32_t addEdge(std::uint32_t from, std::uint32_t to);
  double lengthOf(std::uint32_t from, std::uint32_t to) const;
  void addClip(const Eigen::Vector3f& position);
  double nearestW() const;
  bool mayLieOnMap(const SurfaceFace& face) const;
  bool mayFaceLight(const SurfaceFace& face) const;
  std::uint32_t longestOnMap(const Corners& edges) const;
  int longestInWorld(const Corners& corners) const;
  bool markEdges(double edge);
  std::size_t facesAfterwards() const;
  void halve(std::uint32_t edge, std::uint32_t from, std::uint32_t to);
  std::uint32_t halfAt(std::uint32_t edge, std::uint32_t end) const;
  void splitFaces();
  void split(const SurfaceFace& face, Corners edges);
  void add(const SurfaceFace& parent, const Corners& corners, const Corners& edges);

  SurfaceMesh& mesh_;
  const LightFrame& light_;
  Eigen::Matrix4d toClip_;
  double size_;
  std::vector<Eigen::Vector4d> clip_;  // one for each position
  std::vector<Edge> edges_;
  std::vector<Corners> edgesOf_;  // for each face, the edges from corner i to the next
};

}  // namespace umbra
