#include "filters/core/settings/SettingsTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

// Every row of the three tables, bound to values that stand at their defaults.
struct Everything {
  FrameSettings frame;
  Light light;
  Camera camera;

  std::vector<Setting> settings() {
    std::vector<Setting> all;
    for (const auto& row : frameTable()) all.push_back(bound(row, frame));
    for (const auto& row : lightTable()) all.push_back(bound(row, light));
    for (const auto& row : cameraTable()) all.push_back(bound(row, camera));
    return all;
  }
};

// The values at the ends of what is right, and those just beyond.
struct Ends {
  std::vector<SettingValue> inside, beyond;
};

Ends endsOf(const SettingInfo& info) {
  const double above = std::nextafter(info.high, INFINITY),
               below = std::nextafter(info.low, -INFINITY);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  switch (info.kind) {
    case SettingKind::Switch:
      return {{false, true}, {1, 0.0, std::string("on")}};
    case SettingKind::Whole:
      return {{int(info.low), int(info.high)}, {int(info.low) - 1, int(info.high) + 1, 1.5, true}};
    case SettingKind::Number:
      return {{info.low, info.high}, {above, below, nan, std::string("1")}};
    case SettingKind::Choice: {
      Ends ends{{}, {std::string("none such"), std::string(), 0}};
      for (std::string_view choice : info.choices) ends.inside.push_back(std::string(choice));
      return ends;
    }
    case SettingKind::Point:
      return {{std::vector{info.low, info.high, 0.5}},
              {std::vector{0.5, above, 0.5}, std::vector{0.5, 0.5}, std::vector{0.5, nan, 0.5}, 1}};
    case SettingKind::Size:
      return {{std::vector{info.low, info.high}},
              {std::vector{info.low, above}, std::vector{info.low + 0.5, info.high}}};
    case SettingKind::Camera:
      return {
          {std::vector<double>(), std::vector{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0}},
          {std::vector{1.0, 2.0, 3.0}}};
  }
  return {};
}

std::string refusalOf(const std::function<void()>& set) {
  try {
    set();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadInput);
    return error.what();
  }
  return "accepted";
}

TEST(SettingsTable, NamesKeysAndNounsAreUniqueAndWhole) {
  Everything everything;
  std::set<std::string_view> names, keys, nouns;
  for (const Setting& setting : everything.settings()) {
    const SettingInfo& info = setting.info;
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_TRUE(keys.insert(info.key).second) << info.key;
    EXPECT_TRUE(nouns.insert(info.noun).second) << info.noun;
    EXPECT_TRUE(info.option.empty() || info.option.starts_with("--")) << info.name;
    for (std::string_view text : {info.title, info.noun, info.doc, info.group})
      EXPECT_FALSE(text.empty()) << info.name;
    EXPECT_NE(info.doc.back(), '.') << info.name;
    EXPECT_LE(info.low, info.high) << info.name;
  }
  EXPECT_EQ(names.size(), frameTable().size() + lightTable().size() + cameraTable().size());
}

TEST(SettingsTable, TextsOfChoicesAreAsManyAsTheyAre) {
  Everything everything;
  for (const Setting& setting : everything.settings()) {
    const SettingInfo& info = setting.info;
    const bool choice = info.kind == SettingKind::Choice;
    EXPECT_EQ(info.choices.empty(), !choice) << info.name;
    if (!info.choiceTitles.empty()) {
      EXPECT_EQ(info.choiceTitles.size(), info.choices.size()) << info.name;
    }
    EXPECT_EQ(info.pane.has_value(), !info.labels.empty()) << info.name;
    const std::size_t texts = choice                             ? info.choices.size()
                              : info.kind == SettingKind::Switch ? 2
                              : info.kind == SettingKind::Camera ? 2
                                                                 : 1;
    if (info.pane) {
      EXPECT_EQ(info.labels.size(), texts) << info.name;
    }
  }
}

