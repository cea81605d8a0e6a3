// The one exception of the program: what went wrong, in one line, and whose fault it is.
#pragma once

#include <stdexcept>
#include <string>

namespace umbra {

// The values are the exit statuses of the command line.
enum class ErrorKind {
  WorkFailed = 1,      // the computation itself failed
  BadCommandLine = 2,  // an option or its value is wrong
  BadInput = 3,        // a file, key or texel that was read is wrong
  BadOutput = 4,       // a file cannot be written
  NoOpenGL = 5,        // no usable OpenGL context
  Cancelled = 130,     // the user stopped it
};

class Error : public std::runtime_error {
 public:
  // `message` is one line that names the file, key, texel or option and says what would be right.
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace umbra
