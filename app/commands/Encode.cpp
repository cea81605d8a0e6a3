#include <memory>
#include <optional>

#include "app/commands/Commands.h"
#include "app/display/DisplayLibrary.h"
#include "app/frames/TechniqueSet.h"
#include "app/options/SceneSources.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "app/output/ChannelFile.h"
#include "app/output/Output.h"
#include "datasets/session/DepthReading.h"
#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

struct EncodeCommand {
  explicit EncodeCommand(OptionParser& command);

  void run() const;
  void encodeDepthMap(Session session, ChannelFile& file) const;
  void encodeScene(const Session& session, ChannelFile& file) const;

  SessionOptions options;
  std::optional<std::string> output, stage;
  TechniqueCatalogue catalogue = allTechniques();
  BakeStage wanted() const;
  std::vector<std::shared_ptr<Technique>> techniques(const Session& session) const;
};

EncodeCommand::EncodeCommand(OptionParser& command) {
  command.add("-o,--output", output, {"Encode", "FILE.exr", "File to write"});
  command.add("--stage", stage,
              {"Encode", "NAME", "encoded, or prefiltered (default): after the kernel"});
  command.setFooter(
      "Writes one part with the channels TECHNIQUE.CHANNEL, and Z: the depth itself, in [0,1].\n"
      "Without --technique it is the session's; hard and pcf store nothing but Z.\n"
      "Of several cascades it is the first, nearest to the camera; Z is a texel's first sample.");
  options.addTo(command);
}

BakeStage EncodeCommand::wanted() const {
  if (!stage || *stage == "prefiltered") return BakeStage::Prefiltered;
  if (*stage == "encoded") return BakeStage::Encoded;
  throw Error(ErrorKind::BadCommandLine,
              "--stage: '" + *stage + "' is not right, it takes encoded or prefiltered");
}

std::vector<std::shared_ptr<Technique>> EncodeCommand::techniques(const Session& session) const {
  TechniqueChoice choice = options.techniques(catalogue, {{session.technique}});
  std::erase_if(choice.ids, [this](const std::string& id) {
    return !catalogue.make(id)->info().prefilterable;
  });
  return makeTechniques(session, catalogue, choice);
}

void EncodeCommand::run() const {
  if (!output) throw Error(ErrorKind::BadCommandLine, "--output: is missing, give -o FILE.exr");
  if (std::filesystem::path(*output).extension() != ".exr")
    throw Error(ErrorKind::BadCommandLine,
                "--output: '" + *output + "' is not right, it takes FILE.exr");
  checkWritable(*output);
  wanted();
  const Session session = options.session(catalogue);
  if (session.frame.map.format == StorageFormat::Double)
    throw Error(ErrorKind::BadCommandLine, "--format: double does not fit into EXR, take float");
  ChannelFile file(session);
  if (session.source.kind == SourceKind::DepthFile)
    encodeDepthMap(session, file);
  else
    encodeScene(session, file);
  throwIfCancelled();
  file.write(*output);
  announce(*output);
}

void EncodeCommand::encodeDepthMap(Session session, ChannelFile& file) const {
  session.frame = readSettingsOf(session);
  const auto chosen = techniques(session);
  const DepthMap map = loadedDepth(session.source).map;
  const StorageFormat format = session.frame.map.format;
  file.addDepth(map);
  for (const auto& technique : chosen) {
    throwIfCancelled();
    technique->adapt(map);
    file.addTechnique(*technique,
                      wanted() == BakeStage::Encoded
                          ? encodeMap(map, *technique, format)
                          : prefilteredMap(map, *technique, session.frame.kernel, format));
  }
}

void EncodeCommand::encodeScene(const Session& session, ChannelFile& file) const {
  checkGpuFormat(session);
  const auto chosen = techniques(session);
  const auto scene = options.scene(session.source);
  const std::unique_ptr<Display> display = loadDisplay();
  const std::unique_ptr<HeadlessFrame> frame = display->makeFrame(scene, session);
  if (chosen.empty()) frame->render(*catalogue.make("hard"), ViewMode::Shaded);
  for (const auto& technique : chosen) {
    throwIfCancelled();
    frame->render(*technique, ViewMode::Shaded);
    technique->adapt(frame->depthMap());
    file.addTechnique(*technique, frame->channels(wanted()));
  }
  file.addDepth(frame->depthMap());
}

}  // namespace

Command addEncode(OptionParser& program) {
  OptionParser command = program.addCommand(
      "encode", "Write what techniques store, as channels of an EXR file", commandsGroup);
  const auto encode = std::make_shared<EncodeCommand>(command);
  return {command, [encode] { encode->run(); }};
}

}  // namespace umbra
