// The library's one symbol and the class behind it.
#include <spdlog/spdlog.h>

#include <QApplication>
#include <memory>
#include <optional>

#include "app/display/Display.h"
#include "app/display/PictureFile.h"
#include "app/display/RendererBench.h"
#include "app/display/RendererFrame.h"
#include "app/display/VtkMessages.h"
#include "filters/gpu/VtpFile.h"
#include "ui/plots/PlotRenderer.h"
#include "ui/window/RunWindow.h"

namespace umbra {
namespace {

class QtVtkDisplay final : public Display {
 public:
  int runWindow(int& argc, char** argv, const Workspace& workspace) override {
    return umbra::runWindow(argc, argv, workspace);
  }

  std::unique_ptr<HeadlessFrame> makeFrame(std::shared_ptr<const Scene> scene,
                                           const Session& session) override {
    listen();
    return std::make_unique<RendererFrame>(std::move(scene), session, messages_);
  }

  std::unique_ptr<BenchFrames> makeBench(const BenchView& view, int mapSize,
                                         std::optional<CostClock> clock) override {
    listen();
    return std::make_unique<RendererBench>(view, mapSize, clock, messages_);
  }

  void writePlot(const Plot& plot, const std::filesystem::path& file) override {
    startQt();
    exportPlot(plot, file);
  }

  void writePictures(const std::vector<LabelledPicture>& pictures,
                     const std::filesystem::path& file, const PictureTexts& texts) override {
    startQt();
    writePng(pictures, file, texts);
  }

  std::string svgOf(const Plot& plot) override {
    startQt();
    return plotSvg(plot);
  }

  std::string pngOf(const Image<std::uint8_t>& picture) override { return umbra::pngOf(picture); }

  void writeVtp(const FieldMesh& mesh, const std::filesystem::path& file) override {
    umbra::writeVtp(mesh, file);
  }

 private:
  void listen() {
    if (messages_) return;
    messages_ = vtkSmartPointer<VtkMessages>::New();
    vtkOutputWindow::SetInstance(messages_);
  }

  // Text needs an application; without a display it is one that draws off screen.
  void startQt() {
    if (QCoreApplication::instance()) return;
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Qt's messages about the environment are neither a result nor an error of the program.
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
      if (type == QtCriticalMsg || type == QtFatalMsg) spdlog::error("{}", text.toStdString());
    });
    application_.emplace(argc_, argv_);
  }

  vtkSmartPointer<VtkMessages> messages_;
  char name_[11] = "umbrascope";
  char* argv_[2] = {name_, nullptr};
  int argc_ = 1;  // QApplication keeps a reference to it
  std::optional<QApplication> application_;
};

}  // namespace
}  // namespace umbra

extern "C" __attribute__((visibility("default"))) umbra::Display* umbraMakeDisplay() {
  return new umbra::QtVtkDisplay;
}