TEST(SettingsTable, ADefaultIsTheStructuresOwnAndRight) {
  Everything everything;
  for (const Setting& setting : everything.settings()) {
    EXPECT_EQ(setting.get(), setting.defaultValue) << setting.info.name;
    EXPECT_EQ(checked(setting.info, setting.defaultValue, "x", "y"), setting.defaultValue);
    setting.setFromText(setting.text(), "x");
    EXPECT_EQ(setting.get(), setting.defaultValue) << setting.info.name;
  }
  EXPECT_EQ(everything.frame, FrameSettings{});
  EXPECT_EQ(everything.light, Light{});
  EXPECT_EQ(everything.camera, Camera{});
}

// Every value of an enumeration goes by the name that nameOf() gives it.
TEST(SettingsTable, ChoicesGoByTheirNames) {
  Everything all;
  const std::vector<Setting> settings = all.settings();
  const auto expectNames = [&]<class E>(std::string_view name, E& value) {
    const Setting& setting = settingNamed(settings, name, "x");
    for (std::size_t i = 0; i < setting.info.choices.size(); ++i) {
      value = E(i);
      EXPECT_EQ(setting.text(), nameOf(value)) << name;
    }
  };
  expectNames("kernel.shape", all.frame.kernel.shape);
  expectNames("map.format", all.frame.map.format);
  expectNames("read.filter", all.frame.read.filter);
  expectNames("read.sat-size", all.frame.read.satSize);
  expectNames("read.sat-precision", all.frame.read.satPrecision);
  expectNames("view.mode", all.frame.view);
  expectNames("light.kind", all.light.kind);
}

TEST(SettingsTable, TheEndsOfARangeAreTakenAndReadBack) {
  Everything everything;
  for (const Setting& setting : everything.settings())
    for (const SettingValue& value : endsOf(setting.info).inside) {
      setting.set(value, "x");
      EXPECT_EQ(setting.get(), value) << setting.info.name;
      setting.set(setting.defaultValue, "x");
      setting.setFromText(toText(setting.info, value), "x");
      EXPECT_EQ(setting.get(), value) << setting.info.name << " " << setting.text();
    }
}

TEST(SettingsTable, WhatIsBeyondIsRefusedByOneSentenceWhateverTheWay) {
  Everything everything;
  for (const Setting& setting : everything.settings())
    for (const SettingValue& value : endsOf(setting.info).beyond) {
      const SettingInfo& info = setting.info;
      const std::string found = "'" + toText(info, value) + "'";
      const std::string right = info.kind == SettingKind::Choice
                                    ? " is none of "
                                    : " is not right, it takes " + rightValues(info);
      const std::string bound = refusalOf([&] { setting.set(value, "file: key"); });
      EXPECT_EQ(bound.find("file: key: " + found + right), 0u) << bound;
      const auto* text = std::get_if<std::string>(&value);
      if (info.kind == SettingKind::Switch || (text && info.kind != SettingKind::Choice)) continue;
      EXPECT_EQ(refusalOf([&] { setting.setFromText(toText(info, value), "file: key"); }), bound);
    }
  EXPECT_EQ(everything.frame, FrameSettings{});
}

TEST(SettingsTable, SentencesSayWhatIsRight) {
  Everything everything;
  const std::vector<Setting> settings = everything.settings();
  const auto refused = [&](std::string_view name, std::string_view text) {
    return refusalOf([&] { settingNamed(settings, name, "x").setFromText(text, "--option"); });
  };
  EXPECT_EQ(refused("map.samples", "3"), "--option: '3' is not right, it takes 1, 2, 4 or 8");
  EXPECT_EQ(refused("kernel.radius", "65"),
            "--option: '65' is not right, it takes a whole number from 0 to 64");
  EXPECT_EQ(refused("kernel.radius", "1.5"), refused("kernel.radius", "65").replace(11, 2, "1.5"));
  EXPECT_EQ(refused("kernel.sigma", "0.009"),
            "--option: '0.009' is not right, it takes 0 for half the radius, or a number from "
            "0.01 to 1000");
  EXPECT_EQ(refused("kernel.sigma", "0"), "accepted");
  EXPECT_EQ(refused("read.filter", "mip"),
            "--option: 'mip' is none of point, bilinear, trilinear, anisotropic, sat");
  EXPECT_EQ(refused("bias.receiver-plane", "true"),
            "--option: 'true' is not right, it takes on or off, in a file true or false");
  for (const char* text : {"", "1,2", "1,2,", "1,2,3,", "1;2;3", "1,2,3,4"})
    EXPECT_EQ(refused("light.colour", text), "--option: '" + std::string(text) +
                                                 "' is not right, it takes X,Y,Z, in a file "
                                                 "[X, Y, Z], each a number from 0 to 1");
  EXPECT_EQ(refusalOf([&] { settingNamed(settings, "kernel.radios", "axis"); }),
            "axis: there is no setting 'kernel.radios'; did you mean 'kernel.radius'?");
}

