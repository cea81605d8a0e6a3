#include "app/start/CommandLine.h"

#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "app/commands/Commands.h"
#include "app/options/SessionOptions.h"
#include "app/output/Cancellation.h"
#include "app/output/Output.h"
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

class Program {
 public:
  Program() : parser_("umbrascope", description, UMBRA_VERSION), window_(parser_) {
    parser_.setFooter(exitStatuses);
    commands_ = {addRender(parser_), addProbe(parser_),      addEncode(parser_),
                 addSplits(parser_), addCompare(parser_),    addSweep(parser_),
                 addBench(parser_),  addReproduce(parser_),  addTour(parser_),
                 addScenes(parser_), addTechniques(parser_), addSettings(parser_),
                 addLesson(parser_)};
  }

  int run(int& argc, char** argv) {
    const auto help = parser_.parse(argc, argv, [this] { window_.checkArgument(); });
    if (help) {
      print(*help);
      return 0;
    }
    for (const Command& command : commands_) {
      if (!command.parser.wasAsked()) continue;
      if (window_.given())
        throw Error(ErrorKind::BadCommandLine,
                    command.parser.name() + ": options and scenes go after the command's name");
      catchInterrupts();
      command.run();
      return 0;
    }
    return window_.run(argc, argv);
  }

 private:
  ProgramParser parser_;
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
