#include "analysis/surfaces/SurfaceErrors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>

#include "analysis/frame/ManyReads.h"
#include "filters/core/maps/ReceiverBias.h"
#include "filters/core/technique/VisibleError.h"

namespace umbra {
namespace {

using Eigen::Vector3d;

// Three points inside a triangle, each with a third of its area, by these weights of its corners.
constexpr int pointsOfFace = 3;
constexpr double nearCorner = 2.0 / 3.0, otherCorners = 1.0 / 6.0;

enum class Receives { Yes, FacesAway, OffMap };

// All reads: one for each vertex that receives shadow, then those of the faces' points that do.
struct Reads {
  std::vector<MapRead> reads;
  std::vector<Receives> vertices, points;
};

Vector3d cornerOf(const SurfaceMesh& mesh, const SurfaceFace& face, int i) {
  return mesh.positions[face.corners[i]].cast<double>();
}

Vector3d pointOf(const SurfaceMesh& mesh, const SurfaceFace& face, int point) {
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    sum += (i == point ? nearCorner : otherCorners) * cornerOf(mesh, face, i);
  return sum;
}

// The face's normal; its length is twice the area.
Vector3d normalOf(const SurfaceMesh& mesh, const SurfaceFace& face) {
  const Vector3d a = cornerOf(mesh, face, 0);
  return (cornerOf(mesh, face, 1) - a).cross(cornerOf(mesh, face, 2) - a);
}

class ReadGatherer {
 public:
  explicit ReadGatherer(const SurfaceSubject& subject)
      : light_(subject.light), bias_(subject.light, subject.frame) {}

  Receives add(const Vector3d& world, const Vector3d& normal, bool twoSided,
               std::vector<MapRead>& reads) const {
    const double cosine = cosineToLight(light_, world, normal);
    if ((twoSided ? std::abs(cosine) : cosine) < edgeOnCosine) return Receives::FacesAway;
    const LightPoint point = light_.project(world);
    if (!point.inside) return Receives::OffMap;
    reads.push_back({point.u, point.v, bias_.receiver(world, normal)});
    return Receives::Yes;
  }

 private:
  const LightFrame& light_;
  ReceiverBias bias_;
};

Reads gather(const SurfaceMesh& mesh, const SurfaceSubject& subject) {
  const ReadGatherer gatherer(subject);
  Reads result;
  result.reads.reserve(mesh.positions.size() + pointsOfFace * mesh.faces.size());
  std::vector<bool> twoSided(mesh.positions.size(), false);
  for (const SurfaceFace& face : mesh.faces)
    for (std::uint32_t corner : face.corners)
      if (face.twoSided) twoSided[corner] = true;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    result.vertices.push_back(gatherer.add(mesh.positions[i].cast<double>(),
                                           mesh.normals[i].cast<double>(), twoSided[i],
                                           result.reads));
  for (const SurfaceFace& face : mesh.faces) {
    const Vector3d normal = normalOf(mesh, face);
    for (int i = 0; i < pointsOfFace; ++i)
      result.points.push_back(
          gatherer.add(pointOf(mesh, face, i), normal, face.twoSided, result.reads));
  }
  return result;
}

std::vector<MeshField> fieldsOf(std::initializer_list<const char*> names, std::size_t size) {
  std::vector<MeshField> fields;
  for (const char* name : names) fields.push_back({name, std::vector<float>(size, 0.0f)});
  return fields;
}

FieldMesh fieldMeshOf(const SurfaceMesh& mesh, const Scene& scene) {
  FieldMesh result{mesh.positions, mesh.normals, {}, {}, {}, {}, {}};
  for (const SurfaceFace& face : mesh.faces) {
    result.triangles.push_back(face.corners);
    result.objects.push_back(face.object);
  }
  for (const SceneObject& object : scene.objects) result.objectNames.push_back(object.name);
  return result;
}

// Returns how many of the results belong to vertices.
std::size_t writeVertices(FieldMesh& mesh, const std::vector<Receives>& vertices,
                          const std::vector<ReadVisibility>& results) {
  const std::size_t count = vertices.size();
  mesh.vertexFields = fieldsOf({"visibility", "reference", "error", "bleeding", "receives"}, count);
  const auto at = [&](std::size_t field) -> MeshField& { return mesh.vertexFields[field]; };
  MeshField &visibility = at(0), &reference = at(1), &error = at(2), &bleeding = at(3),
            &receives = at(4);
  std::size_t next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (vertices[i] == Receives::OffMap) visibility.values[i] = reference.values[i] = 1.0f;
    if (vertices[i] != Receives::Yes) continue;
    const auto [seen, truth] = results[next++];
    visibility.values[i] = float(seen);
    reference.values[i] = float(truth);
    error.values[i] = float(seen - truth);
    bleeding.values[i] = float(std::max(seen - truth, 0.0));
    receives.values[i] = 1.0f;
  }
  return next;
}

// Sums over the points of one face; each point has a third of its area.
struct FaceSums {
  double error = 0.0, bleeding = 0.0, shadowed = 0.0;  // sums over points
  int receiving = 0, bleedingPoints = 0;
  WorstPlace worst;
};

void addTo(SurfaceSums& sums, const FaceSums& face, double area) {
  const double share = area / pointsOfFace;
  ++sums.faces;
  sums.area += share * face.receiving;
  sums.shadowedArea += share * face.shadowed;
  sums.bleedingArea += share * face.bleedingPoints;
  sums.meanBleeding += share * face.bleeding;  // an integral until all faces are added
  if (face.worst.error >= visibleError && (!sums.worst || face.worst.error > sums.worst->error))
    sums.worst = face.worst;
}

void finish(SurfaceSums& sums) {
  if (sums.area > 0.0) sums.meanBleeding /= sums.area;
}

// Writes the results of the faces and adds them up.
class FaceWriter {
 public:
  FaceWriter(const SurfaceMesh& mesh, SurfaceErrors& errors) : mesh_(mesh), errors_(errors) {
    errors.mesh.faceFields = fieldsOf({"error", "bleeding", "receives", "area"}, mesh.faces.size());
    for (const std::string& name : errors.mesh.objectNames) {
      errors.summary.objects.emplace_back();
      errors.summary.objects.back().name = name;
    }
  }

