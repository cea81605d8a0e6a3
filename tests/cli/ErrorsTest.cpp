// Every error that a person can make: it has its exit status, and one line that says what is right.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

class Errors : public testing::Test {
 protected:
  Errors() { writeMap(map, smallMap()); }

  // Runs and expects failure with `status`, nothing on standard output, and one line on standard
  // error that contains `text`.
  void expectError(int status, const std::string& text, const Arguments& arguments,
                   const Setting& setting = {}) const {
    const Outcome outcome = run(arguments, setting);
    std::string line;
    for (const std::string& argument : arguments) line += " " + argument;
    EXPECT_EQ(outcome.status, status) << line << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << line;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << line << "\n"
                                                                           << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << line << "\n" << outcome.err;
  }

  // A valid probe with `more` behind it.
  Arguments probe(const Arguments& more) const {
    Arguments arguments{"probe", "--json", "--depth", map, "--texel", "8,9", "--receiver", "0.7"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  TemporaryFolder folder;
  const std::string map = folder.file("m.exr");
};

TEST_F(Errors, WordsThatAreNoCommandOrOption) {
  expectError(2, "did you mean 'probe'?", {"prob"});
  expectError(2, "did you mean 'three-planes'?", {"three-plans"});
  expectError(2, "is no command, scene or file", {"publish", "-o", folder.file("out")});
  expectError(2, "is no command, scene or file", {"reticulate"});
  expectError(2, "did you mean '--technique'?", probe({"--techniqe", "vsm"}));
  expectError(2, "did you mean '--depth'?", {"probe", "--dep", map});
  expectError(2, "is not expected here", probe({"stray"}));
  expectError(2, "--json: is not expected before `probe`", {"--json", "probe", "--depth", map});
  expectError(2, "go after the command", {"--radius", "2", "techniques"});
}

TEST_F(Errors, ValuesOfOptions) {
  expectError(2, "did you mean 'vsm'?", probe({"--technique", "vsn"}));
  expectError(2, "--technique", probe({"--technique", ","}));
  expectError(2, "did you mean 'min-variance'?", probe({"--set", "vsm.min-varianc=1e-6"}));
  expectError(2, "from 0 to 0.99", probe({"--set", "vsm.bleed-reduction=1.5"}));
  expectError(2, "a number", probe({"--set", "vsm.bleed-reduction=much"}));
  expectError(2, "TECHNIQUE.PARAMETER=VALUE", probe({"--set", "vsm=1"}));
  expectError(2, "NAME=VALUE", probe({"--set", "vsm.min-variance"}));
  expectError(2, "--kernel: 'Box' is none of none, box, gaussian", probe({"--kernel", "Box"}));
  expectError(2, "--radius", probe({"--radius", "-1"}));
  expectError(2, "from 0 to 64", probe({"--radius", "65"}));
  for (const char* sigma : {"nan", "1e-200", "0.009", "1001"})
    expectError(2, "--sigma: ", probe({"--sigma", sigma}));
  expectError(2, "--format: 'quarter' is none of", probe({"--format", "quarter"}));
  expectError(2, "--bins", probe({"--bins", "0"}));
  expectError(2, "--samples", probe({"--samples", "1"}));
  expectError(2, "--depth-range", probe({"--depth-range", "5,5"}));
  expectError(2, "--depth-range", probe({"--depth-range", "-1e308,1e308"}));
  expectError(2, "--depth: '' is not right", {"probe", "--depth", ""});
  expectError(2, "--scene: '' is not right", {"probe", "--scene", "", "--pixel", "1,1"});
  expectError(2, "--session: '' is not right", {"probe", "--session", "", "--pixel", "1,1"});
  expectError(2, "--map-size", probe({"--map-size", "7"}));
  expectError(2, "--size", probe({"--size", "640*480"}));
  expectError(2, "--view: 'pretty' is none of shaded, visibility", probe({"--view", "pretty"}));
}

TEST_F(Errors, ValuesOfReadsAndMaps) {
  for (const char* samples : {"0", "3", "16", "4x"})
    expectError(2, "--msaa: '" + std::string(samples) + "' is not right, it takes 1, 2, 4 or 8",
                probe({"--msaa", samples}));
  for (const char* count : {"0", "5"}) expectError(2, "from 1 to 4", probe({"--cascades", count}));
  for (const char* most : {"0", "17"})
    expectError(2, "from 1 to 16", probe({"--anisotropy", most}));
  expectError(2, "point, bilinear, trilinear, anisotropic, sat", probe({"--filter", "mip"}));
  expectError(2, "--split-lambda", probe({"--split-lambda", "1.01"}));
  expectError(2, "--cascade-seam", probe({"--cascade-seam", "0.51"}));
  expectError(2, "footprint, distance, fixed", probe({"--sat-size", "wide"}));
  expectError(2, "centred, integer, plain", probe({"--sat-precision", "half"}));
  expectError(2, "--sat-distance", probe({"--sat-distance", "-1"}));
}

// A combination that cannot be composed is refused with its reason, before anything is drawn.
TEST_F(Errors, CombinationsThatCannotBe) {
  const auto render = [&](const Arguments& more) {
    Arguments arguments{"render", "--scene",  "two-planes",        "--filter",
                        "sat",    "--output", folder.file("p.png")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  expectError(2, "--filter sat: a table of sums has no minima and maxima, which power-cdf needs",
              render({"--technique", "power-cdf"}));
  expectError(2, "--filter sat: a summed-area table averages boxes, not a Gaussian",
              render({"--kernel", "gaussian"}));
  expectError(2, "not a Gaussian",
              {"compare", "--scene", "two-planes", "--filter", "sat", "--kernel", "gaussian"});
  expectError(2, "--sat-precision integer: the channels of esm do not fit",
              render({"--technique", "esm", "--sat-precision", "integer"}));
  EXPECT_EQ(folder.names(), std::vector<std::string>{"m.exr"});
}

// A texel of a depth file is read as it is, whatever the settings of a frame's reads are.
TEST_F(Errors, ADepthFileIsProbedAtItsTexelWhateverAFrameReads) {
  const Outcome plain = run(probe({"--technique", "all"}));
  ASSERT_EQ(plain.status, 0) << plain.err;
  for (const char* filter : {"trilinear", "anisotropic", "sat"}) {
    const Outcome outcome =
        run(probe({"--technique", "all", "--filter", filter, "--msaa", "4", "--cascades", "3"}));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out, plain.out) << filter;
    EXPECT_EQ(outcome.err, "") << filter;
  }
}

TEST_F(Errors, FormatsThatATechniqueCannotBeStoredIn) {
  for (const char* format : {"unorm8", "unorm16"}) {
    expectError(2, "esm stores exponentials",
                probe({"--technique", "vsm,esm", "--format", format}));
    expectError(2, "use half or float",
                {"render", "--scene", "two-planes", "--technique", "evsm4", "--format", format,
                 "-o", folder.file("p.png")});
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"m.exr"});
}

TEST_F(Errors, WhatAProbeNeeds) {
  expectError(2, "--receiver", {"probe", "--depth", map, "--texel", "8,9"});
  expectError(2, "--texel", {"probe", "--depth", map, "--receiver", "0.5"});
  expectError(2, "from 0 to 1", {"probe", "--depth", map, "--texel", "8,9", "--receiver", "1.01"});
  expectError(2, "from 0 to 1", {"probe", "--depth", map, "--texel", "8,9", "--receiver", "nan"});
  expectError(2, "24x17", {"probe", "--depth", map, "--texel", "24,0", "--receiver", "0.5"});
  expectError(2, "--texel", {"probe", "--depth", map, "--texel", "8;9", "--receiver", "0.5"});
  expectError(2, "--texel", {"probe", "--depth", map, "--pixel", "8,9", "--receiver", "0.5"});
  expectError(2, "--pixel", {"probe", "--scene", "three-planes", "--texel", "8,9"});
  expectError(2, "excludes --scene", probe({"--scene", "three-planes"}));
  expectError(2, "--json", probe({"-o", folder.file("out")}));
}

TEST_F(Errors, DepthMapsThatAreNone) {
  const auto probeOf = [](const std::string& file) {
    return Arguments{"probe", "--depth", file, "--texel", "2,3", "--receiver", "0.5"};
  };
  expectError(3, folder.file("none.exr"), probeOf(folder.file("none.exr")));
  std::ofstream(folder.file("text.exr")) << "not an image";
  expectError(3, "text.exr", probeOf(folder.file("text.exr")));
  const std::string whole = contentOf(map);
  std::ofstream(folder.file("cut.exr"), std::ios::binary) << whole.substr(0, whole.size() / 2);
  expectError(3, "cut.exr", probeOf(folder.file("cut.exr")));
  expectError(3, "Z", probeOf(map + ":depth"));

  writeExr(folder.file("two.exr"), {{"near", smallMap()}, {"far", smallMap()}}, {});
  expectError(3, "far", probeOf(folder.file("two.exr")));
}

TEST_F(Errors, TexelsThatAreNoDepthAreNamed) {
  const auto expectBadTexel = [&](float value) {
    Image<float> bad = smallMap();
    bad(5, 11) = value;
    writeMap(folder.file("bad.exr"), bad);
    expectError(
        3, "5,11",
        {"probe", "--depth", folder.file("bad.exr"), "--texel", "2,3", "--receiver", "0.5"});
  };
  expectBadTexel(std::numeric_limits<float>::quiet_NaN());
  expectBadTexel(std::numeric_limits<float>::infinity());
  expectBadTexel(1.25f);
  expectBadTexel(-0.001f);
  expectBadTexel(std::nextafter(1.0f, 2.0f));
}

TEST_F(Errors, ATexelJustBeyondTheRangeIsShownInFull) {
  Image<float> bad = smallMap();
  bad(5, 11) = std::nextafter(1.0f, 2.0f);
  writeMap(folder.file("bad.exr"), bad);
  expectError(3, "is 1.0000001; depths",
              {"probe", "--depth", folder.file("bad.exr"), "--texel", "2,3", "--receiver", "0.5"});
}

TEST_F(Errors, ScenesAndSessionsThatAreNone) {
  const std::string out = folder.file("p.png");
  expectError(2, "did you mean 'tree-bench'?", {"render", "--scene", "tree-bensh", "-o", out});
  expectError(3, "none.obj", {"render", "--scene", folder.file("none.obj"), "-o", out});
  expectError(2, "no scene to draw", {"render", "--depth", map, "-o", out});
  expectError(3, "none.json", {"render", "--session", folder.file("none.json"), "-o", out});
  std::ofstream(folder.file("broken.json")) << "{\"technique\": ";
  expectError(3, "broken.json", {"render", "--session", folder.file("broken.json"), "-o", out});
  expectError(2, "--light", {"render", "--scene", "two-planes", "--light", "sun:1,2,3", "-o", out});
  expectError(2, "--camera", {"render", "--scene", "two-planes", "--camera", "1,2", "-o", out});
  expectError(2, "unorm8, unorm16, half or float",
              {"render", "--scene", "two-planes", "--format", "double", "-o", out});
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST_F(Errors, OutputsThatCannotBeWritten) {
  // There is a file where a folder should be: nobody can write there, not even root.
  const std::string below = map + "/out";
  expectError(4, "m.exr",
              {"probe", "--depth", map, "--texel", "8,9", "--receiver", "0.7", "-o", below});
  expectError(4, "m.exr", {"encode", "--depth", map, "-o", below + "/c.exr"});
  expectError(4, "m.exr", {"render", "--scene", "two-planes", "-o", below + "/p.png"});
  expectError(4, "standard output", probe({}), {.output = "/dev/full"});
  expectError(4, "standard output", {"probe", "--help"}, {.output = "/dev/full"});
  std::filesystem::create_directory(folder.file("d.exr"));
  expectError(4, "d.exr", {"encode", "--depth", map, "-o", folder.file("d.exr")});
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"d.exr", "m.exr"}));
}

