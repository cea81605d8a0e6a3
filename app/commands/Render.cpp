#include <algorithm>
#include <cmath>
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
  // As named on the command line, else `unnamed`.
  std::vector<std::shared_ptr<Technique>> techniques(const Session& session,
                                                     const TechniqueChoice& unnamed) const;
};

// What a session compares, its panes beside each other; a pane that cannot be is left out.
TechniqueChoice comparedIn(const Session& session) {
  switch (session.comparison.mode) {
    case ComparisonMode::Wipe:
      return {{session.technique, wipeTechniqueOf(session)}};
    case ComparisonMode::Grid:
      return {panesOf(session), true};
    case ComparisonMode::Single:
      break;
  }
  return {{session.technique}};
}

// From `at` of the width (0 … 1) on, `left` becomes `right`.
void wipe(Image<std::uint8_t>& left, const Image<std::uint8_t>& right, double at) {
  const int first = std::max(0, int(std::ceil(at * left.width() - 0.5)));
  for (int y = 0; y < left.height(); ++y)
    for (int x = first; x < left.width(); ++x)
      for (int c = 0; c < 3; ++c) left(x, y, c) = right(x, y, c);
}

RenderCommand::RenderCommand(CLI::App& command) {
  command.add_option("-o,--output", output, "Picture, or its layers as floats")
      ->type_name("FILE.png|FILE.exr")
      ->group("Render");
  command.footer(
      "Several techniques are drawn side by side in a PNG, as are the panes of a session that\n"
      "compares; a session's wipe is one picture of two. An EXR has R, G, B of the first, per\n"
      "pixel u, v (in the map; u < 0 without a surface), receiver (negative where the surface "
      "faces\n"
      "away from the light) and reference, and TECHNIQUE.R .G .B .visibility .error for each.");
  options.addTo(command);
}

std::vector<std::shared_ptr<Technique>> RenderCommand::techniques(
    const Session& session, const TechniqueChoice& unnamed) const {
  return makeTechniques(session, catalogue, options.techniques(catalogue, unnamed));
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
  const auto chosen = techniques(session, comparedIn(session));
  const auto scene = std::make_shared<const Scene>(loadScene(session.source));
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  std::vector<LabelledPicture> pictures;
  for (const auto& technique : chosen) {
    throwIfCancelled();
    frame->render(*technique, session.frame.view);
    pictures.push_back({std::string(technique->info().title), frame->colour()});
  }
  const bool named = !options.techniques(catalogue, {}).ids.empty();
  if (!named && session.comparison.mode == ComparisonMode::Wipe) {
    wipe(pictures.front().colour, pictures.back().colour, session.comparison.wipe);
    pictures.pop_back();
  }
  throwIfCancelled();
  display->writePictures(pictures, *output);
}

void RenderCommand::renderLayers(const Session& session) const {
  const auto chosen = techniques(session, {{session.technique}});
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
