#include "app/start/CommandLine.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "app/commands/Commands.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "app/output/Output.h"
#include "app/start/HelpLayout.h"
#include "app/start/OpenWindow.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

constexpr const char* description =
    "Shows why filtered shadow maps are wrong: opens a window on SCENE, a catalogue scene, a mesh\n"
    "file, a depth map (.exr) or a saved session (.json); or does one command without a display.";

constexpr const char* exitStatuses =
    "Exit status: 0 done, 1 the work failed, 2 the command line is wrong, 3 an input is bad,\n"
    "4 an output cannot be written, 5 no usable OpenGL, 130 cancelled.";

// Standard output is for results alone.
void logToStandardError() {
  auto log = std::make_shared<spdlog::logger>(
      "umbrascope", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  log->set_pattern("umbrascope: %v");
  spdlog::set_default_logger(log);
}

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

// The command that was asked for, else the program itself.
const CLI::App& asked(const CLI::App& program) {
  const std::vector<CLI::App*> commands = program.get_subcommands();
  return commands.empty() ? program : *commands.front();
}

// What is said of a word that nothing takes.
std::string unexpected(const CLI::App& program) {
  const CLI::App& command = asked(program);
  std::vector<std::string> words = command.remaining(true);
  if (words.empty()) {
    // Then it stands before the command's name.
    words = program.remaining();
    if (command.get_parent() && !words.empty())
      return words.front() + ": is not expected before `" + command.get_name() +
             "`, options go after the command's name";
  }
  const std::string word = words.empty() ? "" : words.front();
  std::vector<std::string> known;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  const std::string nearest = nearestWord(word.substr(0, word.find('=')), known);
  std::string name = "umbrascope";
  if (command.get_parent()) name += " " + command.get_name();
  return word + ": is not expected here; " +
         (nearest.empty() ? "`" + name + " --help` lists what is"
                          : "did you mean '" + nearest + "'?");
}

class Program {
 public:
  Program() : app_(description, "umbrascope"), window_(app_) {
    app_.set_version_flag("--version", "umbrascope " UMBRA_VERSION);
    app_.set_help_flag("-h,--help", "Print this help and exit");
    app_.footer(exitStatuses);
    app_.require_subcommand(0, 1);
    app_.formatter(std::make_shared<HelpLayout>());
    commands_ = {addRender(app_), addProbe(app_),      addEncode(app_),
                 addSplits(app_), addCompare(app_),    addTour(app_),
                 addScenes(app_), addTechniques(app_), addLesson(app_)};
    for (const Command& command : commands_) command.app->group("Commands");
  }

  int run(int& argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::Success& help) {
      std::ostringstream text;
      const int status = app_.exit(help, text, std::cerr);
      print(text.str());
      return status;
    } catch (const CLI::ExtrasError&) {
      // A mistyped command is also an argument that is not expected, and the better explanation.
      if (asked(app_).get_parent() == nullptr) window_.checkArgument();
      throw Error(ErrorKind::BadCommandLine, unexpected(app_));
    } catch (const CLI::ParseError& error) {
      throw Error(ErrorKind::BadCommandLine, oneLine(error.what()));
    }
    for (const Command& command : commands_) {
      if (!command.app->parsed()) continue;
      if (window_.given())
        throw Error(ErrorKind::BadCommandLine,
                    command.app->get_name() + ": options and scenes go after the command's name");
      catchInterrupts();
      command.run();
      return 0;
    }
    return window_.run(argc, argv);
  }

 private:
  CLI::App app_;
  OpenWindow window_;
  std::vector<Command> commands_;
};

int report(ErrorKind kind, const std::string& message) {
  std::cerr << "umbrascope: " << oneLine(message) << std::endl;
  return int(kind);
}

}  // namespace

int runCommandLine(int& argc, char** argv) {
  logToStandardError();
  try {
    return Program().run(argc, argv);
  } catch (const Error& error) {
    return report(error.kind(), error.what());
  } catch (const std::bad_alloc&) {
    return report(ErrorKind::WorkFailed, "out of memory; choose a smaller map or picture");
  } catch (const std::exception& error) {
    return report(ErrorKind::WorkFailed, error.what());
  }
}

}  // namespace umbra
