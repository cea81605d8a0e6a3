#include "app/frames/SurfaceCompare.h"

#include <spdlog/spdlog.h>

#include "app/frames/RayTracedFrame.h"
#include "app/options/OptionValues.h"
#include "app/output/Cancellation.h"
#include "datasets/meshes/FieldMeshPly.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

std::string surfaceFormatFrom(const std::string& name, std::string_view where) {
  if (name == "vtp" || name == "ply") return name;
  throw Error(ErrorKind::BadCommandLine,
              std::string(where) + ": '" + name + "' is neither vtp nor ply");
}

double surfaceEdgeFrom(const std::string& text, std::string_view where) {
  return numberFrom(text, std::string(where),
                    {SurfaceMeshSettings::shortestEdge, SurfaceMeshSettings::longestEdge});
}

SurfaceCompare::SurfaceCompare(const FrameSettings& settings, const SurfaceOptions& options,
                               bool rayTraced)
    : options_(options), rayTraced_(rayTraced) {
  if (const std::string reason = whyNoSurfaceErrors(settings); !reason.empty())
    throw Error(ErrorKind::BadCommandLine, "--surfaces: " + reason);
}

const SurfaceMesh& SurfaceCompare::meshOn(const FrameSnapshot& frame) {
  if (mesh_) return *mesh_;
  mesh_ = surfaceMeshOf(*frame.scene, frame.cascades.front().frame, frame.maps.front()->width(),
                        options_.mesh, throwIfCancelled);
  if (mesh_->edge > options_.mesh.edge)
    spdlog::warn(
        "--surfaces: edges are up to {} texels long in place of {}, which would add more "
        "than {} faces to the scene's",
        shortNumber(mesh_->edge), shortNumber(options_.mesh.edge), options_.mesh.mostFaces);
  return *mesh_;
}

SurfaceErrors SurfaceCompare::errors(HeadlessFrame& frame) {
  const auto drawn = frame.snapshot();
  if (rayTraced_ && !rays_) rays_ = raysFor(*drawn);
  return surfaceErrors(meshOn(*drawn),
                       {*drawn->scene, drawn->cascades.front().frame, *drawn->maps.front(),
                        drawn->settings, *drawn->technique, rays_.get()},
                       [](double) { throwIfCancelled(); });
}

std::string SurfaceCompare::fileName(const std::string& name) const {
  return "bleeding-" + name + "." + options_.extension;
}

void SurfaceCompare::write(const FieldMesh& mesh, const std::filesystem::path& file,
                           Display& display) const {
  if (options_.extension == "ply")
    writePly(mesh, file);
  else
    display.writeVtp(mesh, file);
}

}  // namespace umbra
