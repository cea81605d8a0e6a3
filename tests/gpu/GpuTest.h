// A headless window for a test; any OpenGL or VTK error in the test fails it.
#pragma once

#include <gtest/gtest.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <optional>

#include "filters/gpu/GlErrors.h"
#include "filters/gpu/HeadlessWindow.h"

namespace umbra::test {

class GpuTest : public testing::Test {
 protected:
  void SetUp() override {
    vtkErrors.emplace();
    window = makeHeadlessWindow(width, height);
    window->MakeCurrent();
    glErrors.emplace();
  }

  void TearDown() override {
    window->MakeCurrent();
    for (const std::string& message : glErrors->messages()) ADD_FAILURE() << "OpenGL: " << message;
    glErrors.reset();
    window = nullptr;
    for (const std::string& message : vtkErrors->messages()) ADD_FAILURE() << "VTK: " << message;
    vtkErrors.reset();
  }

  static constexpr int width = 320, height = 240;
  vtkSmartPointer<vtkRenderWindow> window;
  std::optional<VtkErrors> vtkErrors;
  std::optional<GlErrors> glErrors;
};

}  // namespace umbra::test
