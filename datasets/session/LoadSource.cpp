#include "datasets/session/LoadSource.h"

#include "datasets/scenes/MeshScene.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

Scene readScene(const SceneSource& source, std::vector<std::string>& notices,
                const Progress& progress) {
  if (source.kind == SourceKind::Catalogue) return makeScene(source.name, source.parameters);
  MeshReport report;
  Scene scene = sceneFromMeshFile(source.name, source.up, &report, progress);
  if (const std::string doubts = report.summary(); !doubts.empty())
    notices.push_back(source.name + ": " + doubts);
  return scene;
}

}  // namespace

Pixel texelInFile(const Content& content, const Pixel& texel) {
  if (!content.depthFile) return texel;
  return {texel.x + content.depthFile->originX, texel.y + content.depthFile->originY};
}

DepthFile loadDepth(const SceneSource& source) {
  DepthFile file = readDepth(source.name, source.depth);
  for (std::string& note : file.notes) note = source.name + ": " + note;
  return file;
}

Content loadSource(const SceneSource& source, const Progress& progress) {
  Content content;
  if (source.kind == SourceKind::DepthFile) {
    content.depthFile = std::make_shared<const DepthFile>(loadDepth(source));
    content.depth = {content.depthFile, &content.depthFile->map};
    content.notices = content.depthFile->notes;
    return content;
  }
  content.scene = std::make_shared<const Scene>(readScene(source, content.notices, progress));
  if (content.scene->triangleCount() == 0)
    throw Error(ErrorKind::BadInput, source.name + ": there is no triangle to draw");
  return content;
}

}  // namespace umbra
