#include "datasets/figures/FigureVerdict.h"

#include <cmath>

#include "datasets/figures/FigureMeasures.h"

namespace umbra {
namespace {

std::optional<double> measuredOf(const FigureClaim& claim,
                                 std::span<const nlohmann::ordered_json> rows) {
  const auto left = measureIn(rows[claim.left.cell], claim.left.measure);
  if (!left || claim.operation == FigureOperation::None) return left;
  const auto right = measureIn(rows[claim.right.cell], claim.right.measure);
  if (!right) return {};
  if (claim.operation == FigureOperation::Minus) return *left - *right;
  if (*right == 0.0) return {};
  return *left / *right;
}

}  // namespace

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Holds:
      return "holds";
    case Verdict::Partly:
      return "partly";
    case Verdict::Fails:
      break;
  }
  return "fails";
}

Verdict verdictOn(const FigureClaim& claim, double measured) {
  const double above = measured - claim.stated;
  const bool isNear = claim.relation == Relation::Near;
  const double off = isNear                                ? std::abs(above)
                     : claim.relation == Relation::Greater ? -above
                                                           : above;
  // Equal values stand in neither < nor >, unless a tolerance says so.
  if (off < 0.0 || (off <= claim.tolerance && (isNear || claim.tolerance > 0.0)))
    return Verdict::Holds;
  return claim.partly > 0.0 && off <= claim.partly ? Verdict::Partly : Verdict::Fails;
}

ClaimVerdict verdictOn(const FigureClaim& claim, std::span<const nlohmann::ordered_json> rows) {
  ClaimVerdict result{measuredOf(claim, rows), Verdict::Fails};
  if (result.measured) result.verdict = verdictOn(claim, *result.measured);
  return result;
}

}  // namespace umbra
