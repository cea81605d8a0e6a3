#include "ui/Document.h"

#include <filesystem>

#include "datasets/DepthFile.h"
#include "datasets/MeshFile.h"
#include "datasets/SceneCatalogue.h"
#include "filters/core/Error.h"

namespace umbra {

Content loadContent(const SceneSource& source) {
  Content content;
  switch (source.kind) {
    case SourceKind::Catalogue:
      content.scene = std::make_shared<const Scene>(makeScene(source.name, source.parameters));
      break;
    case SourceKind::MeshFile:
      content.scene = std::make_shared<const Scene>(sceneFromMeshFile(source.name));
      break;
    case SourceKind::DepthFile:
      content.depth = std::make_shared<const DepthMap>(
          readDepthFile(source.name, source.channel, source.depthNear, source.depthFar));
      break;
  }
  if (content.scene && content.scene->triangleCount() == 0)
    throw Error(ErrorKind::BadInput, source.name + ": there is no triangle to draw");
  return content;
}

std::string titleOf(const SceneSource& source) {
  if (source.kind != SourceKind::Catalogue)
    return std::filesystem::path(source.name).filename().string();
  for (const SceneInfo& info : sceneCatalogue())
    if (info.name == source.name) return info.title;
  return source.name;
}

}  // namespace umbra