  void write(std::size_t number, const FaceSums& sums) {
    const SurfaceFace& face = mesh_.faces[number];
    const double area = 0.5 * normalOf(mesh_, face).norm();
    std::vector<MeshField>& fields = errors_.mesh.faceFields;
    fields[0].values[number] = float(sums.error / pointsOfFace);
    fields[1].values[number] = float(sums.bleeding / pointsOfFace);
    fields[2].values[number] = float(sums.receiving) / pointsOfFace;
    fields[3].values[number] = float(area);
    addTo(errors_.summary.objects[face.object], sums, area);
    addTo(errors_.summary.all, sums, area);
  }

 private:
  const SurfaceMesh& mesh_;
  SurfaceErrors& errors_;
};

void writeFaces(SurfaceErrors& errors, const SurfaceMesh& mesh, const std::vector<Receives>& points,
                std::span<const ReadVisibility> results) {
  FaceWriter writer(mesh, errors);
  std::size_t next = 0;
  for (std::size_t number = 0; number < mesh.faces.size(); ++number) {
    FaceSums sums;
    for (int i = 0; i < pointsOfFace; ++i) {
      if (points[pointsOfFace * number + i] != Receives::Yes) continue;
      const auto [visibility, reference] = results[next++];
      const double error = visibility - reference;
      ++sums.receiving;
      sums.error += error;
      sums.bleeding += std::max(error, 0.0);
      sums.shadowed += 1.0 - reference;
      sums.bleedingPoints += error >= visibleError;
      if (error > sums.worst.error) sums.worst = {pointOf(mesh, mesh.faces[number], i), error};
    }
    writer.write(number, sums);
  }
}

}  // namespace

std::string whyNoSurfaceErrors(const FrameSettings& frame) {
  if (frame.map.cascades.count > 1)
    return "cascades follow the camera, and a surface has none; take one map";
  const ReadFilter filter = frame.read.filter;
  if (filter == ReadFilter::Trilinear || filter == ReadFilter::Anisotropic)
    return "filter " + std::string(nameOf(filter)) +
           " reads as much as a pixel covers, and a surface has no pixels; take bilinear, point, "
           "or sat with sat-size fixed";
  if (filter == ReadFilter::SummedArea && frame.read.satSize != SatSize::Fixed)
    return "sat-size " + std::string(nameOf(frame.read.satSize)) +
           " follows the camera, and a surface has none; take fixed";
  return {};
}

SurfaceErrors surfaceErrors(const SurfaceMesh& mesh, const SurfaceSubject& subject,
                            const std::function<void(double)>& progress) {
  progress(0.0);
  const Reads reads = gather(mesh, subject);
  const FrameSettings& frame = subject.frame;
  ReadSubject read{subject.map, subject.technique, frame.kernel, frame.read.filter,
                   frame.map.format};
  if (subject.rays) read.truth = std::cref(*subject.rays);
  const std::vector<ReadVisibility> results = evaluateReads(read, reads.reads, progress);
  SurfaceErrors errors{fieldMeshOf(mesh, subject.scene), {}};
  errors.summary.edge = mesh.edge;
  const std::size_t vertices = writeVertices(errors.mesh, reads.vertices, results);
  writeFaces(errors, mesh, reads.points,
             std::span<const ReadVisibility>(results).subspan(vertices));
  for (SurfaceSums& sums : errors.summary.objects) finish(sums);
  finish(errors.summary.all);
  progress(1.0);
  return errors;
}

}  // namespace umbra
