#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/frames/Drawings.h"
#include "app/frames/FrameLayers.h"
#include "app/frames/TechniqueSet.h"
#include "app/options/SceneSources.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "app/output/Output.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

struct RenderCommand {
  explicit RenderCommand(OptionParser& command);

  void run() const;
  void renderPicture(const Workspace& workspace) const;
  void renderLayers(const Workspace& workspace) const;

  SessionOptions options;
  std::optional<std::string> output;
  TechniqueCatalogue catalogue = allTechniques();
  // As named on the command line, else `unnamed`.
  std::vector<std::shared_ptr<Technique>> techniques(const Session& session,
                                                     const TechniqueChoice& unnamed) const;
  // Whether panes are drawn: techniques on the command line are compared instead.
  bool compares(const Workspace& workspace) const {
    return !options.namesTechniques() && workspace.comparison.mode != ComparisonMode::Single;
  }
  std::vector<Drawing> drawings(const Workspace& workspace) const;
};

// From `at` of the width (0 … 1) on, `left` becomes `right`.
void wipe(Image<std::uint8_t>& left, const Image<std::uint8_t>& right, double at) {
  const int first = std::max(0, int(std::ceil(at * left.width() - 0.5)));
  for (int y = 0; y < left.height(); ++y)
    for (int x = first; x < left.width(); ++x)
      for (int c = 0; c < 3; ++c) left(x, y, c) = right(x, y, c);
}

RenderCommand::RenderCommand(OptionParser& command) {
  command.add("-o,--output", output,
              {"Render", "FILE.png|FILE.exr", "Picture, or its layers as floats"});
  command.setFooter(
      "Several techniques are drawn side by side in a PNG, as are the panes of a session that\n"
      "compares; a session's wipe is one picture of two. An EXR has R, G, B of the first, per\n"
      "pixel u, v (in the map; u < 0 without a surface), receiver (negative where the surface\n"
      "faces away from the light) and reference, and TECHNIQUE.R .G .B .visibility .error for\n"
      "each. Of a session that compares it has a part for each pane, named by its technique, with\n"
      "R, G, B, u, v, receiver, reference, visibility and error.");
  options.addTo(command);
}

std::vector<std::shared_ptr<Technique>> RenderCommand::techniques(
    const Session& session, const TechniqueChoice& unnamed) const {
  return makeTechniques(session, catalogue, options.techniques(catalogue, unnamed));
}

std::vector<Drawing> RenderCommand::drawings(const Workspace& workspace) const {
  const Session session = sessionOf(workspace);
  if (!compares(workspace)) return drawingsOf(session, techniques(session, {{session.technique}}));
  std::vector<Drawing> panes = drawingsOfPanes(workspace, catalogue);
  for (const Drawing& pane : panes) checkGpuFormat(pane.session);
  return panes;
}

void RenderCommand::run() const {
  if (!output)
    throw Error(ErrorKind::BadCommandLine, "--output: is missing, give -o FILE.png or FILE.exr");
  const std::string extension = std::filesystem::path(*output).extension().string();
  if (extension != ".png" && extension != ".exr")
    throw Error(ErrorKind::BadCommandLine,
                "--output: '" + *output + "' is not right, it takes FILE.png or FILE.exr");
  checkWritable(*output);
  const Workspace workspace = options.workspace(catalogue);
  checkGpuFormat(sessionOf(workspace));
  if (extension == ".png")
    renderPicture(workspace);
  else
    renderLayers(workspace);
  announce(*output);
}

// A comparison of what was drawn, as many as there may be panes.
Workspace besideEachOther(Workspace workspace, const std::vector<Drawing>& chosen) {
  std::vector<std::string> techniques;
  for (const Drawing& drawing : chosen)
    if (techniques.size() < Comparison::most) techniques.emplace_back(drawing.technique->info().id);
  workspace.shared.technique = techniques.front();
  workspace.comparison.mode = ComparisonMode::Grid;
  workspace.comparison.panes = linkedPanes(techniques);
  return workspace;
}

void RenderCommand::renderPicture(const Workspace& workspace) const {
  const std::vector<Drawing> chosen = drawings(workspace);
  const Session session = sessionOf(workspace);
  const auto scene = options.scene(session.source);
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  std::vector<LabelledPicture> pictures;
  for (const Drawing& drawing : chosen) {
    throwIfCancelled();
    frame->show(scene, drawing.session);
    frame->render(*drawing.technique, drawing.session.frame.view);
    pictures.push_back({drawing.label, frame->colour()});
  }
  if (compares(workspace) && workspace.comparison.mode == ComparisonMode::Wipe) {
    wipe(pictures.front().colour, pictures.back().colour, workspace.comparison.wipe);
    pictures.pop_back();
  }
  throwIfCancelled();
  const Workspace drawn =
      compares(workspace) || chosen.size() == 1 ? workspace : besideEachOther(workspace, chosen);
  display->writePictures(pictures, *output, sessionAttributes(drawn, UMBRA_VERSION));
}

void RenderCommand::renderLayers(const Workspace& workspace) const {
  const std::vector<Drawing> chosen = drawings(workspace);
  const Session session = sessionOf(workspace);
  const auto scene = options.scene(session.source);
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  FrameLayers layers(session);
  std::vector<ExrPart> parts;  // of panes
  for (const Drawing& drawing : chosen) {
    throwIfCancelled();
    frame->show(scene, drawing.session);
    frame->render(*drawing.technique, drawing.session.frame.view);
    if (drawing.pane == 0)
      layers.add(*drawing.technique, *frame);
    else
      parts.push_back(partOf(drawing, *frame));
  }
  throwIfCancelled();
  if (!parts.empty()) {
    parts.front().attributes[workspaceAttribute] = sessionText(workspace);
    return writeExr(*output, parts);
  }
  if (chosen.size() > 1) layers.setWorkspace(besideEachOther(workspace, chosen));
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
