// The command line: what was asked for, done; errors as one line and an exit status.
#pragma once

namespace umbra {

// Returns the exit status: 0, or the value of an ErrorKind.
int runCommandLine(int& argc, char** argv);

}  // namespace umbra
