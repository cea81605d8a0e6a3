#include "ui/session/Document.h"

#include <filesystem>

#include "datasets/scenes/SceneCatalogue.h"

namespace umbra {

std::string titleOf(const SceneSource& source) {
  if (source.kind != SourceKind::Catalogue)
    return std::filesystem::path(source.name).filename().string();
  for (const SceneInfo& info : sceneCatalogue())
    if (info.name == source.name) return info.title;
  return source.name;
}

}  // namespace umbra
