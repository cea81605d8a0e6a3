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
#include "app/reports/StoredReport.h"
#include "datasets/session/DepthReading.h"
#include "filters/core/prefilter/Prefilter.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

struct EncodeCommand {
  explicit EncodeCommand(OptionParser& command);

  void run() const;
  void encodeDepthMap(Session session, const DepthFile& depth, ChannelFile& file) const;
  void encodeScene(const Session& session, ChannelFile& file) const;
  void check(const Session& session) const;

  SessionOptions options;
  std::optional<std::string> output, stage, against, againstChannels;
  bool json = false;
  TechniqueCatalogue catalogue = allTechniques();
  BakeStage wanted() const;
  std::vector<std::shared_ptr<Technique>> techniques(const Session& session) const;
};

EncodeCommand::EncodeCommand(OptionParser& command) {
  command.add("-o,--output", output, {"Encode", "FILE.exr", "File to write"});
  command.add("--stage", stage,
              {"Encode", "NAME", "encoded, or prefiltered (default): after the kernel"});
  command.add("--against", against,
              {"Encode", "FILE",
               "Check the channels that an engine stored for the depth map: how far they are from "
               "the exact ones, where, and what that looks like"});
  command.add(
      "--against-channels", againstChannels,
      {"Encode", "A[,B...]",
       "Names of the technique's channels in that file, in its order (default TECHNIQUE.CHANNEL, "
       "CHANNEL, or R,G,B,A)"});
  command.addFlag("--json", json, {"Encode", "", "With --against: print one JSON object"});
  command.setFooter(
      "Writes one part with the channels TECHNIQUE.CHANNEL, and Z: the depth itself, in [0,1].\n"
      "Without --technique it is the session's; hard and pcf store nothing but Z.\n"
      "Of several cascades it is the first, nearest to the camera; Z is a texel's first sample.\n"
      "With --against it prints a table, and -o may be left out; what it then writes has the\n"
      "difference of each channel, TECHNIQUE.CHANNEL.difference, beside it.");
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
  if (!output && !against)
    throw Error(ErrorKind::BadCommandLine, "--output: is missing, give -o FILE.exr");
  if (output && std::filesystem::path(*output).extension() != ".exr")
    throw Error(ErrorKind::BadCommandLine,
                "--output: '" + *output + "' is not right, it takes FILE.exr");
  for (const auto& [name, isGiven] :
       {std::pair("--against-channels", againstChannels.has_value()), std::pair("--json", json)})
    if (isGiven && !against)
      throw Error(ErrorKind::BadCommandLine, std::string(name) + ": goes with --against");
  if (output) checkWritable(*output);
  wanted();
  const Session session = options.session(catalogue);
  if (against && !output) return check(session);
  if (session.frame.map.format == StorageFormat::Double)
    throw Error(ErrorKind::BadCommandLine, "--format: double does not fit into EXR, take float");
  if (against) return check(session);
  ChannelFile file(session);
  if (session.source.kind == SourceKind::DepthFile)
    encodeDepthMap(session, loadedDepth(session.source), file);
  else
    encodeScene(session, file);
  throwIfCancelled();
  file.write(*output);
  announce(*output);
}

void EncodeCommand::encodeDepthMap(Session session, const DepthFile& depth,
                                   ChannelFile& file) const {
  session.frame = readSettingsOf(session);
  const auto chosen = techniques(session);
  const DepthMap& map = depth.map;
  file.setOrigin({depth.originX, depth.originY});
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

void EncodeCommand::check(const Session& session) const {
  if (session.source.kind != SourceKind::DepthFile)
    throw Error(ErrorKind::BadCommandLine, "--against: needs the depth map, give --depth FILE");
  const auto chosen = techniques(session);
  if (chosen.size() != 1)
    throw Error(ErrorKind::BadCommandLine,
                "--against: takes one technique that stores channels, name it by --technique");
  Technique& technique = *chosen.front();
  const DepthFile depth = loadedDepth(session.source);
  technique.adapt(depth.map);
  Kernel kernel = session.frame.kernel;
  if (wanted() == BakeStage::Encoded) kernel.shape = KernelShape::None;
  const std::vector<StoredName> names =
      storedNames(*against, technique,
                  againstChannels ? split(*againstChannels, ',') : std::vector<std::string>());
  std::optional<StorageFormat> format;
  if (options.namesFormat() || options.namesSession()) format = session.frame.map.format;
  const std::vector<StoredRow> rows =
      storedRows(*against, names, depth, technique, kernel, format, throwIfCancelled);
  if (output) {
    ChannelFile file(session);
    encodeDepthMap(session, depth, file);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      StoredAssumption own;
      own.kernel = kernel;
      const Image<double> exact =
          valuesIn(depth.map, own, {depth.map, technique, int(i), kernel, StorageFormat::Double});
      Image<float> difference(exact.width(), exact.height());
      for (std::size_t t = 0; t < exact.values().size(); ++t)
        difference.values()[t] = float(rows[i].stored.values()[t] - exact.values()[t]);
      file.add(std::string(technique.info().id) + "." + rows[i].name.channel + ".difference",
               std::move(difference));
    }
    throwIfCancelled();
    file.write(*output);
    announce(*output);
  }
  if (json)
    printJson(storedToJson(rows, depth, shortNameOf(session.source),
                           std::filesystem::path(*against).filename().string(), technique, kernel));
  else
    print(storedText(rows, depth));
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
