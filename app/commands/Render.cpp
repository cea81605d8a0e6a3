#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <spdlog/spdlog.h>

#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/frames/FrameLayers.h"
#include "app/frames/TechniqueSet.h"
#include "app/options/SceneSources.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "app/output/Output.h"
#include "datasets/session/PaneLabels.h"
#include "filters/core/support/Error.h"
#include "filters/core/technique/Composition.h"

namespace umbra {
namespace {

// One picture of a sheet.
struct Drawing {
  Session session;
  std::shared_ptr<Technique> technique;
  std::string label;
};

struct RenderCommand {
  explicit RenderCommand(OptionParser& command);

  void run() const;
  void renderPicture(const Session& session) const;
  void renderLayers(const Session& session) const;

  SessionOptions options;
  std::optional<std::string> output;
  TechniqueCatalogue catalogue = allTechniques();
  // As named on the command line, else `unnamed`.
  std::vector<std::shared_ptr<Technique>> techniques(const Session& session,
                                                     const TechniqueChoice& unnamed) const;
  bool named() const { return !options.techniques(catalogue, {}).ids.empty(); }
  // Whether panes are drawn: techniques on the command line are compared instead.
  bool compares(const Session& session) const {
    return !named() && session.comparison.mode != ComparisonMode::Single;
  }
  std::vector<Drawing> drawings(const Session& session) const;
  std::vector<Drawing> panes(const Session& session) const;
};

// From `at` of the width (0 … 1) on, `left` becomes `right`.
void wipe(Image<std::uint8_t>& left, const Image<std::uint8_t>& right, double at) {
  const int first = std::max(0, int(std::ceil(at * left.width() - 0.5)));
  for (int y = 0; y < left.height(); ++y)
    for (int x = first; x < left.width(); ++x)
      for (int c = 0; c < 3; ++c) left(x, y, c) = right(x, y, c);
}

std::string nameOfPane(const Technique& technique, const std::string& label) {
  const std::string title(technique.info().title);
  return label.empty() ? title : title + " · " + label;
}

RenderCommand::RenderCommand(OptionParser& command) {
  command.add("-o,--output", output,
              {"Render", "FILE.png|FILE.exr", "Picture, or its layers as floats"});
  command.setFooter(
      "Several techniques are drawn side by side in a PNG, as are the panes of a session that\n"
      "compares; a session's wipe is one picture of two. An EXR has R, G, B of the first, per\n"
      "pixel u, v (in the map; u < 0 without a surface), receiver (negative where the surface\n"
      "faces away from the light) and reference, and TECHNIQUE.R .G .B .visibility .error for\n"
      "each; of a session's panes it has the active one only.");
  options.addTo(command);
}

std::vector<std::shared_ptr<Technique>> RenderCommand::techniques(
    const Session& session, const TechniqueChoice& unnamed) const {
  return makeTechniques(session, catalogue, options.techniques(catalogue, unnamed));
}

std::vector<Drawing> RenderCommand::drawings(const Session& session) const {
  if (compares(session)) return panes(session);
  std::vector<Drawing> drawings;
  for (auto& technique : techniques(session, {{session.technique}}))
    drawings.push_back({session, technique, std::string(technique->info().title)});
  return drawings;
}

// What a session compares, each pane with its settings; of several beside each other, one that
// cannot be is left out.
std::vector<Drawing> RenderCommand::panes(const Session& session) const {
  std::vector<Drawing> drawings;
  const std::vector<std::string> labels = paneLabels(session, catalogue);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Session pane = activated(session, i);
    checkGpuFormat(pane);
    const std::string why =
        whyImpossible(pane.frame, *techniqueOf(pane, catalogue, pane.technique));
    const bool last = i + 1 == labels.size() && drawings.empty();
    if (!why.empty() && pane.comparison.mode == ComparisonMode::Grid && !last) {
      spdlog::warn("left out: {}", why);
      continue;
    }
    const auto technique = makeTechniques(pane, catalogue, {{pane.technique}}).front();
    drawings.push_back({pane, technique, nameOfPane(*technique, labels[i])});
  }
  return drawings;
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
  const std::vector<Drawing> chosen = drawings(session);
  const auto scene = std::make_shared<const Scene>(loadScene(session.source));
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  std::vector<LabelledPicture> pictures;
  for (const Drawing& drawing : chosen) {
    throwIfCancelled();
    frame->show(scene, drawing.session);
    frame->render(*drawing.technique, drawing.session.frame.view);
    pictures.push_back({drawing.label, frame->colour()});
  }
  if (compares(session) && session.comparison.mode == ComparisonMode::Wipe) {
    wipe(pictures.front().colour, pictures.back().colour, session.comparison.wipe);
    pictures.pop_back();
  }
  throwIfCancelled();
  display->writePictures(pictures, *output);
}

void RenderCommand::renderLayers(const Session& session) const {
  const auto chosen = techniques(session, {{session.technique}});
  if (compares(session)) {
    const std::vector<std::string> labels = paneLabels(session, catalogue);
    spdlog::warn("an EXR has one pane: {}, the active one of the {} that the session compares",
                 nameOfPane(*chosen.front(), labels.at(comparisonOf(session).active)),
                 labels.size());
  }
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

Command addRender(OptionParser& program) {
  OptionParser command =
      program.addCommand("render", "Draw one frame into a picture", commandsGroup);
  const auto render = std::make_shared<RenderCommand>(command);
  return {command, [render] { render->run(); }};
}

}  // namespace umbra
