// Real models as scenes, read from a package of models where it is installed: Debian's
// sweethome3d-furniture, whose "Blend Swap CC-0" collection is in the public domain (CC0).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/scenes/SceneCatalogue.h"

namespace umbra {

// The folder where the package puts its collections.
std::filesystem::path installedModelsFolder();

// The entries are always the same; `missing` names the package to install where `folder` lacks it.
std::vector<SceneInfo> installedModelInfos(
    const std::filesystem::path& folder = installedModelsFolder());

bool isInstalledModel(const std::string& name);

// The model with a light and a camera that make its shadows overlap; it has an object for each
// material, in the model's colours. Throws BadInput: there is no such model, which package to
// install, or what is wrong with the collection.
Scene makeInstalledModel(const std::string& name,
                         const std::filesystem::path& folder = installedModelsFolder());

}  // namespace umbra
