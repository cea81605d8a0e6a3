#include "datasets/session/file/SessionFileCompare.h"

#include <nlohmann/json.hpp>

#include "datasets/session/PaneChoice.h"
#include "datasets/session/file/SessionFileCheck.h"

namespace umbra {
namespace {

TEST(SessionFileCompare, ComparisonsWithoutPanesAreRefused) {
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("compare": {"mode": "half"})")),
            "s.json: compare.mode: 'half' is not right, it takes single, wipe or grid");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("compare": {"techniques": ["vsm", "vsmm"]})")),
            "s.json: compare.techniques[2]: there is no technique vsmm");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("compare": {"techniques": ["vsm", "vsm"]})")),
            "s.json: compare.techniques[2]: has vsm twice, each is compared once unless \"panes\" "
            "set it apart");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("compare": {"techniques": ["vsm"]})")),
            "s.json: compare.techniques: there are 1, two to six are compared");
  EXPECT_EQ(sessionErrorOf(sessionWith(R"("compare": {"wipe": 2})")),
            "s.json: compare.wipe: 2 is not right, it takes a number from 0 to 1");
}

// Two panes of one technique, of which the active one has everything of its own.
Workspace comparingSettings() {
  Workspace workspace = unusualWorkspace();
  workspace.shared.technique = "csm";
  workspace.shared.frame.read.filter = ReadFilter::Bilinear;
  workspace.comparison = {ComparisonMode::Grid, linkedPanes({"csm", "power-cdf", "msm"}), 0, 0.375};
  setOwn(workspace, 1, PaneSetting::Format, true);
  workspace.comparison.panes[1].own.values["map.format"] = std::string("unorm16");
  duplicatePane(workspace, 0);
  editSession(workspace, [](Session& active) {
    active.frame.kernel = {KernelShape::Box, 12, 0.0};
    active.frame.read = {ReadFilter::Anisotropic, 16, SatSize::Fixed, SatPrecision::Integer, 2.5};
    active.frame.bias = {0.0, 0.5, true, false};
    active.frame.map = {256, StorageFormat::Float, 1, {}};
    setParameters(active, "csm", {{"terms", 4}});
  });
  return workspace;
}

TEST(SessionFileCompare, SettingsOfPanesSurvive) {
  const Workspace workspace = comparingSettings();
  const Workspace read = workspaceFromText(written(workspace), "s.json");
  EXPECT_EQ(read, workspace);
  for (std::size_t pane = 0; pane < workspace.comparison.panes.size(); ++pane)
    EXPECT_EQ(sessionOfPane(read, pane).frame, sessionOfPane(workspace, pane).frame) << pane;
  // Whichever of them is active.
  for (const std::size_t pane : {0u, 2u}) {
    Workspace other = workspace;
    activatePane(other, pane);
    EXPECT_EQ(workspaceFromText(written(other), "s.json"), other);
  }
  Workspace fresh = unusualWorkspace();
  fresh.comparison.mode = ComparisonMode::Grid;
  duplicatePane(fresh, 1);
  EXPECT_EQ(workspaceFromText(written(fresh), "s.json"), fresh);
}

TEST(SessionFileCompare, EverySettingOfAPaneSurvivesByItself) {
  for (int i = 0; i <= int(PaneSetting::Bias); ++i)
    for (const std::size_t pane : {0u, 1u}) {
      Workspace workspace = unusualWorkspace();
      setOwn(workspace, pane, PaneSetting(i), true);
      const Workspace read = workspaceFromText(written(workspace), "s.json");
      EXPECT_EQ(read, workspace) << i;
      EXPECT_TRUE(hasOwn(read.comparison.panes[pane], PaneSetting(i))) << i;
    }
}

// Where a file lists techniques, the session's technique alone says which pane is active.
TEST(SessionFileCompare, ATechniqueChosenBesideTheListStandsWhereTheActivePaneWas) {
  Workspace workspace = unusualWorkspace();
  workspace.shared.technique = "lvsm";
  workspace.comparison = {ComparisonMode::Grid, linkedPanes({"vsm", "lvsm", "evsm4", "msm"}), 1,
                          0.375};
  setMode(workspace, ComparisonMode::Single);
  chooseTechnique(workspace, "csm");
  Workspace read = workspaceFromText(written(workspace), "s.json");
  EXPECT_EQ(read.shared.technique, "csm");
  EXPECT_EQ(read.comparison.active, 1u);
  EXPECT_EQ(comparisonOf(read), comparisonOf(workspace));
  for (Workspace* each : {&workspace, &read}) setMode(*each, ComparisonMode::Grid);
  EXPECT_EQ(read, workspace);
  EXPECT_EQ(read.comparison.panes, linkedPanes({"vsm", "csm", "evsm4", "msm"}));
}

