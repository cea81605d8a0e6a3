#include <memory>
#include <optional>

#include "app/Cancellation.h"
#include "app/FrameLayers.h"
#include "app/Output.h"
#include "app/SceneSources.h"
#include "app/TechniqueSet.h"
#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/options/SessionOptions.h"
#include "filters/core/Error.h"

namespace umbra {
namespace {

struct RenderCommand {
  explicit RenderCommand(CLI::App& command);

  void run() const;
  void renderPicture(const Session& session) const;
  void renderLayers(const Session& session) const;

  SessionOptions options;
  std::optional<std::string> output;
  TechniqueCatalogue catalogue = allTechniques();
  std::vector<std::shared_ptr<Technique>> techniques(const Session& session) const;
};

RenderCommand::RenderCommand(CLI::App& command) {
  command.add_option("-o,--output", output, "Picture, or its layers as floats")
      ->type_name("FILE.png|FILE.exr")
      ->group("Render");
  command.footer(
      "Several techniques are drawn side by side in a PNG. An EXR has R, G, B of the first, per\n"
      "pixel u, v (in the map; u < 0 without a surface), receiver (negative where the surface "
      "faces\n"
      "away from the light) and reference, and TECHNIQUE.R .G .B .visibility .error for each.");
  options.addTo(command);
}

std::vector<std::shared_ptr<Technique>> RenderCommand::techniques(const Session& session) const {
  return makeTechniques(session, catalogue, options.techniques(catalogue, {{session.technique}}));
}

void RenderCommand::run() const {
  if (!output)
    throw Error(ErrorKind::BadCommandLine, "--output: is missing, give -o FILE.png or FILE.exr");
  const std::string extension = std::filesystem::path(*output).extension().string();
  if (extension != ".png" && extension != ".exr")
    throw Error(ErrorKind::BadCommandLine,
                "--output: '" + *output + "' is not right, it takes FILE.png or FILE.exr");
  checkWritable(*output);
  const Session session = options.session(catalogue);
  checkGpuFormat(session);
  if (extension == ".png")
    renderPicture(session);
  else
    renderLayers(session);
  announce(*output);
}

void RenderCommand::renderPicture(const Session& session) const {
  const auto chosen = techniques(session);
  const auto scene = std::make_shared<const Scene>(loadScene(session.source));
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  std::vector<LabelledPicture> pictures;
  for (const auto& technique : chosen) {
    throwIfCancelled();
    frame->render(*technique, session.frame.view);
    pictures.push_back({std::string(technique->info().title), frame->colour()});
  }
  throwIfCancelled();
  display->writePictures(pictures, *output);
}

void RenderCommand::renderLayers(const Session& session) const {
  const auto chosen = techniques(session);
  const auto scene = std::make_shared<const Scene>(loadScene(session.source));
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  FrameLayers layers(session);
  for (const auto& technique : chosen) {
    throwIfCancelled();
    frame->render(*technique, session.frame.view);
    layers.add(*technique, *frame);
  }
  throwIfCancelled();
  layers.write(*output);
}

}  // namespace

Command addRender(CLI::App& program) {
  CLI::App* command = program.add_subcommand("render", "Draw one frame into a picture");
  const auto render = std::make_shared<RenderCommand>(*command);
  return {command, [render] { render->run(); }};
}

}  // namespace umbra
