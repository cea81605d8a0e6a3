#include "datasets/meshes/MeshFile.h"

#include <spdlog/spdlog.h>

#include <algorithm>

#include "datasets/meshes/MeshFileReader.h"
#include "datasets/meshes/MeshFileText.h"
#include "filters/core/support/InputFile.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

void say(const fs::path& file, const MeshReport& report) {
  if (report.degenerateFaces + report.nonFiniteFaces == 0) return;
  spdlog::warn("{}: left out {} faces without area and {} with coordinates that are not finite",
               file.string(), report.degenerateFaces, report.nonFiniteFaces);
}

}  // namespace

Mesh readMeshFile(const fs::path& file, MeshReport* report) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  const meshfile::RawMesh raw =
      meshfile::readMesh(contentOf(file, largestMesh), extension, file.string());
  if (report)
    *report = raw.report;
  else
    say(file, raw.report);
  return meshfile::withItsNormals(raw);
}

}  // namespace umbra