TEST(SessionFileCompare, AFileHasWhatPanesShareAndWhatIsTheirOwn) {
  const auto json = toJson(comparingSettings());
  EXPECT_EQ(json.at("frame").at("kernel").at("radius"), 7);
  EXPECT_EQ(json.at("parameters").at("csm").at("terms"), 8);
  const auto& panes = json.at("compare").at("panes");
  EXPECT_EQ(panes.at(0).dump(), R"({"technique":"csm"})");
  EXPECT_EQ(panes.at(1).at("active"), true);
  EXPECT_EQ(panes.at(1).at("kernel").at("radius"), 12);
  EXPECT_EQ(panes.at(1).at("parameters").dump(), R"({"terms":4})");
  EXPECT_EQ(panes.at(2).dump(), R"({"technique":"power-cdf","format":"unorm16"})");
}

TEST(SessionFileCompare, WhatAPaneDoesNotSayItShares) {
  const Workspace workspace = workspaceFromText(
      sessionWith(R"("frame": {"mapSize": 512, "kernel": {"shape": "gaussian", "radius": 3}},
        "compare": {"mode": "grid", "panes": [
          {"technique": "vsm"}, {"technique": "vsm", "kernel": {"radius": 12}}]})"),
      "s.json");
  EXPECT_EQ(workspace.comparison.active, 0u);
  const Session second = sessionOfPane(workspace, 1);
  EXPECT_EQ(second.frame.kernel, (Kernel{KernelShape::Gaussian, 12, 0.0}));
  EXPECT_EQ(second.frame.map.size, 512);
  EXPECT_FALSE(hasOwn(workspace.comparison.panes[1], PaneSetting::MapSize));
  EXPECT_FALSE(hasOwn(workspace.comparison.panes[1], PaneSetting::Parameters));
}

TEST(SessionFileCompare, PanesThatCannotBeAreRefused) {
  const auto panesError = [](const std::string& panes) {
    return sessionErrorOf(sessionWith(R"("compare": {"panes": [)" + panes + "]}"));
  };
  const std::string vsm = R"({"technique": "vsm"}, )";
  EXPECT_EQ(panesError(vsm + R"({"technique": "vsn"})"),
            "s.json: compare.panes[2].technique: there is no 'vsn'; did you mean 'vsm'?");
  EXPECT_EQ(panesError(vsm + R"({"kernel": {"radius": 2}})"),
            "s.json: compare.panes[2]: needs a \"technique\"");
  EXPECT_EQ(panesError(vsm + R"({"technique": "vsm", "kernel": {"radius": 200}})"),
            "s.json: compare.panes[2].kernel.radius: 200 is not right, it takes a whole number "
            "from 0 to 64");
  EXPECT_EQ(panesError(vsm + R"({"technique": "vsm", "parameters": {"bleed-reductoin": 0.3}})"),
            "s.json: compare.panes[2].parameters.bleed-reductoin: there is no parameter "
            "'bleed-reductoin'; did you mean 'bleed-reduction'?");
  EXPECT_EQ(panesError(vsm + R"({"technique": "lvsm",
                                 "parameters": {"splits": [0.2, 0.5], "layers": 7}})"),
            "s.json: compare.panes[2].parameters.layers: '7' contradicts the other parameters, "
            "which make it '3'");
  EXPECT_EQ(panesError(vsm + R"({"technique": "vsm", "view": "error"})")
                .find("s.json: compare.panes[2].view: there is no such key"),
            0u);
  EXPECT_EQ(panesError(vsm + R"("msm")"),
            "s.json: compare.panes[2]: \"msm\" should be an object {…}");
  EXPECT_EQ(panesError(R"({"technique": "vsm"})"),
            "s.json: compare.panes: there are 1, two to six are compared");
  EXPECT_EQ(panesError(R"({"technique": "vsm", "active": true}, )" +
                       std::string(R"({"technique": "vsm", "active": true})")),
            "s.json: compare.panes[2].active: one before it is active, only one can be");
  EXPECT_EQ(panesError(vsm + R"({"technique": "msm", "active": true})"),
            "s.json: compare.panes[2]: should show vsm, which \"technique\" says");
  EXPECT_EQ(panesError(R"({"technique": "msm"}, {"technique": "esm"})"),
            "s.json: compare.panes: should show vsm, which \"technique\" says");
  EXPECT_EQ(sessionErrorOf(sessionWith(
                R"("compare": {"techniques": ["vsm", "msm"], "panes": [{"technique": "vsm"}]})")),
            "s.json: compare.panes[1]: \"techniques\" has the panes, it takes one of the two");
}

}  // namespace
}  // namespace umbra