// What each change of one setting makes stale, from settings in which all of them do something.
TEST(FirstStaleStage, IsTheRowsWhereItDoesSomething) {
  FrameSettings usual;
  usual.kernel.shape = KernelShape::Gaussian;
  for (const auto& row : frameTable()) {
    FrameSettings changed = usual;
    for (const SettingValue& value : endsOf(row.info).inside) {
      row.putInto(changed, value);
      if (row.idleIn(usual) || row.valueIn(changed) == row.valueIn(usual)) continue;
      const bool toTable = changed.read.filter == ReadFilter::SummedArea;
      EXPECT_EQ(firstStaleStage(usual, changed), toTable ? Stage::Prefilter : row.info.stage)
          << row.info.name;
    }
  }
  EXPECT_EQ(firstStaleStage(usual, usual), Stage::Nothing);
}

TEST(FirstStaleStage, IsNothingWhereASettingDoesNothing) {
  FrameSettings before;
  FrameSettings after = before;
  after.kernel.sigma = 2.0;
  after.read.anisotropy = 2;
  after.read.satPrecision = SatPrecision::Plain;
  after.map.cascades.seam = 0.3;
  EXPECT_EQ(firstStaleStage(before, after), Stage::Nothing);
  after.view = ViewMode::Error;
  EXPECT_EQ(firstStaleStage(before, after), Stage::Nothing);
  after.bias.slope = 2.0;
  EXPECT_EQ(firstStaleStage(before, after), Stage::Shade);
  after.map.cascades.count = 2;
  EXPECT_EQ(firstStaleStage(before, after), Stage::Depth);
}

TEST(FirstStaleStage, OfAKernelFollowsTheReadAndTheCascades) {
  FrameSettings before, after;
  after.kernel.radius = 5;
  EXPECT_EQ(firstStaleStage(before, after), Stage::Prefilter);
  for (FrameSettings* frame : {&before, &after}) frame->map.cascades.count = 3;
  EXPECT_EQ(firstStaleStage(before, after), Stage::Depth);
  for (FrameSettings* frame : {&before, &after}) {
    frame->map.cascades.count = 1;
    frame->read.filter = ReadFilter::SummedArea;
  }
  EXPECT_EQ(firstStaleStage(before, after), Stage::Shade);
  before.read.filter = ReadFilter::Bilinear;
  EXPECT_EQ(firstStaleStage(before, after), Stage::Prefilter);
}

TEST(FirstStaleStage, OfLightAndCamera) {
  const Light sun;
  Light other = sun;
  other.halfAngle = 20.0;  // a directional light has none
  EXPECT_EQ(firstStaleStage(sun, other), Stage::Nothing);
  other.intensity = 2.0;
  EXPECT_EQ(firstStaleStage(sun, other), Stage::Shade);
  other.kind = LightKind::Spot;
  EXPECT_EQ(firstStaleStage(sun, other), Stage::Depth);
  Camera camera;
  camera.viewAngle = 40.0;
  EXPECT_EQ(firstStaleStage(Camera{}, camera), Stage::Shade);
}

}  // namespace
}  // namespace umbra
