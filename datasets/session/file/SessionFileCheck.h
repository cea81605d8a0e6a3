// What the tests of session files share.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "datasets/session/PaneEditing.h"
#include "datasets/session/file/SchemaCheck.h"
#include "datasets/session/file/SessionFile.h"
#include "datasets/session/file/SessionSchema.h"
#include "filters/core/support/Error.h"

namespace umbra {

// Every member away from its default.
inline Workspace unusualWorkspace() {
  Workspace workspace;
  Session& session = workspace.shared;
  session.source.name = "three-planes";
  session.source.parameters = {{"a", 0.1}, {"b", 0.5}};
  session.light = Light{LightKind::Spot, {1, 2, 3}, {0.1, 0.2, 0.3}, 45.5, {1, 0.9, 0.8}, 2.5};
  session.camera = Camera{{4, 5, 6}, {1, 0, 1}, {0, 0, 1}, 42.0};
  session.frame.map = {
      512, StorageFormat::Half, 4, {3, 0.75, 0.2, Camera{{7, 8, 9}, {1, 2, 3}, {0, 0, 1}, 33.0}}};
  session.frame.kernel = {KernelShape::Gaussian, 7, 2.25};
  session.frame.read = {ReadFilter::SummedArea, 5, SatSize::Distance, SatPrecision::Plain, 12.5};
  session.frame.bias = {1e-3, 2.0, false, true};
  session.frame.view = ViewMode::Error;
  session.frame.errorRange = 0.25;
  session.technique = "power-cdf";
  session.parameters = {{"vsm", {{"min-variance", 1.0 / 3.0 * 1e-3}}},
                        {"csm", {{"terms", 8}, {"mode", std::string("scale")}}}};
  workspace.comparison = {ComparisonMode::Wipe, linkedPanes({"csm", "power-cdf", "msm"}), 1, 0.375};
  session.width = 640;
  session.height = 480;
  session.probe = Pixel{17, 23};
  session.receiver = 0.1 + 0.2;
  session.probes = {{"Bench", Eigen::Vector3d(1.0 / 3.0, -2, 0.1), {}, 0.25},
                    {"Ast über \"Bank\"", Eigen::Vector3d(0, 1e8, 0), {}, {}}};
  session.keptProbe = "Bench";
  return workspace;
}

// Writes the workspace as a file and checks the file against its schema.
inline std::string written(const Workspace& workspace) {
  EXPECT_EQ(schemaFault(sessionSchema(), toJson(workspace), "session"), "");
  return toText(workspace);
}

// The message of the error that reading `text` ends in.
inline std::string sessionErrorOf(const std::string& text) {
  try {
    workspaceFromText(text, "s.json");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "no error";
}

inline std::string sessionWith(const std::string& members) {
  return R"({"format": "umbrascope-session/1", )" + members + "}";
}

}  // namespace umbra
