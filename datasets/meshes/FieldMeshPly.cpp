#include "datasets/meshes/FieldMeshPly.h"

#include <OpenMesh/Core/IO/writer/PLYWriter.hh>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "datasets/meshes/MeshFileExporter.h"
#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/ErrorColours.h"

namespace umbra {
namespace meshfile {
namespace {

const MeshField* fieldNamed(const std::vector<MeshField>& fields, std::string_view name) {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [&](const MeshField& field) { return field.name == name; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace

Exporter::Exporter(const FieldMesh& mesh)
    : mesh_(mesh), error_(fieldNamed(mesh.vertexFields, "error")), kernel_(mesh) {}

OpenMesh::Vec3uc Exporter::color(Vertex v) const {
  OpenMesh::Vec3uc colour;
  const ViewColour shown =
      colourOfError(error_ ? double(error_->values[std::size_t(v.idx())]) : 0.0);
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<unsigned char>(std::lround(255.0f * shown[c]));
  return colour;
}

Exporter::Kernel::Kernel(const FieldMesh& mesh) : mesh_(mesh) {
  // Only persistent properties are written.
  for (const MeshField& field : mesh.vertexFields) {
    OpenMesh::VPropHandleT<float> handle;
    add_property(handle, field.name);
    property(handle).set_persistent(true);
    property(handle).data_vector() = field.values;
  }
  // MeshLab colours by what is called so.
  if (const MeshField* error = fieldNamed(mesh.vertexFields, "error")) {
    OpenMesh::VPropHandleT<float> handle;
    add_property(handle, "quality");
    property(handle).set_persistent(true);
    property(handle).data_vector() = error->values;
  }
  for (const MeshField& field : mesh.faceFields) {
    OpenMesh::FPropHandleT<float> handle;
    add_property(handle, field.name);
    property(handle).set_persistent(true);
    property(handle).data_vector() = field.values;
  }
  OpenMesh::FPropHandleT<int> objects;
  add_property(objects, "object");
  property(objects).set_persistent(true);
  property(objects).data_vector().assign(mesh.objects.begin(), mesh.objects.end());
}

}  // namespace meshfile

void writePly(const FieldMesh& mesh, const std::filesystem::path& file) {
  writeAtomically(file, [&](const std::filesystem::path& temporary) {
    meshfile::Exporter exporter(mesh);
    std::ofstream stream(temporary, std::ios::binary);
    int options = OpenMesh::IO::Options::Binary | OpenMesh::IO::Options::VertexNormal;
    if (exporter.has_vertex_colors()) options |= OpenMesh::IO::Options::VertexColor;
    const bool written = OpenMesh::IO::PLYWriter().write(stream, exporter, options);
    stream.close();
    if (!written || !stream) throw std::runtime_error("there may be no room for it");
  });
}

}  // namespace umbra
