// Gives plain lists to an OpenMesh writer. OpenMesh's own exporter needs half-edges, which drop
// faces that are not a manifold.
#pragma once

#include <OpenMesh/Core/IO/exporter/BaseExporter.hh>

#include "filters/core/scene/FieldMesh.h"

namespace umbra::meshfile {

class Exporter : public OpenMesh::IO::BaseExporter {
 public:
  // `mesh` must outlive it.
  explicit Exporter(const FieldMesh& mesh);

  using Vertex = OpenMesh::VertexHandle;
  using Half = OpenMesh::HalfedgeHandle;
  using Edge = OpenMesh::EdgeHandle;
  using Face = OpenMesh::FaceHandle;
  using Status = OpenMesh::Attributes::StatusInfo;

  OpenMesh::Vec3f point(Vertex v) const override { return of(mesh_.positions, v); }
  OpenMesh::Vec3f normal(Vertex v) const override { return of(mesh_.normals, v); }
  unsigned get_vhandles(Face f, std::vector<Vertex>& corners) const override {
    corners.clear();
    for (std::uint32_t corner : mesh_.triangles[std::size_t(f.idx())])
      corners.emplace_back(int(corner));
    return 3;
  }
  // Writers find the fields here.
  const OpenMesh::BaseKernel* kernel() override { return &kernel_; }
  std::size_t n_vertices() const override { return mesh_.positions.size(); }
  std::size_t n_faces() const override { return mesh_.triangles.size(); }
  std::size_t n_edges() const override { return 0; }
  bool is_triangle_mesh() const override { return true; }
  bool has_vertex_normals() const override { return true; }

  // No file here holds these.
  OpenMesh::Vec3d pointd(Vertex) const override { return zero<OpenMesh::Vec3d>(); }
  bool is_point_double() const override { return false; }
  OpenMesh::Vec3d normald(Vertex) const override { return zero<OpenMesh::Vec3d>(); }
  bool is_normal_double() const override { return false; }
  // The colour of the error there, so that viewers show it at once.
  bool has_vertex_colors() const override { return error_ != nullptr; }
  OpenMesh::Vec3uc color(Vertex v) const override;
  OpenMesh::Vec4uc colorA(Vertex) const override { return zero<OpenMesh::Vec4uc>(); }
  OpenMesh::Vec3ui colori(Vertex) const override { return zero<OpenMesh::Vec3ui>(); }
  OpenMesh::Vec4ui colorAi(Vertex) const override { return zero<OpenMesh::Vec4ui>(); }
  OpenMesh::Vec3f colorf(Vertex) const override { return zero<OpenMesh::Vec3f>(); }
  OpenMesh::Vec4f colorAf(Vertex) const override { return zero<OpenMesh::Vec4f>(); }
  OpenMesh::Vec2f texcoord(Vertex) const override { return zero<OpenMesh::Vec2f>(); }
  OpenMesh::Vec2f texcoord(Half) const override { return zero<OpenMesh::Vec2f>(); }
  Status status(Vertex) const override { return {}; }
  Half getHeh(Face, Vertex) const override { return Half(); }
  unsigned get_face_texcoords(std::vector<OpenMesh::Vec2f>&) const override { return 0; }
  OpenMesh::Vec3f normal(Face) const override { return zero<OpenMesh::Vec3f>(); }
  OpenMesh::Vec3d normald(Face) const override { return zero<OpenMesh::Vec3d>(); }
  OpenMesh::Vec3uc color(Face) const override { return zero<OpenMesh::Vec3uc>(); }
  OpenMesh::Vec4uc colorA(Face) const override { return zero<OpenMesh::Vec4uc>(); }
  OpenMesh::Vec3ui colori(Face) const override { return zero<OpenMesh::Vec3ui>(); }
  OpenMesh::Vec4ui colorAi(Face) const override { return zero<OpenMesh::Vec4ui>(); }
  OpenMesh::Vec3f colorf(Face) const override { return zero<OpenMesh::Vec3f>(); }
  OpenMesh::Vec4f colorAf(Face) const override { return zero<OpenMesh::Vec4f>(); }
  Status status(Face) const override { return {}; }
  Status status(Edge) const override { return {}; }
  OpenMesh::Vec3uc color(Edge) const override { return zero<OpenMesh::Vec3uc>(); }
  OpenMesh::Vec4uc colorA(Edge) const override { return zero<OpenMesh::Vec4uc>(); }
  OpenMesh::Vec3ui colori(Edge) const override { return zero<OpenMesh::Vec3ui>(); }
  OpenMesh::Vec4ui colorAi(Edge) const override { return zero<OpenMesh::Vec4ui>(); }
  OpenMesh::Vec3f colorf(Edge) const override { return zero<OpenMesh::Vec3f>(); }
  OpenMesh::Vec4f colorAf(Edge) const override { return zero<OpenMesh::Vec4f>(); }
  int get_halfedge_id(Vertex) override { return -1; }
  int get_halfedge_id(Face) override { return -1; }
  int get_next_halfedge_id(Half) override { return -1; }
  int get_to_vertex_id(Half) override { return -1; }
  int get_face_id(Half) override { return -1; }
  Status status(Half) const override { return {}; }

 private:
  // Property lists can only be filled by a mesh's kernel.
  class Kernel : public OpenMesh::BaseKernel {
   public:
    explicit Kernel(const FieldMesh& mesh);
    // Every list is made as long as these.
    std::size_t n_vertices() const override { return mesh_.positions.size(); }
    std::size_t n_faces() const override { return mesh_.triangles.size(); }

   private:
    const FieldMesh& mesh_;
  };

  template <class Vector>
  static Vector zero() {
    return Vector::vectorized(0);
  }
  static OpenMesh::Vec3f of(const std::vector<Eigen::Vector3f>& vectors, Vertex v) {
    const Eigen::Vector3f& vector = vectors[std::size_t(v.idx())];
    return {vector.x(), vector.y(), vector.z()};
  }

  const FieldMesh& mesh_;
  const MeshField* error_;  // null where the mesh has none
  Kernel kernel_;
};

}  // namespace umbra::meshfile
