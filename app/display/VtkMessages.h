// VTK reports errors and goes on; this turns them into failures.
#pragma once

#include <vtkOutputWindow.h>

#include <string>

namespace umbra {

// It is installed in place of VTK's own output window. Warnings go to the log.
class VtkMessages final : public vtkOutputWindow {
 public:
  static VtkMessages* New();
  vtkTypeMacro(VtkMessages, vtkOutputWindow);

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char*) override {}

  // Throws WorkFailed with the first error since the last call, if there was one.
  void throwFirstError();

 private:
  VtkMessages() = default;

  std::string firstError_;
};

}  // namespace umbra
