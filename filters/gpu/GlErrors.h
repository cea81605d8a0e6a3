// Errors of OpenGL and of VTK, which both report and go on, gathered so that somebody can fail.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace umbra {

// Listens to VTK's error messages as long as it lives.
class VtkErrors {
 public:
  VtkErrors();
  ~VtkErrors();
  VtkErrors(const VtkErrors&) = delete;
  VtkErrors& operator=(const VtkErrors&) = delete;

  const std::vector<std::string>& messages() const { return *messages_; }

 private:
  std::shared_ptr<std::vector<std::string>> messages_;
  unsigned long tag_ = 0;
};

// Listens to the errors of the OpenGL context that is current when it is made. The same context
// must be current, or gone, when it is destroyed.
class GlErrors {
 public:
  GlErrors();
  ~GlErrors();
  GlErrors(const GlErrors&) = delete;
  GlErrors& operator=(const GlErrors&) = delete;

  const std::vector<std::string>& messages() const { return *messages_; }

 private:
  std::unique_ptr<std::vector<std::string>> messages_;
};

}  // namespace umbra
