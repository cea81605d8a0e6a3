// The commands of the program, one file each.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace umbra {

struct Command {
  CLI::App* app;  // of the command; says whether it was asked for
  std::function<void()> run;
};

// Each adds its command to `program` and returns what runs it.
Command addRender(CLI::App& program);
Command addProbe(CLI::App& program);
Command addEncode(CLI::App& program);
Command addSplits(CLI::App& program);
Command addCompare(CLI::App& program);
Command addTour(CLI::App& program);
Command addScenes(CLI::App& program);
Command addTechniques(CLI::App& program);
Command addLesson(CLI::App& program);

}  // namespace umbra
