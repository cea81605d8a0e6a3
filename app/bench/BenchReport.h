// What a bench found, as JSON, as files and for people.
#pragma once

#include <string>
#include <vector>

#include "app/bench/FrameRounds.h"
#include "app/output/Output.h"

namespace umbra {

struct BenchReport {
  std::string scene;
  LightKind light = LightKind::Directional;
  int width = 0, height = 0;  // of the pictures
  std::vector<Drawing> cases;
  FrameRoundsResult frames;  // of the cases, in their order
  CostSamples analysis;      // of what needs no GPU
  std::vector<CostRatio> ratios;
};

// "umbrascope-bench/1". Every "ms" is [first quartile, median, third quartile].
Json benchToJson(const BenchReport& report);

// bench.json, and bench.csv with a row for each case and baseline.
void writeBench(OutputFolder& folder, const BenchReport& report);

// For people.
std::string benchText(const BenchReport& report);

}  // namespace umbra
