// Real models as scenes, read from a package of models where it is installed: Debian's
// sweethome3d-furniture, whose "Blend Swap CC-0" collection is in the public domain (CC0).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/scenes/SceneCatalogue.h"

namespace umbra {

// Where the package puts its collections.
std::filesystem::path installedModelsFolder();

// Always the same entries; `missing` says which package to install where `folder` lacks it.
std::vector<SceneInfo> installedModelInfos(
    const std::filesystem::path& folder = installedModelsFolder());

bool isInstalledModel(const std::string& name);

// With light and camera so that its shadows overlap; objects by material, in the model's colours.
// Throws BadInput: no such model, the package to install, or what is wrong with the collection.
Scene makeInstalledModel(const std::string& name,
                         const std::filesystem::path& folder = installedModelsFolder());

}  // namespace umbra
