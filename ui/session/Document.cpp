#include "ui/session/Document.h"

#include <filesystem>

#include "datasets/scenes/SceneCatalogue.h"

namespace umbra {

QPoint originOf(const Content& content) {
  const Pixel first = texelInFile(content, {});
  return {first.x, first.y};
}

std::string titleOf(const SceneSource& source) {
  if (source.kind != SourceKind::Catalogue)
    return std::filesystem::path(source.name).filename().string();
  for (const SceneInfo& info : sceneCatalogue())
    if (info.name == source.name) return info.title;
  return source.name;
}

}  // namespace umbra
