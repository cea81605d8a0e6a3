#include "datasets/meshes/FieldMeshPly.h"

#include <OpenMesh/Core/IO/writer/PLYWriter.hh>
#include <fstream>
#include <stdexcept>

#include "datasets/meshes/MeshFileExporter.h"
#include "filters/core/support/AtomicFile.h"

namespace umbra {
namespace meshfile {

Exporter::Exporter(const FieldMesh& mesh) : mesh_(mesh), kernel_(mesh) {}

Exporter::Kernel::Kernel(const FieldMesh& mesh) : mesh_(mesh) {
  // Only persistent properties are written.
  for (const MeshField& field : mesh.vertexFields) {
    OpenMesh::VPropHandleT<float> handle;
    add_property(handle, field.name);
    property(handle).set_persistent(true);
    property(handle).data_vector() = field.values;
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
    const int options = OpenMesh::IO::Options::Binary | OpenMesh::IO::Options::VertexNormal;
    const bool written = OpenMesh::IO::PLYWriter().write(stream, exporter, options);
    stream.close();
    if (!written || !stream) throw std::runtime_error("there may be no room for it");
  });
}

}  // namespace umbra
