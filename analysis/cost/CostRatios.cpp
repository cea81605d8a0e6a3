#include "analysis/cost/CostRatios.h"

#include <limits>

namespace umbra {

void CostSamples::add(const std::string& name, double value) {
  for (Row& row : rows_) {
    if (row.name != name) continue;
    row.values.push_back(value);
    return;
  }
  rows_.push_back({name, {value}});
}

void CostSamples::add(const CostSamples& others) {
  for (const Row& row : others.rows_)
    for (double value : row.values) add(row.name, value);
}

const CostSamples::Row* CostSamples::find(std::string_view name) const {
  for (const Row& row : rows_)
    if (row.name == name) return &row;
  return nullptr;
}

Spread CostSamples::spread(std::string_view name) const {
  const Row* row = find(name);
  return row ? spreadOf(row->values) : Spread();
}

std::vector<std::string> CostSamples::names() const {
  std::vector<std::string> names;
  for (const Row& row : rows_) names.push_back(row.name);
  return names;
}

std::string nameOf(const CostGoal& goal) {
  std::string name(goal.numerator);
  if (!goal.denominator.empty()) name += " / " + std::string(goal.denominator);
  return name;
}

CostRatio ratioOf(const CostSamples& samples, const CostGoal& goal, bool limited) {
  CostRatio ratio{
      nameOf(goal), std::numeric_limits<double>::quiet_NaN(), {}, std::string(goal.unit)};
  if (limited) ratio.goal = goal.most;
  if (!samples.has(goal.numerator)) return ratio;
  const double numerator = samples.spread(goal.numerator).median;
  if (goal.denominator.empty())
    ratio.value = numerator;
  else if (samples.has(goal.denominator) && samples.spread(goal.denominator).median > 0.0)
    ratio.value = numerator / samples.spread(goal.denominator).median;
  return ratio;
}

std::vector<std::string> missedIn(std::span<const CostRatio> ratios) {
  std::vector<std::string> missed;
  for (const CostRatio& ratio : ratios)
    if (ratio.goal && !ratio.holds()) missed.push_back(ratio.name);
  return missed;
}

}  // namespace umbra
