#include "analysis/stored/StoredCheck.h"

#include <algorithm>

#include "filters/core/support/Text.h"

namespace umbra {
namespace {

std::string roundingText(double units, StorageFormat format) {
  return "at most " + shortNumber(units) + " last places of " + std::string(nameOf(format)) +
         ", is rounding";
}

std::string edgeText(int reach) {
  return "What differs lies within " + std::to_string(reach) + (reach == 1 ? " texel" : " texels") +
         " of the map's edge, where its own outermost texels are repeated here.";
}

// `left` counts in last places of the format that holds the values.
std::string explanationText(const StoredFinding& finding, const StoredQuestion& question,
                            int reach) {
  const StoredExplanation& explanation = *finding.explanation;
  std::string text = sentencesOf(explanation.assumption, question);
  const StoredDifference& left = *finding.left;
  if (left.isRounding())
    return left.largestUnits == 0.0
               ? text + " Nothing else differs."
               : text + " What is left, " + roundingText(left.largestUnits, finding.heldBy) + ".";
  if (left.beyondInside == 0) return text + " " + edgeText(reach);
  return text + " That takes the mean difference from " + shortNumber(finding.difference.mean) +
         " to " + shortNumber(left.mean) + "; what is left is not explained.";
}

// Looks for an assumption that explains the difference, and proves it on the whole map.
void explain(StoredFinding& finding, const StoredQuestion& question, const Image<double>& stored,
             const std::function<void()>& between) {
  finding.explanation = explainStored(question, stored, between);
  if (finding.explanation) {
    const StoredAssumption& assumption = finding.explanation->assumption;
    const int reach =
        std::max(question.kernel.effectiveRadius(), assumption.kernel.effectiveRadius());
    finding.left = storedDifference(expectedUnder(assumption, question), stored, reach);
    const bool explains = finding.left->mean <= mostLeft * finding.difference.mean &&
                          finding.left->mean <= mostOfSpread * spreadOf(stored);
    if (explains || finding.left->isRounding()) {
      finding.text += explanationText(finding, question, reach);
      return;
    }
    finding.explanation.reset();
    finding.left.reset();
  }
  if (spreadOf(stored) == 0.0)
    finding.text += "All values are " + shortNumber(finding.difference.stored) + ". ";
  finding.text +=
      "No kernel, quantity, shift, order of rows or scale that was tried explains the difference.";
}

}  // namespace

StoredFinding checkStored(const StoredQuestion& question, const Image<double>& stored,
                          const std::function<void()>& between) {
  const Channel channel = question.technique.channels()[std::size_t(question.channel)];
  const int reach = question.kernel.effectiveRadius();
  StoredFinding finding;
  finding.format = question.format;
  finding.heldBy = formatThatHolds(stored, channel, question.format);
  StoredAssumption own;
  own.kernel = question.kernel;
  StoredQuestion asHeld = question;
  asHeld.format = finding.heldBy;
  const StoredDifference found = storedDifference(expectedUnder(own, asHeld), stored, reach);
  finding.agrees = found.isRounding();
  finding.onlyAtEdges = !finding.agrees && found.notFinite == 0 && found.beyondInside == 0;
  finding.difference = found;
  if (finding.heldBy != finding.format) {
    finding.difference = storedDifference(expectedUnder(own, question), stored, reach);
    finding.difference.beyond = found.beyond;
    finding.difference.beyondInside = found.beyondInside;
  }
  std::string& text = finding.text;
  if (finding.heldBy != finding.format)
    text = "All values are numbers of " + std::string(nameOf(finding.heldBy)) + ". ";
  if (found.notFinite > 0)
    text += std::to_string(found.notFinite) +
            (found.notFinite == 1 ? " texel holds no number. " : " texels hold no number. ");
  if (found.texels == 0) {
    text += "There is nothing to compare.";
  } else if (found.beyond == 0) {
    text +=
        found.notFinite > 0 ? "The others agree."
        : found.largestUnits == 0.0
            ? "It agrees exactly."
            : "It agrees; what differs, " + roundingText(found.largestUnits, finding.heldBy) + ".";
  } else if (found.beyondInside == 0) {
    text += edgeText(reach);
  } else {
    explain(finding, asHeld, stored, between);
  }
  return finding;
}

}  // namespace umbra
