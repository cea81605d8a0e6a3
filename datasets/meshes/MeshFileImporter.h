// Takes what an OpenMesh reader finds as plain lists. OpenMesh's own importer builds half-edges,
// which drop or double faces that are not a manifold; real models seldom are one.
#pragma once

#include <Eigen/Core>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <cmath>
#include <cstdint>
#include <vector>

namespace umbra::meshfile {

class Importer : public OpenMesh::IO::BaseImporter {
 public:
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;  // as many as positions, zero for a position without one
  std::vector<std::vector<std::int32_t>> faces;  // indices as they stood in the file
  bool hasNormals = false;
  // A vertex that was given two different normals lies on a crease, which one normal cannot show.
  bool hasCreases = false;

  OpenMesh::VertexHandle add_vertex(const OpenMesh::Vec3f& p) override {
    positions.emplace_back(p[0], p[1], p[2]);
    normals.emplace_back(Eigen::Vector3f::Zero());
    return OpenMesh::VertexHandle(int(positions.size()) - 1);
  }
  OpenMesh::VertexHandle add_vertex() override { return add_vertex(OpenMesh::Vec3f(0, 0, 0)); }
  void set_point(OpenMesh::VertexHandle v, const OpenMesh::Vec3f& p) override {
    if (isVertex(v)) positions[std::size_t(v.idx())] = {p[0], p[1], p[2]};
  }
  void set_normal(OpenMesh::VertexHandle v, const OpenMesh::Vec3f& n) override {
    const Eigen::Vector3f given(n[0], n[1], n[2]);
    if (!isVertex(v) || !given.allFinite() || !(given.norm() > 0.0f)) return;
    Eigen::Vector3f& normal = normals[std::size_t(v.idx())];
    const Eigen::Vector3f unit = given.normalized();
    hasCreases = hasCreases || (hasNormals && normal.norm() > 0.0f && normal.dot(unit) < 0.999f);
    hasNormals = true;
    normal = unit;
  }
  void set_normal(OpenMesh::VertexHandle v, const OpenMesh::Vec3d& n) override {
    set_normal(v, OpenMesh::Vec3f(float(n[0]), float(n[1]), float(n[2])));
  }
  OpenMesh::FaceHandle add_face(const VHandles& corners) override {
    std::vector<std::int32_t>& face = faces.emplace_back();
    for (const OpenMesh::VertexHandle v : corners) face.push_back(v.idx());
    return OpenMesh::FaceHandle(int(faces.size()) - 1);
  }
  std::size_t n_vertices() const override { return positions.size(); }
  std::size_t n_faces() const override { return faces.size(); }
  std::size_t n_edges() const override { return 0; }

  // No picture here needs these.
  using Vertex = OpenMesh::VertexHandle;
  using Half = OpenMesh::HalfedgeHandle;
  using Edge = OpenMesh::EdgeHandle;
  using Face = OpenMesh::FaceHandle;
  using Status = OpenMesh::Attributes::StatusInfo;
  Half add_edge(Vertex, Vertex) override { return Half(); }
  Face add_face(Half) override { return Face(); }
  void add_face_texcoords(Face, Vertex, const std::vector<OpenMesh::Vec2f>&) override {}
  void add_face_texcoords(Face, Vertex, const std::vector<OpenMesh::Vec3f>&) override {}
  void set_face_texindex(Face, int) override {}
  void set_halfedge(Vertex, Half) override {}
  void set_color(Vertex, const OpenMesh::Vec3uc&) override {}
  void set_color(Vertex, const OpenMesh::Vec4uc&) override {}
  void set_color(Vertex, const OpenMesh::Vec3f&) override {}
  void set_color(Vertex, const OpenMesh::Vec4f&) override {}
  void set_color(Edge, const OpenMesh::Vec3uc&) override {}
  void set_color(Edge, const OpenMesh::Vec4uc&) override {}
  void set_color(Edge, const OpenMesh::Vec3f&) override {}
  void set_color(Edge, const OpenMesh::Vec4f&) override {}
  void set_color(Face, const OpenMesh::Vec3uc&) override {}
  void set_color(Face, const OpenMesh::Vec4uc&) override {}
  void set_color(Face, const OpenMesh::Vec3f&) override {}
  void set_color(Face, const OpenMesh::Vec4f&) override {}
  void set_texcoord(Vertex, const OpenMesh::Vec2f&) override {}
  void set_texcoord(Vertex, const OpenMesh::Vec3f&) override {}
  void set_texcoord(Half, const OpenMesh::Vec2f&) override {}
  void set_texcoord(Half, const OpenMesh::Vec3f&) override {}
  void set_status(Vertex, const Status&) override {}
  void set_status(Half, const Status&) override {}
  void set_status(Edge, const Status&) override {}
  void set_status(Face, const Status&) override {}
  void set_next(Half, Half) override {}
  void set_face(Half, Face) override {}
  void request_face_texcoords2D() override {}
  void set_normal(Face, const OpenMesh::Vec3f&) override {}
  void set_normal(Face, const OpenMesh::Vec3d&) override {}
  void add_texture_information(int, std::string) override {}

 private:
  bool isVertex(OpenMesh::VertexHandle v) const {
    return v.idx() >= 0 && std::size_t(v.idx()) < positions.size();
  }
};

}  // namespace umbra::meshfile
