#include "datasets/meshes/MeshFile.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <fstream>

#include "datasets/meshes/MeshFileReader.h"
#include "datasets/meshes/MeshFileText.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  std::error_code problem;
  if (!fs::is_regular_file(file, problem)) meshfile::refuse(file.string(), "there is no such file");
  std::ifstream stream(file, std::ios::binary);
  std::string content(std::size_t(fs::file_size(file, problem)), '\0');
  stream.read(content.data(), std::streamsize(content.size()));
  if (problem || !stream) meshfile::refuse(file.string(), "cannot be read");
  return content;
}

void say(const fs::path& file, const MeshReport& report) {
  if (report.degenerateFaces + report.nonFiniteFaces == 0) return;
  spdlog::warn("{}: left out {} faces without area and {} with coordinates that are not finite",
               file.string(), report.degenerateFaces, report.nonFiniteFaces);
}

}  // namespace

Mesh readMeshFile(const fs::path& file, MeshReport* report) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  const meshfile::RawMesh raw = meshfile::readMesh(contentOf(file), extension, file.string());
  if (report)
    *report = raw.report;
  else
    say(file, raw.report);
  return meshfile::withItsNormals(raw);
}

}  // namespace umbra
