// The commands of the program, one file each.
#pragma once

#include <functional>

#include "app/options/OptionParser.h"

namespace umbra {

struct Command {
  OptionParser parser;  // of the command; says whether it was asked for
  std::function<void()> run;
};

inline constexpr const char* commandsGroup = "Commands";  // their heading in the help

// Each adds its command to `program` and returns what runs it.
Command addRender(OptionParser& program);
Command addProbe(OptionParser& program);
Command addEncode(OptionParser& program);
Command addSplits(OptionParser& program);
Command addCompare(OptionParser& program);
Command addSweep(OptionParser& program);
Command addBench(OptionParser& program);
Command addReproduce(OptionParser& program);
Command addTour(OptionParser& program);
Command addScenes(OptionParser& program);
Command addTechniques(OptionParser& program);
Command addSettings(OptionParser& program);
Command addLesson(OptionParser& program);

}  // namespace umbra
