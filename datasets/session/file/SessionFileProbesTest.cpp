#include "datasets/session/file/SessionFileProbes.h"

#include "datasets/session/file/SessionFileCheck.h"

namespace umbra {
namespace {

TEST(SessionFileProbes, SavedProbesThatCannotBeAreRefused) {
  const auto probesError = [](const std::string& list, const std::string& more = "") {
    return sessionErrorOf(sessionWith(more + "\"probes\": " + list));
  };
  const std::string at = R"("point": [1, 2, 3]})", first = R"([{"name": "a", )" + at;
  EXPECT_EQ(probesError(first + "]"), "no error");
  EXPECT_EQ(probesError("{}"), "s.json: probes: {} is not right, it takes a list […]");
  EXPECT_EQ(probesError(first + ", 7]"), "s.json: probes[2]: 7 should be an object {…}");
  EXPECT_EQ(probesError("[{" + at + "]"), "s.json: probes[1].name: a probe needs a name");
  EXPECT_EQ(probesError(R"([{"name": "  ", )" + at + "]"),
            "s.json: probes[1].name: a probe needs a name");
  EXPECT_EQ(probesError(R"([{"name": 3, )" + at + "]"),
            "s.json: probes[1].name: 3 is not right, it takes a text");
  EXPECT_EQ(probesError(first + R"(, {"name": "a", )" + at + "]"),
            "s.json: probes[2].name: there is a probe 'a' already");
  EXPECT_EQ(probesError(R"([{"name": "all", )" + at + "]"),
            "s.json: probes[1].name: 'all' stands for every probe, give it another name");
  EXPECT_EQ(probesError(R"([{"name": "a\tb", )" + at + "]"),
            "s.json: probes[1].name: the name should be one line without tabs");
  EXPECT_EQ(probesError("[{\"name\": \"" + std::string(61, 'x') + "\", " + at + "]"),
            "s.json: probes[1].name: the name is 61 bytes long, it should be at most 60");
  EXPECT_EQ(probesError(R"([{"name": "a", "point": [1, 2]}])"),
            "s.json: probes[1].point: [1,2] is not right, it takes three numbers [x, y, z]");
  EXPECT_EQ(probesError(R"([{"name": "a", "point": [1, 2, 2e9]}])"),
            "s.json: probes[1].point: has a coordinate beyond 1e+09, which is out of reach");
  EXPECT_EQ(probesError(R"([{"name": "a", "texel": [1, 2]}])"),
            "s.json: probes[1]: on a scene needs a 'point' and no 'texel'");
  EXPECT_EQ(probesError(R"([{"name": "a", "receiver": 2, )" + at + "]"),
            "s.json: probes[1].receiver: 2 is not right, it takes a number from 0 to 1");
  EXPECT_EQ(probesError(R"([{"name": "a", "spot": 2, )" + at + "]"),
            "s.json: probes[1].spot: there is no such key");
  std::string many;
  for (int i = 1; i <= 13; ++i)
    many += (i > 1 ? ", " : "") + ("{\"name\": \"" + std::to_string(i)) + "\", " + at;
  EXPECT_EQ(probesError("[" + many + "]"),
            "s.json: probes[13]: is one too many, at most 12 are saved");
  const std::string onFile = R"("source": {"depth": "m.exr"}, )";
  EXPECT_EQ(probesError(first + "]", onFile),
            "s.json: probes[1]: on a depth file needs a 'texel' and no 'point'");
  for (const char* texel : {"[1]", "[1, 0.5]", "[-1, 0]", "[0, 16384]", "3"})
    EXPECT_EQ(probesError(R"([{"name": "a", "texel": )" + std::string(texel) + "}]", onFile)
                  .find("s.json: probes[1].texel: "),
              0u)
        << texel;
  EXPECT_EQ(probesError(first + R"(], "keptProbe": "b")"),
            "s.json: keptProbe: there is no probe 'b' among 'probes'");
  EXPECT_EQ(probesError(first + R"(], "keptProbe": "a")"),
            "s.json: keptProbe: needs a 'probe', the pixel or texel it is at");
  EXPECT_EQ(probesError(first + R"(], "keptProbe": "a", "probe": [0, 0])"), "no error");
}

}  // namespace
}  // namespace umbra
