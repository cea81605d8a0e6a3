#include "datasets/meshes/MeshFile.h"

#include <spdlog/spdlog.h>

#include "datasets/meshes/MeshFileReader.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

std::string MeshReport::summary() const {
  std::string text;
  const auto add = [&](const std::string& clause) { text += (text.empty() ? "" : "; ") + clause; };
  const auto count = [&](std::size_t faces, const char* what, const char* done) {
    if (faces > 0)
      add(std::to_string(faces) + (faces == 1 ? " face " : " faces ") + what +
          (faces == 1 ? " was " : " were ") + done);
  };
  count(degenerateFaces, "without area", "left out");
  count(shortFaces, "of fewer than three vertices", "left out");
  count(nonFiniteFaces, "with coordinates that are not finite", "left out");
  count(crossedFaces, "with bends or edges that cross", "cut into triangles that may be wrong");
  count(longFaces, "of very many corners", "cut into triangles that may be wrong");
  for (const std::string& note : notes) add(note);
  return text;
}

std::string nameOf(UpAxis up) {
  return up == UpAxis::Z ? "z" : "y";
}

UpAxis upAxisFrom(std::string_view name, std::string_view where) {
  for (UpAxis up : {UpAxis::Y, UpAxis::Z})
    if (name == nameOf(up)) return up;
  throw Error(ErrorKind::BadInput, std::string(where) + ": '" + clipped(name) +
                                       "' is no axis that points up; y or z is");
}

Mesh readMeshFile(const std::filesystem::path& file, MeshReport* report) {
  const meshfile::RawMesh raw = meshfile::readRawMesh(file);
  if (report)
    *report = raw.report;
  else if (const std::string doubts = raw.report.summary(); !doubts.empty())
    spdlog::warn("{}: {}", file.string(), doubts);
  return meshfile::placedMesh(raw, raw.triangles, Eigen::Affine3d::Identity());
}

}  // namespace umbra
