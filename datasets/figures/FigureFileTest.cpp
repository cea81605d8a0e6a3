// Figures as files: which are read, and which are refused with file and key.
#include "datasets/figures/FigureFile.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "datasets/figures/FigureCatalogue.h"
#include "datasets/figures/FigureMeasures.h"
#include "datasets/json/EmbeddedFiles.h"
#include "datasets/plans/SweepCell.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

using Json = nlohmann::ordered_json;

Json sampleFigure() {
  return Json::parse(R"({
    "format": "umbrascope-figure/1", "name": "paper-1", "paper": "Somebody 2001",
    "number": "figure 1", "title": "A title", "states": ["one", "two"],
    "base": {"source": {"scene": "two-planes"}, "size": [64, 36]},
    "cells": [{"name": "vsm", "label": "VSM", "set": {"technique": "vsm", "scene.occluder": 0.3}},
              {"name": "pcf", "set": {"technique": "pcf"}}],
    "measures": ["compare", "cost"],
    "columns": ["bleeding", "cost.shadeMs"],
    "claims": [{"text": "More", "cell": "vsm", "measure": "bleeding", "minus": {"cell": "pcf"},
                "relation": ">", "stated": 0},
               {"text": "Faster", "cell": "vsm", "measure": "cost.shadeMs",
                "over": {"cell": "pcf", "measure": "cost.frameMs"}, "relation": "≈",
                "stated": 0.5, "tolerance": 0.1, "partly": 0.2}]})");
}

// What is wrong with the sample after `change`.
template <class Change>
std::string figureRefusal(const Change& change) {
  Json json = sampleFigure();
  change(json);
  try {
    figureFromText(json.dump(), "f.json", {});
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
    EXPECT_TRUE(std::string_view(error.what()).starts_with("f.json")) << error.what();
    return error.what();
  }
  return "no error";
}

void expectIn(const std::string& text, const char* part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(FigureFile, ReadsCellsMeasuresAndClaims) {
  const Figure figure = figureFromText(sampleFigure().dump(), "f.json", {});
  EXPECT_EQ(figure.name, "paper-1");
  EXPECT_EQ(figure.states, "one\ntwo");
  ASSERT_EQ(figure.cells.size(), 2u);
  EXPECT_EQ(figure.cells[0].label, "VSM");
  EXPECT_EQ(figure.cells[1].label, "pcf") << "a cell's label is its name unless it has one";
  const Session first = sessionOfCell(figure.plan, 0, allTechniques(), {}, "f.json");
  EXPECT_EQ(first.technique, "vsm");
  EXPECT_EQ(first.source.parameters.at("occluder"), 0.3);
  ASSERT_EQ(figure.claims.size(), 2u);
  EXPECT_EQ(describe(figure, figure.claims[0]), "bleeding of VSM − bleeding of pcf");
  EXPECT_EQ(describe(figure, figure.claims[1]), "cost.shadeMs of VSM ÷ cost.frameMs of pcf");
  EXPECT_EQ(figure.claims[1].tolerance, 0.1);
  EXPECT_EQ(figure.claims[1].partly, 0.2);
}

TEST(FigureFile, WhatIsLeftOutNeedsNothingButTheReason) {
  Json json = sampleFigure();
  for (const char* key : {"base", "cells", "measures", "columns", "claims"}) json.erase(key);
  expectIn(figureRefusal([&](Json& all) { all = json; }), "needs 'cells', or 'leftOut'");
  json["leftOut"] = "It is a drawing.";
  EXPECT_EQ(figureFromText(json.dump(), "f.json", {}).leftOut, "It is a drawing.");
  expectIn(figureRefusal([](Json& all) { all["leftOut"] = "but it has cells"; }), "base");
}

TEST(FigureFile, NamesWhatIsWrong) {
  expectIn(figureRefusal([](Json& all) { all["format"] = "umbrascope-lesson/1"; }), "no figure");
  expectIn(figureRefusal([](Json& all) { all["name"] = "../up"; }), "name: '../up'");
  expectIn(figureRefusal([](Json& all) { all.erase("states"); }), "needs a text 'states'");
  expectIn(figureRefusal([](Json& all) { all["claim"] = 1; }), "claims");
  expectIn(figureRefusal([](Json& all) { all["claims"] = Json::array(); }), "'claims'");
  expectIn(figureRefusal([](Json& all) { all["cells"][1]["name"] = "vsm"; }), "another cell");
  expectIn(figureRefusal([](Json& all) { all["cells"][0]["set"]["vsm.variance"] = 1; }),
           "min-variance");
  expectIn(figureRefusal([](Json& all) { all["measures"] = {"compare"}; }), "needs 'cost'");
  expectIn(figureRefusal([](Json& all) { all["columns"] = {"bleding"}; }), "'bleeding'");
  const auto claim = [](const char* key, const Json& value) {
    return figureRefusal([&](Json& all) { all["claims"][1][key] = value; });
  };
  expectIn(claim("cell", "esm"), "there is no cell 'esm'");
  expectIn(claim("measure", "probe.visibility"), "needs 'probe'");
  expectIn(claim("minus", {{"cell", "pcf"}}), "'over' excludes 'minus'");
  expectIn(claim("relation", "="), "no relation");
  expectIn(claim("tolerance", 0), "above 0");
  expectIn(claim("partly", 0.05), "wider");
  expectIn(claim("verdict", "holds"), "verdict");
  expectIn(figureRefusal([](Json& all) { all["claims"][0].erase("stated"); }), "'stated'");
}

TEST(FigureCatalogue, FilesAreCalledAsTheirFigures) {
  std::set<std::string> names;
  for (const EmbeddedFile& file : embeddedFigures()) {
    const Figure figure = figureFromText(file.text, file.name, {});
    EXPECT_EQ(figure.name + ".json", file.name);
    names.insert(figure.name);
  }
  EXPECT_EQ(names.size(), embeddedFigures().size());
  EXPECT_GT(names.size(), 30u);
}

TEST(FigureCatalogue, NumbersAreInTheirOrder) {
  std::vector<std::string> names;
  for (const Figure& figure : figureCatalogue()) names.push_back(figure.name);
  const auto placeOf = [&](const char* name) {
    const auto found = std::find(names.begin(), names.end(), name);
    EXPECT_NE(found, names.end()) << name;
    return found;
  };
  EXPECT_LT(placeOf("annen-9"), placeOf("annen-10"));
  EXPECT_LT(placeOf("lauritzen-3.5"), placeOf("lauritzen-4.1"));
}

TEST(FigureCatalogue, RefusesUnknownNamesWithTheNearest) {
  try {
    figureNamed("lauritzen-4.55");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadCommandLine);
    expectIn(error.what(), "did you mean 'lauritzen-4.5'?");
  }
}

}  // namespace
}  // namespace umbra
