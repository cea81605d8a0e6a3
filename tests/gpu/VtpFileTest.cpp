// Meshes with values, read back by VTK's own reader.
#include "filters/gpu/VtpFile.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <fstream>

#include "datasets/meshes/FieldMeshSample.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class VtpFile : public testing::Test {
 protected:
  static void expectField(vtkDataSetAttributes* data, const MeshField& field) {
    vtkDataArray* array = data->GetArray(field.name.c_str());
    ASSERT_TRUE(array) << field.name;
    ASSERT_EQ(array->GetNumberOfTuples(), vtkIdType(field.values.size()));
    EXPECT_EQ(array->GetDataType(), VTK_FLOAT);
    for (std::size_t i = 0; i < field.values.size(); ++i)
      EXPECT_EQ(array->GetTuple1(vtkIdType(i)), double(field.values[i])) << field.name;
  }

  const TemporaryFolder temporary;
  const fs::path& folder = temporary.path();
  const fs::path file = folder / "mesh.vtp";
  FieldMesh mesh = sampleFieldMesh();
};

TEST_F(VtpFile, IsReadBackWhole) {
  writeVtp(mesh, file);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfPoints(), 4);
  ASSERT_EQ(read->GetNumberOfPolys(), 2);
  for (vtkIdType i = 0; i < 4; ++i)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(read->GetPoint(i)[c], double(mesh.positions[std::size_t(i)][c]));
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < 2; ++i) {
    read->GetCellPoints(i, corners);
    ASSERT_EQ(corners->GetNumberOfIds(), 3);
    for (vtkIdType c = 0; c < 3; ++c)
      EXPECT_EQ(corners->GetId(c), vtkIdType(mesh.triangles[std::size_t(i)][std::size_t(c)]));
  }
  for (const MeshField& field : mesh.vertexFields) expectField(read->GetPointData(), field);
  for (const MeshField& field : mesh.faceFields) expectField(read->GetCellData(), field);
  expectField(read->GetPointData(), {"bleeding", {0.5f, 0, 0, 1}});
  EXPECT_EQ(std::string(read->GetPointData()->GetScalars()->GetName()), "bleeding");
  EXPECT_EQ(read->GetCellData()->GetArray("object")->GetTuple1(1), 2.0);
  auto* names = vtkStringArray::SafeDownCast(read->GetFieldData()->GetAbstractArray("objects"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->GetValue(2), "tree");
}

TEST_F(VtpFile, WhatCannotBeWrittenLeavesWhatWasThere) {
  writeVtp(mesh, file);
  const auto size = fs::file_size(file);
  EXPECT_THROW(writeVtp(mesh, file / "inside-a-file.vtp"), Error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
  EXPECT_EQ(fs::file_size(file), size);
}

}  // namespace
}  // namespace umbra
