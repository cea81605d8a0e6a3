#include "datasets/session/PaneLabels.h"

#include <algorithm>
#include <array>

#include "filters/core/support/Text.h"

namespace umbra {
namespace {

// Of one setting for every pane; empty where a pane has nothing of the kind.
using Column = std::vector<std::string>;

std::string kernelText(const FrameSettings& frame) {
  switch (frame.kernel.shape) {
    case KernelShape::None:
      return "no prefilter";
    case KernelShape::Gaussian:
      return "Gaussian";
    case KernelShape::Box:
      break;
  }
  return "box";
}

std::string radiusText(const FrameSettings& frame) {
  const bool blurs = frame.kernel.shape != KernelShape::None;
  return blurs ? "radius " + std::to_string(frame.kernel.radius) : "";
}

std::string sigmaText(const FrameSettings& frame) {
  const bool set = frame.kernel.shape == KernelShape::Gaussian && frame.kernel.sigma > 0.0;
  return set ? "σ " + shortNumber(frame.kernel.sigma) : "";
}

std::string readText(const FrameSettings& frame) {
  switch (frame.read.filter) {
    case ReadFilter::Anisotropic:
      return "anisotropic ×" + std::to_string(frame.read.anisotropy);
    case ReadFilter::SummedArea:
      return "summed area";
    default:
      return std::string(nameOf(frame.read.filter));
  }
}

std::string boxText(const FrameSettings& frame) {
  if (frame.read.filter != ReadFilter::SummedArea) return "";
  std::string text = "box by " + std::string(nameOf(frame.read.satSize));
  if (frame.read.satSize == SatSize::Fixed) return "fixed box";
  if (frame.read.satSize == SatSize::Distance && frame.read.satDistance > 0.0)
    text += " " + shortNumber(frame.read.satDistance);
  return text;
}

std::string sumsText(const FrameSettings& frame) {
  const bool sums = frame.read.filter == ReadFilter::SummedArea;
  return sums ? std::string(nameOf(frame.read.satPrecision)) + " sums" : "";
}

std::string formatText(const FrameSettings& frame) {
  switch (frame.map.format) {
    case StorageFormat::Unorm8:
      return "8 bit";
    case StorageFormat::Unorm16:
      return "16 bit";
    default:
      return std::string(nameOf(frame.map.format));
  }
}

std::string sizeText(const FrameSettings& frame) {
  return "map " + std::to_string(frame.map.size);
}

std::string samplesText(const FrameSettings& frame) {
  const int count = frame.map.samples;
  return count == 1 ? "1 sample" : std::to_string(count) + " samples";
}

std::string cascadesText(const FrameSettings& frame) {
  const int count = frame.map.cascades.count;
  return count == 1 ? "1 cascade" : std::to_string(count) + " cascades";
}

std::string cutText(const FrameSettings& frame) {
  const CascadeSettings& cascades = frame.map.cascades;
  if (cascades.count == 1) return "";
  return "split λ " + shortNumber(cascades.splitLambda) + ", seam " + shortNumber(cascades.seam) +
         (cascades.frozen ? ", frozen" : "");
}

std::string biasText(const FrameSettings& frame) {
  return "bias " + shortNumber(frame.bias.constant);
}

std::string slopeText(const FrameSettings& frame) {
  return "slope bias " + shortNumber(frame.bias.slope);
}

std::string planeText(const FrameSettings& frame) {
  return frame.bias.receiverPlane ? "receiver-plane bias" : "no receiver-plane bias";
}

std::string facesText(const FrameSettings& frame) {
  return frame.bias.cullFrontFaces ? "front faces culled" : "front faces kept";
}

constexpr std::array frameTexts{kernelText, radiusText, sigmaText, readText,    boxText,
                                sumsText,   formatText, sizeText,  samplesText, cascadesText,
                                cutText,    biasText,   slopeText, planeText,   facesText};

// Where more than half of them have the same text, that goes without saying.
void addWhereDifferent(std::vector<std::string>& labels, const Column& column,
                       std::vector<std::size_t> rows) {
  std::erase_if(rows, [&](std::size_t row) { return column[row].empty(); });
  for (const std::size_t row : rows) {
    const auto alike = std::count_if(
        rows.begin(), rows.end(), [&](std::size_t other) { return column[other] == column[row]; });
    if (2 * std::size_t(alike) > rows.size()) continue;
    labels[row] += (labels[row].empty() ? "" : " · ") + column[row];
  }
}

// "bleed reduction 0.3", as it was set, whatever a storage format makes of it.
std::string parameterText(const Parameter& parameter, const ParameterValues& set) {
  std::string name(parameter.name);
  std::replace(name.begin(), name.end(), '-', ' ');
  const auto found = set.find(std::string(parameter.name));
  const ParameterValue& value = found == set.end() ? parameter.defaultValue : found->second;
  const auto* real = std::get_if<double>(&value);
  const std::string text = real ? shortNumber(*real) : toText(value);
  return name + " " + (text.empty() ? "none" : text);
}

void addParameters(std::vector<std::string>& labels, const std::vector<Session>& panes,
                   const TechniqueCatalogue& catalogue) {
  std::vector<std::vector<std::string>> texts;  // of every pane, its parameters
  for (const Session& pane : panes) {
    const std::unique_ptr<Technique> technique = catalogue.make(pane.technique);
    const ParameterValues set = parametersOf(pane, pane.technique);
    std::vector<std::string>& own = texts.emplace_back();
    for (const Parameter& parameter : technique->parameters())
      own.push_back(parameterText(parameter, set));
  }
  std::vector<bool> done(panes.size(), false);
  for (std::size_t first = 0; first < panes.size(); ++first) {
    std::vector<std::size_t> alike;  // panes of one technique
    for (std::size_t i = first; i < panes.size(); ++i)
      if (!done[i] && panes[i].technique == panes[first].technique) alike.push_back(i);
    for (const std::size_t i : alike) done[i] = true;
    for (std::size_t p = 0; alike.size() > 1 && p < texts[first].size(); ++p) {
      Column column(panes.size());
      for (const std::size_t i : alike) column[i] = texts[i][p];
      addWhereDifferent(labels, column, alike);
    }
  }
}

}  // namespace

std::vector<std::string> paneLabels(const Session& session, const TechniqueCatalogue& catalogue) {
  std::vector<Session> panes;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < shownPanes(comparisonOf(session)); ++i) {
    panes.push_back(activated(session, i));
    all.push_back(i);
  }
  std::vector<std::string> labels(panes.size());
  addParameters(labels, panes, catalogue);
  for (const auto& textOf : frameTexts) {
    Column column;
    for (const Session& pane : panes) column.push_back(textOf(pane.frame));
    addWhereDifferent(labels, column, all);
  }
  return labels;
}

}  // namespace umbra
