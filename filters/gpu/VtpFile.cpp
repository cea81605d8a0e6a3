#include "filters/gpu/VtpFile.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cstring>

#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

vtkNew<vtkFloatArray> newArray(const std::vector<Eigen::Vector3f>& vectors) {
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(vtkIdType(vectors.size()));
  if (!vectors.empty())
    std::memcpy(array->GetPointer(0), vectors.data(), vectors.size() * sizeof(Eigen::Vector3f));
  return array;
}

void addFields(vtkDataSetAttributes& data, const std::vector<MeshField>& fields) {
  for (const MeshField& field : fields) {
    vtkNew<vtkFloatArray> array;
    array->SetName(field.name.c_str());
    array->SetNumberOfTuples(vtkIdType(field.values.size()));
    std::copy(field.values.begin(), field.values.end(), array->GetPointer(0));
    data.AddArray(array);
  }
  data.SetActiveScalars("bleeding");
}

void addObjects(vtkPolyData& data, const FieldMesh& mesh) {
  vtkNew<vtkIntArray> objects;
  objects->SetName("object");
  objects->SetNumberOfTuples(vtkIdType(mesh.objects.size()));
  std::copy(mesh.objects.begin(), mesh.objects.end(), objects->GetPointer(0));
  data.GetCellData()->AddArray(objects);
  vtkNew<vtkStringArray> names;
  names->SetName("objects");
  for (const std::string& name : mesh.objectNames) names->InsertNextValue(name);
  data.GetFieldData()->AddArray(names);
}

vtkNew<vtkPolyData> toPolyData(const FieldMesh& mesh) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetData(newArray(mesh.positions));
  data->SetPoints(points);
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfTuples(vtkIdType(3 * mesh.triangles.size()));
  vtkIdType* corner = corners->GetPointer(0);
  for (const auto& triangle : mesh.triangles)
    corner = std::copy(triangle.begin(), triangle.end(), corner);
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, corners);
  data->SetPolys(cells);
  const auto normals = newArray(mesh.normals);
  normals->SetName("Normals");
  data->GetPointData()->SetNormals(normals);
  addFields(*data->GetPointData(), mesh.vertexFields);
  addFields(*data->GetCellData(), mesh.faceFields);
  addObjects(*data, mesh);
  return data;
}

}  // namespace

void writeVtp(const FieldMesh& mesh, const std::filesystem::path& file) {
  const auto data = toPolyData(mesh);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  // Into memory first: a full disk is then told as for every other file.
  writer->WriteToOutputStringOn();
  if (!writer->Write())
    throw Error(ErrorKind::BadOutput, file.string() + ": the mesh cannot be encoded as VTP");
  writeTextAtomically(file, writer->GetOutputString());
}

}  // namespace umbra
