#include "filters/core/support/InputFile.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

class InputFile : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("umbra-input-" + name);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // What the message says after the file's name.
  static std::string refusalOf(const fs::path& file, std::uintmax_t most = 100) {
    try {
      contentOf(file, most);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::BadInput);
      const std::string what = error.what(), name = file.string() + ": ";
      EXPECT_TRUE(what.starts_with(name)) << what;
      return what.substr(name.size());
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(InputFile, GivesEveryByte) {
  const std::string content("a\0b\r\nc", 6);
  std::ofstream(folder_ / "file", std::ios::binary) << content;
  EXPECT_EQ(contentOf(folder_ / "file", 6), content);
  EXPECT_EQ(checkInput(folder_ / "file"), 6u);
  std::ofstream(folder_ / "empty").close();
  EXPECT_EQ(contentOf(folder_ / "empty", 6), "");
}

TEST_F(InputFile, RefusesWhatIsTooLarge) {
  std::ofstream(folder_ / "file") << "1234567";
  EXPECT_EQ(refusalOf(folder_ / "file", 6), "has 7 bytes, at most 6 are read");
}

TEST_F(InputFile, NamesWhatIsNoFile) {
  EXPECT_EQ(refusalOf(folder_ / "none"), "there is no such file");
  EXPECT_EQ(refusalOf(folder_), "is a folder, not a file");
  EXPECT_EQ(refusalOf("/dev/zero"), "is a pipe or a device, not a file");
}

// A pipe that nobody writes into would wait for ever.
TEST_F(InputFile, DoesNotWaitForAPipe) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusalOf(folder_ / "pipe"), "is a pipe or a device, not a file");
}

TEST_F(InputFile, RefusesPathsThatTheSystemDoes) {
  fs::create_symlink("loop", folder_ / "loop");
  EXPECT_TRUE(refusalOf(folder_ / "loop").starts_with("cannot be read: "));
  EXPECT_TRUE(refusalOf(folder_ / std::string(5000, 'x')).starts_with("cannot be read: "));
}

}  // namespace
}  // namespace umbra
