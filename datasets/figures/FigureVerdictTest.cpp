// Verdicts are computed of what is measured, what is stated and two tolerances.
#include "datasets/figures/FigureVerdict.h"

#include <gtest/gtest.h>

#include <limits>

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;

FigureClaim claimThat(Relation relation, double stated, double tolerance, double partly) {
  FigureClaim claim;
  claim.relation = relation;
  claim.stated = stated;
  claim.tolerance = tolerance;
  claim.partly = partly;
  return claim;
}

TEST(FigureVerdict, NearHoldsWithinTheTolerance) {
  const FigureClaim claim = claimThat(Relation::Near, 2.0, 0.25, 0.5);
  EXPECT_EQ(verdictOn(claim, 2.25), Verdict::Holds);
  EXPECT_EQ(verdictOn(claim, 1.75), Verdict::Holds);
  EXPECT_EQ(verdictOn(claim, 2.375), Verdict::Partly);
  EXPECT_EQ(verdictOn(claim, 1.5), Verdict::Partly);
  EXPECT_EQ(verdictOn(claim, 2.625), Verdict::Fails);
  EXPECT_EQ(verdictOn(claim, 0.0), Verdict::Fails);
}

TEST(FigureVerdict, LessAndGreaterAreStrictWithoutATolerance) {
  const FigureClaim less = claimThat(Relation::Less, 1.0, 0.0, 0.0);
  EXPECT_EQ(verdictOn(less, 0.5), Verdict::Holds);
  EXPECT_EQ(verdictOn(less, 1.0), Verdict::Fails);
  EXPECT_EQ(verdictOn(less, 1.5), Verdict::Fails);
  const FigureClaim greater = claimThat(Relation::Greater, 1.0, 0.0, 0.0);
  EXPECT_EQ(verdictOn(greater, 1.5), Verdict::Holds);
  EXPECT_EQ(verdictOn(greater, 1.0), Verdict::Fails);
  EXPECT_EQ(verdictOn(greater, 0.5), Verdict::Fails);
}

TEST(FigureVerdict, TolerancesWidenLessAndGreater) {
  const FigureClaim less = claimThat(Relation::Less, 1.0, 0.25, 0.5);
  EXPECT_EQ(verdictOn(less, 1.25), Verdict::Holds);
  EXPECT_EQ(verdictOn(less, 1.5), Verdict::Partly);
  EXPECT_EQ(verdictOn(less, 1.625), Verdict::Fails);
  const FigureClaim greater = claimThat(Relation::Greater, 1.0, 0.0, 0.5);
  EXPECT_EQ(verdictOn(greater, 1.0), Verdict::Partly);
  EXPECT_EQ(verdictOn(greater, 0.5), Verdict::Partly);
  EXPECT_EQ(verdictOn(greater, 0.25), Verdict::Fails);
}

TEST(FigureVerdict, NothingHoldsOfNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto relation : {Relation::Less, Relation::Greater, Relation::Near})
    EXPECT_EQ(verdictOn(claimThat(relation, 1.0, 0.5, 1.0), nan), Verdict::Fails);
}

TEST(FigureVerdict, TakesMeasuresOfCells) {
  const std::vector<Json> rows{
      Json::parse(R"({"compare": {"bleeding": 0.25, "decomposition": {"bleeding": 0.125}},
                      "probe": {"visibility": 0.5}, "cost": {"bakeMs": 2, "shadeMs": 1}})"),
      Json::parse(R"({"compare": {"bleeding": 0}, "reason": "why"})")};
  FigureClaim claim = claimThat(Relation::Near, 0.0, 0.001, 0.0);
  const auto measured = [&](const char* left, FigureOperation operation, FigureQuantity right) {
    claim.left = {0, left};
    claim.operation = operation;
    claim.right = std::move(right);
    return verdictOn(claim, rows).measured;
  };
  EXPECT_EQ(measured("bleeding", FigureOperation::None, {}), 0.25);
  EXPECT_EQ(measured("decomposition.bleeding", FigureOperation::None, {}), 0.125);
  EXPECT_EQ(measured("probe.visibility", FigureOperation::None, {}), 0.5);
  EXPECT_EQ(measured("cost.frameMs", FigureOperation::None, {}), 3.0);
  EXPECT_EQ(measured("cost.frameMs", FigureOperation::Over, {0, "cost.bakeMs"}), 1.5);
  EXPECT_EQ(measured("bleeding", FigureOperation::Minus, {1, "bleeding"}), 0.25);
  EXPECT_EQ(measured("bleeding", FigureOperation::Over, {1, "bleeding"}), std::nullopt)
      << "nothing is divided by 0";
  EXPECT_EQ(measured("bleeding", FigureOperation::Minus, {1, "cost.shadeMs"}), std::nullopt)
      << "the cell has no cost";
  EXPECT_EQ(verdictOn(claim, rows).verdict, Verdict::Fails);
}

}  // namespace
}  // namespace umbra
