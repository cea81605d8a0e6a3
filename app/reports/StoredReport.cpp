#include "app/reports/StoredReport.h"

#include <algorithm>

#include "app/output/Table.h"
#include "app/reports/Reports.h"
#include "datasets/maps/RasterChannel.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

StorageFormat formatOf(RasterNumber number) {
  switch (number) {
    case RasterNumber::Half:
      return StorageFormat::Half;
    case RasterNumber::Fraction8:
      return StorageFormat::Unorm8;
    case RasterNumber::Fraction16:
      return StorageFormat::Unorm16;
    case RasterNumber::Float:
      return StorageFormat::Float;
    case RasterNumber::Double:
    case RasterNumber::Whole:
      break;
  }
  return StorageFormat::Double;
}

Json differenceToJson(const StoredDifference& difference, StorageFormat format,
                      const DepthFile& depth) {
  return {{"format", nameOf(format)},
          {"largest", difference.largest},
          {"mean", difference.mean},
          {"largestUnits", difference.largestUnits},
          {"meanUnits", difference.meanUnits},
          {"texel", {difference.x + depth.originX, difference.y + depth.originY}},
          {"exact", difference.expected},
          {"stored", difference.stored},
          {"beyondRounding", difference.beyond},
          {"notFinite", difference.notFinite}};
}

Json kernelToJson(const Kernel& kernel) {
  Json object = {{"kernel", nameOf(kernel.shape)}, {"radius", kernel.effectiveRadius()}};
  if (kernel.shape == KernelShape::Gaussian) object["sigma"] = kernel.effectiveSigma();
  return object;
}

Json explanationToJson(const StoredExplanation& explanation, const StoredDifference& left,
                       StorageFormat format, const Technique& technique, const DepthFile& depth) {
  const StoredAssumption& assumption = explanation.assumption;
  Json object = {{"changes", explanation.changes}, {"quantity", nameOf(assumption.quantity)}};
  if (assumption.quantity == StoredQuantity::OtherChannel)
    object["channel"] = technique.channels()[std::size_t(assumption.other)].name;
  object.update(kernelToJson(assumption.kernel));
  object["rowsFromBelow"] = assumption.rowsFromBelow;
  object["shift"] = {assumption.shiftX, assumption.shiftY};
  object["scale"] = assumption.scale;
  object["offset"] = assumption.offset;
  object["left"] = differenceToJson(left, format, depth);
  return object;
}

}  // namespace

std::vector<StoredName> storedNames(const std::filesystem::path& file, const Technique& technique,
                                    const std::vector<std::string>& named) {
  const std::vector<Channel> layout = technique.channels();
  const std::vector<std::string> there = rasterChannels(file);
  std::vector<StoredName> names;
  if (!named.empty() && named.size() != layout.size())
    throw Error(ErrorKind::BadCommandLine, "--against-channels: names " +
                                               std::to_string(named.size()) + ", " +
                                               std::string(technique.info().id) + " has " +
                                               std::to_string(layout.size()) + " channels");
  const auto has = [&](const std::string& name) {
    return std::find(there.begin(), there.end(), name) != there.end();
  };
  const std::string colours[] = {"R", "G", "B", "A"};
  const bool isOne = there.empty() && layout.size() == 1;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    const std::string full = std::string(technique.info().id) + "." + layout[i].name;
    std::vector<std::string> candidates{full, layout[i].name};
    if (i < std::size(colours)) candidates.push_back(colours[i]);
    if (!named.empty()) candidates = {named[i]};
    const auto found = std::find_if(candidates.begin(), candidates.end(), has);
    if (found == candidates.end() && !isOne) {
      std::vector<std::string> shown;
      for (const std::string& name : there) shown.push_back(clipped(name));
      throw Error(ErrorKind::BadInput,
                  file.string() + ": there is no channel '" +
                      clipped(named.empty() ? full : named[i]) + "'; there are " +
                      (shown.empty() ? "none with names" : joined(shown)) +
                      "; --against-channels names those of " + std::string(technique.info().id));
    }
    names.push_back({layout[i].name, isOne ? "" : *found});
  }
  return names;
}

