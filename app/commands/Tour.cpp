#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/frames/SceneProbe.h"
#include "app/frames/TechniqueSet.h"
#include "app/options/SceneSources.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "app/reports/ProbeFiles.h"
#include "datasets/session/file/SessionInExr.h"

namespace umbra {
namespace {

constexpr int probeBins = 60;
constexpr int probeSamples = 401;

struct TourCommand {
  explicit TourCommand(OptionParser& command);
  void run() const;

  SessionOptions options;
  std::string folder = "umbrascope-out";
  TechniqueCatalogue catalogue = allTechniques();
};

TourCommand::TourCommand(OptionParser& command) {
  command.add("-o,--output", folder, {"Tour", "DIR", "Folder to write into"});
  command.setFooter(
      "Draws the techniques side by side (hard, pcf, vsm and power-cdf where none are\n"
      "named), probes the pixel where vsm, or else the first bound, bleeds most light, and\n"
      "writes picture, plots and figures.");
  options.addTo(command);
}

void TourCommand::run() const {
  checkWritable(std::filesystem::path(folder) / "picture.png");
  const Session session = options.session(catalogue);
  checkGpuFormat(session);
  const auto chosen = makeTechniques(
      session, catalogue, options.techniques(catalogue, {{"hard", "pcf", "vsm", "power-cdf"}}));
  const std::shared_ptr<Technique> suspect = suspectOf(chosen);
  const auto scene = options.scene(session.source);
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);

  OutputFolder files(folder);
  std::vector<LabelledPicture> pictures;
  for (const auto& technique : chosen) {
    throwIfCancelled();
    frame->render(*technique, session.frame.view);
    pictures.push_back({std::string(technique->info().title), frame->colour()});
  }
  display->writePictures(pictures, files.file("picture.png"),
                         sessionAttributes(Workspace{session}, UMBRA_VERSION));

  const SceneProbe probe = probeScene(*frame, session, chosen, worstBleeding(*frame, *suspect));
  const Json json = sceneProbeToJson(probe, frame->depthMap(), shortNameOf(session.source),
                                     session.frame.read.filter, probeBins, probeSamples);
  writeProbe(files, *display, probe.probe, json, suspect->info().id, probeBins);
  throwIfCancelled();
  files.finish();
  print(probeText(probe.probe));
}

}  // namespace

Command addTour(OptionParser& program) {
  OptionParser command = program.addCommand(
      "tour", "Draw a scene with several techniques and probe where light bleeds most",
      commandsGroup);
  const auto tour = std::make_shared<TourCommand>(command);
  return {command, [tour] { tour->run(); }};
}

}  // namespace umbra
