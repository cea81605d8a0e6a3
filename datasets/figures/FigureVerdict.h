// Whether what is measured is what a paper states.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "datasets/figures/Figure.h"

namespace umbra {

enum class Verdict { Holds, Partly, Fails };
// "holds", "partly" or "fails", as reports have it.
const char* nameOf(Verdict verdict);

struct ClaimVerdict {
  // Nothing where a cell has no such figure, or is divided by 0; then the claim fails.
  std::optional<double> measured;
  Verdict verdict = Verdict::Fails;
};

// The verdict on a value; see FigureClaim for its tolerances.
Verdict verdictOn(const FigureClaim& claim, double measured);
// `rows` are those of the figure's cells.
ClaimVerdict verdictOn(const FigureClaim& claim, std::span<const nlohmann::ordered_json> rows);

}  // namespace umbra