std::vector<StoredRow> storedRows(const std::filesystem::path& file,
                                  const std::vector<StoredName>& names, const DepthFile& depth,
                                  const Technique& technique, const Kernel& kernel,
                                  std::optional<StorageFormat> format,
                                  const std::function<void()>& between) {
  const std::vector<Channel> layout = technique.channels();
  std::vector<StoredRow> rows;
  for (std::size_t i = 0; i < names.size(); ++i) {
    between();
    RasterChannel read = readRasterChannel(file, names[i].inFile);
    if (read.info.width != depth.map.width() || read.info.height != depth.map.height())
      throw Error(ErrorKind::BadInput,
                  file.string() + ": has " + std::to_string(read.info.width) + " × " +
                      std::to_string(read.info.height) + " texels, the depth map has " +
                      std::to_string(depth.map.width()) + " × " +
                      std::to_string(depth.map.height()) + "; both must be of one size");
    const bool isElsewhere =
        read.info.originX != depth.originX || read.info.originY != depth.originY;
    if (isElsewhere && rasterReaderOf(file) == readExr)
      throw Error(ErrorKind::BadInput,
                  file.string() + ": its data window begins at " +
                      std::to_string(read.info.originX) + "," + std::to_string(read.info.originY) +
                      ", that of the depth map at " + std::to_string(depth.originX) + "," +
                      std::to_string(depth.originY) + "; both must be of one place");
    const StorageFormat counted =
        format ? *format : formatThatHolds(read.values, layout[i], formatOf(read.info.number));
    const StoredQuestion question{depth.map, technique, int(i), kernel, counted};
    rows.push_back({names[i], checkStored(question, read.values, between), {}});
    rows.back().stored = std::move(read.values);
  }
  return rows;
}

Json storedToJson(const std::vector<StoredRow>& rows, const DepthFile& depth,
                  const std::string& sourceName, const std::string& againstName,
                  const Technique& technique, const Kernel& kernel) {
  Json object = {{"format", "umbrascope-stored/1"},
                 {"source", sourceToJson(sourceName, depth)},
                 {"against", againstName},
                 {"technique", technique.info().id},
                 {"parameters", parametersOf(technique)}};
  object.update(kernelToJson(kernel));
  object["channels"] = Json::array();
  for (const StoredRow& row : rows) {
    const StoredFinding& finding = row.finding;
    Json channel = {{"name", row.name.channel}, {"channel", row.name.inFile}};
    channel.update(differenceToJson(finding.difference, finding.format, depth));
    channel["heldBy"] = nameOf(finding.heldBy);
    channel["agrees"] = finding.agrees;
    channel["onlyAtEdges"] = finding.onlyAtEdges;
    channel["explanation"] = finding.explanation
                                 ? explanationToJson(*finding.explanation, *finding.left,
                                                     finding.heldBy, technique, depth)
                                 : Json();
    channel["text"] = finding.text;
    object["channels"].push_back(std::move(channel));
  }
  return object;
}

std::string storedText(const std::vector<StoredRow>& rows, const DepthFile& depth) {
  std::vector<TableRow> table{
      {"CHANNEL", "IN FILE", "LARGEST", "MEAN", "LAST PLACES", "OF", "AT TEXEL"}};
  std::string sentences;
  for (const StoredRow& row : rows) {
    const StoredDifference& difference = row.finding.difference;
    table.push_back({row.name.channel, row.name.inFile, shortNumber(difference.largest),
                     shortNumber(difference.mean), shortNumber(difference.largestUnits),
                     std::string(nameOf(row.finding.format)),
                     std::to_string(difference.x + depth.originX) + "," +
                         std::to_string(difference.y + depth.originY)});
    sentences += row.name.channel + ": " + row.finding.text + "\n";
  }
  return tableText(table) + "\n" + sentences;
}

}  // namespace umbra