TEST_F(Errors, AFolderWithoutPermissionIsNamed) {
  if (geteuid() == 0) {
    // Root may write everywhere except into the kernel's own files.
    expectError(4, "/proc", {"encode", "--depth", map, "-o", "/proc/umbrascope/c.exr"});
  } else {
    std::filesystem::create_directory(folder.file("locked"));
    chmod(folder.file("locked").c_str(), 0500);
    expectError(4, "locked", {"encode", "--depth", map, "-o", folder.file("locked/c.exr")});
  }
}

TEST_F(Errors, OutputsThatAreMissingOrOfNoKnownKind) {
  expectError(2, "--output", {"encode", "--depth", map});
  expectError(2, "--output", {"render", "--scene", "two-planes"});
  expectError(2, ".png or FILE.exr",
              {"render", "--scene", "two-planes", "-o", folder.file("p.bmp")});
  expectError(2, "double",
              {"encode", "--depth", map, "--format", "double", "-o", folder.file("c.exr")});
  EXPECT_EQ(folder.names(), std::vector<std::string>{"m.exr"});
}

TEST_F(Errors, AWindowWithoutADisplay) {
  expectError(5, "umbrascope render", {});
  expectError(5, "umbrascope render", {"three-planes"});
  expectError(5, "umbrascope render", {map});
  expectError(3, "none.exr", {folder.file("none.exr")});
  // Displays are numbered at most to 65535 − 6000: no server can be there.
  expectError(5, ":98765, where no X server answers", {"three-planes"},
              {.environment = {{"DISPLAY", ":98765"}}});
}

TEST_F(Errors, AnInterruptLeavesNothingBehind) {
  writeMap(folder.file("large.exr"), smallMap(512, 512));
  const Outcome outcome =
      run({"encode", "--depth", folder.file("large.exr"), "--technique", "all", "--kernel",
           "gaussian", "--radius", "64", "-o", folder.file("c.exr")},
          {.interrupt = true});
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"large.exr", "m.exr"}));
}

// The samples of a curve are counted in millions, and looked between.
TEST_F(Errors, LongCurvesAreInterrupted) {
  const Outcome outcome = run({"probe", "--depth", folder.file("m.exr"), "--texel", "8,9",
                               "--receiver", "0.7", "--samples", "1000000", "--json"},
                              {.interrupt = true});
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace umbra::cli
