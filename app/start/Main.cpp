#include "app/start/CommandLine.h"

int main(int argc, char** argv) {
  return umbra::runCommandLine(argc, argv);
}
