// What was measured in one run, and what it comes to.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/cost/Spread.h"

namespace umbra {

// Repeated measurements of several things, each under a name such as "vsm light".
class CostSamples {
 public:
  void add(const std::string& name, double value);
  void add(const CostSamples& others);
  bool has(std::string_view name) const { return find(name) != nullptr; }
  // All zero where the name has no measurement.
  Spread spread(std::string_view name) const;
  // In the order in which they were first added.
  std::vector<std::string> names() const;

 private:
  struct Row {
    std::string name;
    std::vector<double> values;
  };
  const Row* find(std::string_view name) const;

  std::vector<Row> rows_;
};

// What a ratio of two measurements, or one measurement alone, is to be.
struct CostGoal {
  std::string_view numerator;    // as in CostSamples: "vsm light"
  std::string_view denominator;  // "" where the numerator counts alone
  double most = 0.0;
  std::string_view unit;   // of a measurement alone: "s"
  std::string_view about;  // one line: what is compared, and what the papers say
};

// "vsm light / vtkShadowMapPass light".
std::string nameOf(const CostGoal& goal);

struct CostRatio {
  std::string name;
  double value = 0.0;  // the quotient of both medians; NaN where one of them was not measured
  std::optional<double> goal;
  std::string unit;

  // Whether a goal was met; one without a value is not.
  bool holds() const { return goal && value <= *goal; }
};

// Without the goal's limit where `limited` is false.
CostRatio ratioOf(const CostSamples& samples, const CostGoal& goal, bool limited = true);

// The names of the ratios that have a goal and miss it.
std::vector<std::string> missedIn(std::span<const CostRatio> ratios);

}  // namespace umbra
