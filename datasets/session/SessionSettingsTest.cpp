#include "datasets/session/SessionSettings.h"

#include <gtest/gtest.h>

#include <set>

namespace umbra {
namespace {

TEST(SessionSettings, EveryNameIsThereOnce) {
  Session session;
  std::set<std::string_view> names;
  for (const Setting& setting : settingsOf(session))
    EXPECT_TRUE(names.insert(setting.info.name).second) << setting.info.name;
  for (std::string_view name : {"kernel.radius", "map.size", "read.filter", "bias.receiver-plane",
                                "light.position", "camera.view-angle", "picture.size", "view.mode"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(SessionSettings, WhatASceneBringsIsShownUntilItIsSet) {
  Session session;
  Light scenes;
  scenes.intensity = 3.0;
  scenes.position = {7, 8, 9};
  const std::vector<Setting> settings = settingsOf(session, scenes);
  const Setting& intensity = settingNamed(settings, "light.intensity", "x");
  EXPECT_EQ(intensity.text(), "3");
  EXPECT_FALSE(session.light);
  intensity.setFromText("5", "x");
  ASSERT_TRUE(session.light);
  EXPECT_EQ(session.light->intensity, 5.0);
  EXPECT_EQ(session.light->position, scenes.position);
  EXPECT_FALSE(session.camera);
}

TEST(SessionSettings, APicturesSizeIsWidthAndHeight) {
  Session session;
  const std::vector<Setting> settings = settingsOf(session);
  const Setting& size = settingNamed(settings, "picture.size", "x");
  EXPECT_EQ(size.text(), "1280x720");
  size.setFromText("640x480", "x");
  EXPECT_EQ(session.width, 640);
  EXPECT_EQ(session.height, 480);
}

TEST(SessionSettings, WhatBecomesStale) {
  const Session before;
  const auto stage = [&](auto change) {
    Session after = before;
    change(after);
    return firstStaleStage(before, after);
  };
  EXPECT_EQ(stage([](Session&) {}), Stage::Nothing);
  EXPECT_EQ(stage([](Session& s) { s.source.name = "spheres"; }), Stage::Depth);
  EXPECT_EQ(stage([](Session& s) { s.light = Light{}; }), Stage::Depth);
  EXPECT_EQ(stage([](Session& s) { s.technique = "msm"; }), Stage::Encode);
  EXPECT_EQ(stage([](Session& s) {
              setParameters(s, "vsm", {{"bleed-reduction", 0.2}});
            }),
            Stage::Encode);
  EXPECT_EQ(stage([](Session& s) {
              setParameters(s, "msm", {{"bleed-reduction", 0.2}});
            }),
            Stage::Nothing);
  EXPECT_EQ(stage([](Session& s) { s.frame.kernel.radius = 9; }), Stage::Prefilter);
  EXPECT_EQ(stage([](Session& s) { s.camera = Camera{}; }), Stage::Shade);
  EXPECT_EQ(stage([](Session& s) { s.width = 99; }), Stage::Shade);
  EXPECT_EQ(stage([](Session& s) { s.frame.view = ViewMode::Depth; }), Stage::Nothing);
  EXPECT_EQ(stage([](Session& s) { s.probe = Pixel{1, 2}; }), Stage::Nothing);
}

}  // namespace
}  // namespace umbra
