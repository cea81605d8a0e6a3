#include "app/start/OpenWindow.h"

#include <filesystem>
#include <vector>

#include "app/display/DisplayLibrary.h"
#include "app/options/SceneSources.h"
#include "app/start/WindowSystem.h"
#include "datasets/maps/DepthFile.h"
#include "datasets/maps/Raster.h"
#include "datasets/scenes/SceneCatalogue.h"
#include "datasets/session/DepthReading.h"
#include "datasets/session/file/SessionFile.h"
#include "datasets/session/file/SessionInExr.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

namespace fs = std::filesystem;

namespace {

bool isScene(const std::string& name) {
  for (const SceneInfo& info : sceneCatalogue())
    if (info.name == name) return true;
  return false;
}

// Such a file brings back what it was made of; with a channel's name it is a depth map.
bool isSessionExr(const fs::path& file) {
  return rasterReaderOf(file) == readExr && sessionInExr(file).has_value();
}

}  // namespace

OpenWindow::OpenWindow(OptionParser& program) : program_(program) {
  program.addArgument(
      "SCENE", argument_,
      {.text = "Scene, mesh file, depth map (" + rasterExtensions() + ") or session (.json)"});
  options_.addTo(program);
}

bool OpenWindow::given() const {
  return argument_ || program_.hasOption();
}

void OpenWindow::checkArgument() const {
  if (!argument_ || isScene(*argument_)) return;
  const fs::path file = splitDepthArgument(*argument_).first;
  if (fs::exists(file)) return;
  if (file.has_extension() || file.has_parent_path())
    throw Error(ErrorKind::BadInput, file.string() + ": there is no such file");
  std::vector<std::string> known;
  for (const SceneInfo& info : sceneCatalogue()) known.push_back(info.name);
  for (const std::string& command : program_.commandNames()) known.push_back(command);
  const std::string nearest = nearestWord(*argument_, known);
  throw Error(ErrorKind::BadCommandLine,
              *argument_ + ": is no command, scene or file; " +
                  (nearest.empty()
                       ? "`umbrascope --help` lists the commands, `umbrascope scenes` the scenes"
                       : "did you mean '" + nearest + "'?"));
}

Workspace OpenWindow::opened() const {
  const TechniqueCatalogue catalogue = allTechniques();
  const bool asked = options_.namesFormat() || options_.namesSession();
  if (!argument_) {
    Workspace workspace = options_.workspace(catalogue);
    if (!asked) chooseFormatFor(workspace.shared);
    return workspace;
  }
  checkArgument();
  if (options_.namesSource())
    throw Error(ErrorKind::BadCommandLine,
                *argument_ + ": excludes --scene and --depth, give one of them");
  Workspace workspace;
  SceneSource& source = workspace.shared.source;
  const auto [file, channel] = splitDepthArgument(*argument_);
  if (isScene(*argument_)) {
    source.name = *argument_;
  } else if (file.extension() == ".json" || (channel.empty() && isSessionExr(file))) {
    workspace = readWorkspace(file);
  } else if (rasterReaderOf(file)) {
    source = {};
    source.kind = SourceKind::DepthFile;
    source.name = file.string();
    source.depth.channel = channel;
    chooseFormatFor(workspace.shared);
  } else {
    source = sceneSourceFrom(*argument_, *argument_);
  }
  return options_.over(std::move(workspace), catalogue);
}

int OpenWindow::run(int& argc, char** argv) const {
  const Workspace workspace = opened();
  if (const std::string obstacle = windowObstacle(); !obstacle.empty())
    throw Error(ErrorKind::NoOpenGL, "no display (" + obstacle +
                                         "): the window cannot open; `umbrascope render -o "
                                         "picture.png` draws without one");
  return loadDisplay()->runWindow(argc, argv, workspace);
}

}  // namespace umbra
