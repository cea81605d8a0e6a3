// Catalogues, help and version; and that they start without Qt and OpenGL.
#include <gtest/gtest.h>

#include <set>

#include "tests/cli/Process.h"
#include "tests/cli/SmallMap.h"

namespace umbra::cli {
namespace {

std::set<std::string> namesIn(const Json& list) {
  std::set<std::string> names;
  for (const Json& entry : list) names.insert(entry["name"]);
  return names;
}

TEST(Catalogue, TechniquesDeclareTheirParameters) {
  const Json list = run({"techniques", "--json"}).json()["techniques"];
  const std::set<std::string> names = namesIn(list);
  for (const char* name : {"hard", "pcf", "vsm", "esm", "evsm2", "evsm4", "power-cdf"})
    EXPECT_TRUE(names.contains(name)) << name;
  for (const Json& technique : list) {
    EXPECT_FALSE(technique["title"].get<std::string>().empty());
    for (const Json& parameter : technique["parameters"])
      for (const char* field : {"name", "symbol", "unit", "range", "default", "doc"})
        EXPECT_TRUE(parameter.contains(field)) << technique["name"] << " " << field;
  }
}

TEST(Catalogue, ScenesHaveNamesAndTitles) {
  const Json list = run({"scenes", "--json"}).json()["scenes"];
  const std::set<std::string> names = namesIn(list);
  for (const char* name : {"three-planes", "two-planes", "spheres", "fence", "tree-bench",
                           "windmill", "car", "foliage"})
    EXPECT_TRUE(names.contains(name)) << name;
  for (const Json& scene : list) {
    EXPECT_FALSE(scene["title"].get<std::string>().empty());
    EXPECT_FALSE(scene["description"].get<std::string>().empty());
  }
}

TEST(Catalogue, TablesForPeopleNameEveryEntry) {
  for (const char* command : {"techniques", "scenes"}) {
    const Outcome table = run({command});
    EXPECT_EQ(table.status, 0);
    for (const std::string& name : namesIn(run({command, "--json"}).json()[command]))
      EXPECT_NE(table.out.find("\n" + name + " "), std::string::npos) << name;
  }
}

TEST(Help, VersionAndHelpGoToStandardOutput) {
  EXPECT_EQ(run({"--version"}).out, "umbrascope " UMBRASCOPE_VERSION "\n");
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  for (const char* command : {"render", "probe", "encode", "compare", "scenes", "techniques"}) {
    EXPECT_NE(help.out.find(std::string("\n  ") + command), std::string::npos) << command;
    const Outcome own = run({command, "--help"});
    EXPECT_EQ(own.status, 0);
    EXPECT_NE(own.out.find(std::string("Usage: umbrascope ") + command), std::string::npos)
        << own.out;
  }
}

// The names of all shared libraries that the dynamic linker searched for.
std::string librariesOf(const Arguments& arguments) {
  const Outcome outcome = run(arguments, {.environment = {{"LD_DEBUG", "files"}}});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("libumbra_base"), std::string::npos) << "LD_DEBUG does not work here";
  return outcome.err;
}

TEST(Help, LoadsNeitherQtNorOpenGl) {
  const TemporaryFolder folder;
  writeMap(folder.file("m.exr"), smallMap());
  const std::string map = folder.file("m.exr");
  for (const Arguments& arguments :
       {Arguments{"--help"},
        {"techniques"},
        {"scenes", "--json"},
        {"probe", "--json", "--depth", map, "--texel", "1,1", "--receiver", "0.5"},
        {"encode", "--depth", map, "-o", folder.file("c.exr")},
        {"compare", "--json", "--depth", map, "--receiver", "0.5"}}) {
    const std::string libraries = librariesOf(arguments);
    for (const char* name : {"libQt", "libvtk", "libGL", "libEGL", "libqwt"})
      EXPECT_EQ(libraries.find(name), std::string::npos) << arguments.front() << " loads " << name;
  }
}

}  // namespace
}  // namespace umbra::cli
