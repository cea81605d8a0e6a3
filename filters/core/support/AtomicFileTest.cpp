#include "filters/core/support/AtomicFile.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "filters/core/support/Error.h"
#include "filters/core/support/TemporaryFolder.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  static std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t entries() const {
    return std::size_t(std::distance(fs::directory_iterator(folder_), {}));
  }

  const TemporaryFolder temporary_;
  const fs::path& folder_ = temporary_.path();
};

TEST_F(AtomicFile, WritesAllBytesAndMakesTheFolder) {
  const std::string content("a\0b\r\nc", 6);
  writeTextAtomically(folder_ / "new" / "deep" / "file.csv", content);
  EXPECT_EQ(contentOf(folder_ / "new" / "deep" / "file.csv"), content);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "new" / "deep"), {}), 1);
}

TEST_F(AtomicFile, ReplacesWhatWasThere) {
  writeTextAtomically(folder_ / "file.txt", "old and longer");
  writeTextAtomically(folder_ / "file.txt", "new");
  EXPECT_EQ(contentOf(folder_ / "file.txt"), "new");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFile, GivesTheTemporaryFileTheSameExtension) {
  writeAtomically(folder_ / "picture.png", [&](const fs::path& temporary) {
    EXPECT_EQ(temporary.extension(), ".png");
    EXPECT_EQ(temporary.parent_path().parent_path(), folder_);
    std::ofstream(temporary) << "x";
  });
  EXPECT_EQ(contentOf(folder_ / "picture.png"), "x");
}

TEST_F(AtomicFile, KeepsTheOldFileWhenWritingFails) {
  writeTextAtomically(folder_ / "file.txt", "old");
  try {
    writeAtomically(folder_ / "file.txt", [](const fs::path& temporary) {
      std::ofstream(temporary) << "half";
      throw std::runtime_error("the disk is gone");
    });
    ADD_FAILURE() << "did not throw";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::BadOutput);
    const std::string message = error.what();
    EXPECT_NE(message.find((folder_ / "file.txt").string()), std::string::npos);
    EXPECT_NE(message.find("the disk is gone"), std::string::npos);
  }
  EXPECT_EQ(contentOf(folder_ / "file.txt"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(AtomicFile, RefusesAFolderInThePlaceOfTheFileAndAFileInThatOfTheFolder) {
  fs::create_directories(folder_ / "taken.txt");
  writeTextAtomically(folder_ / "file", "here");
  for (const fs::path& file : {folder_ / "taken.txt", folder_ / "file" / "inside.txt"}) {
    try {
      writeTextAtomically(file, "x");
      ADD_FAILURE() << file << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadOutput);
      EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
    }
  }
  EXPECT_EQ(contentOf(folder_ / "file"), "here");
  EXPECT_EQ(entries(), 2u);
}

TEST_F(AtomicFile, LeavesNothingWhenNothingWasWritten) {
  EXPECT_THROW(writeAtomically(folder_ / "file.txt", [](const fs::path&) {}), Error);
  EXPECT_EQ(entries(), 0u);
}

TEST_F(AtomicFile, KeepsPermissions) {
  const fs::path file = folder_ / "secret.json";
  writeTextAtomically(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  writeTextAtomically(file, "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AtomicFile, WritesThroughALinkAndLeavesTheLink) {
  fs::create_directories(folder_ / "elsewhere");
  fs::create_symlink("elsewhere/file.txt", folder_ / "link.txt");
  writeTextAtomically(folder_ / "link.txt", "new");  // what it points to is not there yet
  writeTextAtomically(folder_ / "link.txt", "newer");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(contentOf(folder_ / "elsewhere" / "file.txt"), "newer");
  fs::create_symlink("circle", folder_ / "circle");
  EXPECT_THROW(writeTextAtomically(folder_ / "circle", "new"), Error);
}

// A temporary file can be written by nobody else, whatever its permissions are.
TEST_F(AtomicFile, LetsNobodyElseIntoTheTemporaryFolder) {
  std::string first;
  writeAtomically(folder_ / "file.txt", [&](const fs::path& temporary) {
    first = temporary.parent_path().filename().string();
    EXPECT_EQ(fs::status(temporary.parent_path()).permissions(), fs::perms::owner_all);
    std::ofstream(temporary) << "x";
  });
  writeAtomically(folder_ / "file.txt", [&](const fs::path& temporary) {
    EXPECT_NE(temporary.parent_path().filename().string(), first);
    std::ofstream(temporary) << "x";
  });
}

// The process that made it was killed: its number is of none that lives.
TEST_F(AtomicFile, RemovesWhatAKilledProcessLeft) {
  const pid_t dead = fork();
  if (dead == 0) {
    makeStagingFolder(folder_);
    _exit(0);
  }
  ASSERT_EQ(waitpid(dead, nullptr, 0), dead);
  const fs::path living = makeStagingFolder(folder_);
  std::ofstream(folder_ / ".umbrascope-notes") << "somebody's own";
  EXPECT_EQ(entries(), 3u);
  writeTextAtomically(folder_ / "file.txt", "new");
  EXPECT_EQ(entries(), 3u);
  EXPECT_TRUE(fs::exists(living));
  EXPECT_TRUE(fs::exists(folder_ / ".umbrascope-notes"));
}

TEST_F(AtomicFile, KnowsNamesThatLeaveTheFolder) {
  for (const char* name : {"", ".", "..", "../x", "a/b", "/etc/passwd"})
    EXPECT_FALSE(isPlainName(name)) << name;
  for (const char* name : {"a", "..a", "compare.json", "décalage.png"})
    EXPECT_TRUE(isPlainName(name)) << name;
}

}  // namespace
}  // namespace umbra
