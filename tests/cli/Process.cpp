#include "tests/cli/Process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace umbra::cli {

namespace fs = std::filesystem;

namespace {

void redirect(const std::string& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(127);
  close(opened);
}

[[noreturn]] void become(const Arguments& arguments, const Setting& setting, const std::string& out,
                         const std::string& err) {
  redirect(out, STDOUT_FILENO);
  redirect(err, STDERR_FILENO);
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  for (const auto& [name, value] : setting.environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> argv{const_cast<char*>(UMBRASCOPE_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  execv(UMBRASCOPE_PROGRAM, argv.data());
  _exit(127);
}

// Whether the process has a handler of its own for SIGINT, or has ended.
bool catchesInterrupts(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  bool found = false;
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigCgt:")) continue;
    found = true;
    if (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) return true;
  }
  return !found;
}

}  // namespace

Outcome run(const Arguments& arguments, const Setting& setting) {
  const TemporaryFolder folder;
  const std::string out = setting.output.empty() ? folder.file("out") : setting.output;
  const std::string err = folder.file("err");
  const pid_t process = fork();
  if (process == 0) become(arguments, setting, out, err);
  if (setting.interrupt) {
    while (!catchesInterrupts(process)) usleep(200);
    kill(process, SIGINT);
  }
  int status = 0;
  waitpid(process, &status, 0);
  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (setting.output.empty()) outcome.out = contentOf(out);
  outcome.err = contentOf(err);
  return outcome;
}

Json Outcome::json() const {
  EXPECT_EQ(status, 0) << err;
  const Json object = Json::parse(out, nullptr, false);
  EXPECT_TRUE(object.is_object()) << out;
  return object;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "umbrascope-test-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(path_))
    names.push_back(entry.path().lexically_relative(path_).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

}  // namespace umbra::cli
