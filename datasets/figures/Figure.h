// A figure or table of a paper as data: what the paper states, the cells that this program draws
// for it, and claims that are computed of what is measured there. As JSON:
//
// {"format": "umbrascope-figure/1",
//  "name": "lauritzen-3.5", "paper": "Lauritzen 2008", "number": "figure 3.5",
//  "title": "A tree's penumbra bleeds through the bench",
//  "states": "…",          what the paper says of it, in our words: Markdown, a text or its lines
//  "differs": "…",         how what we draw differs from what the paper drew: likewise
//  "base": {"source": {"scene": "tree-bench"}, "size": [320, 180]},           a session
//  "cells": [{"name": "vsm", "label": "VSM",
//             "set": {"technique": "vsm"}}],       what axes of a sweep set
//  "measures": ["compare", "picture"],             as of a sweep
//  "columns": ["bleeding"],                        of the table of what is measured
//  "claims": [{"text": "…", "cell": "vsm", "measure": "bleeding",
//              "over": {"cell": "pcf"},            or "minus"; its "measure" is the same if absent
//              "relation": "<", "stated": 1, "tolerance": 0, "partly": 0.1}]}
//
// A figure that is not done has "leftOut", the reason, from "base" on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "datasets/json/Relation.h"
#include "datasets/plans/SweepPlan.h"

namespace umbra {

struct FigureCell {
  std::string name;   // of claims and files: "csm-16"
  std::string label;  // of tables and pictures: "CSM, M = 16"
};

// A measure of one cell: see FigureMeasures.h.
struct FigureQuantity {
  std::size_t cell = 0;
  std::string measure;
};

enum class FigureOperation { None, Over, Minus };

// `left`, or left ÷ right, or left − right, stands in `relation` to what the paper states.
struct FigureClaim {
  std::string text;
  FigureQuantity left, right;
  FigureOperation operation = FigureOperation::None;
  Relation relation = Relation::Near;
  double stated = 0.0;
  // How far off, in the units of `stated`, the claim still holds, and holds in part. With < and >
  // the distance on the right side is none, and with a tolerance of 0 equal values do not hold.
  double tolerance = 0.0, partly = 0.0;
};

struct Figure {
  std::string name, paper, number, title;
  std::string argument;         // what `reproduce` takes for it: its name, or its file
  std::string states, differs;  // Markdown
  std::string leftOut;          // why it is not done; then nothing below is set
  SweepPlan plan;
  std::vector<FigureCell> cells;  // of the plan, in its order
  std::vector<std::string> columns;
  std::vector<FigureClaim> claims;
};

// "bleeding of VSM ÷ bleeding of PCF": for tables.
std::string describe(const Figure& figure, const FigureClaim& claim);

}  // namespace umbra
