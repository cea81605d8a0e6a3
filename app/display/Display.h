// An interface to what needs OpenGL or Qt. The program loads the library that implements it only
// when a command asks for it, so that everything else starts without either.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/cost/TechniqueCost.h"
#include "analysis/plots/Plot.h"
#include "datasets/session/Workspace.h"
#include "filters/core/scene/FieldMesh.h"
#include "filters/gpu/ShadowRenderer.h"
#include "filters/gpu/bench/BenchView.h"

namespace umbra {

// Frames in one headless OpenGL context, one after the other.
class HeadlessFrame {
 public:
  virtual ~HeadlessFrame() = default;

  // Frames from now on show this scene with that session's light, camera, frame settings and size.
  // Only what this changes is drawn anew.
  virtual void show(std::shared_ptr<const Scene> scene, const Session& session) = 0;
  // Draws with this technique. Throws WorkFailed with the errors of OpenGL or VTK.
  virtual void render(const Technique& technique, ViewMode view) = 0;
  // These read back the last frame, as in ShadowRenderer.
  virtual Image<std::uint8_t> colour() = 0;
  virtual SurfaceImage surfaces() = 0;
  virtual std::shared_ptr<const FrameSnapshot> snapshot() = 0;
  virtual std::optional<SurfacePoint> surfaceAt(int x, int y) = 0;
  virtual Image<float> reference() = 0;
  virtual const DepthMap& depthMap(int cascade = 0) = 0;
  virtual Image<float> channels(BakeStage stage) = 0;
  // The pixel where light bleeds most plainly, which the window goes to as well. Nothing where no
  // spot of the picture bleeds so that anybody sees it.
  virtual std::optional<Pixel> plainestBleeding() = 0;
  // What the shown scene costs with this technique: medians of a few more frames, on the clock that
  // fits the renderer. These replace the last frame.
  virtual TechniqueCost cost(const Technique& technique) = 0;
};

// Frames of one scene that are drawn to be measured.
class BenchFrames {
 public:
  virtual ~BenchFrames() = default;

  virtual std::string renderer() = 0;  // OpenGL's name for it
  virtual CostClock clock() const = 0;

  // Frames from now on have these settings. Draws one that counts nowhere: it compiles shaders and
  // gives textures their sizes.
  virtual void show(const FrameSettings& settings, const Technique& technique) = 0;
  // The milliseconds of one frame after a motion.
  virtual double draw(Motion motion) = 0;
  // The passes of one frame after the light has moved, each waited for on the processor's clock.
  virtual std::vector<PassTime> drawPasses() = 0;
  virtual double drawBaseline(Baseline baseline, Motion motion) = 0;

  // The bytes per texel of the shadow map in all textures that these settings take.
  virtual double bytesUsed(const FrameSettings& settings, const Technique& technique) = 0;
};

// A picture with a name, for sheets of several.
struct LabelledPicture {
  std::string label;
  Image<std::uint8_t> colour;  // RGB, row 0 on top
};

// Texts by their names, as a PNG file keeps them.
using PictureTexts = std::map<std::string, std::string>;

class Display {
 public:
  virtual ~Display() = default;

  // Returns the exit status of the window. Needs an X or Wayland display.
  virtual int runWindow(int& argc, char** argv, const Workspace& workspace) = 0;

  // A new context that shows `scene` as the session sees it. Throws NoOpenGL.
  virtual std::unique_ptr<HeadlessFrame> makeFrame(std::shared_ptr<const Scene> scene,
                                                   const Session& session) = 0;

  // Contexts in which `view` is drawn, and VTK's own shadow map of `mapSize` texels a side. Without
  // a clock, the one that fits the renderer. Throws NoOpenGL.
  virtual std::unique_ptr<BenchFrames> makeBench(const BenchView& view, int mapSize,
                                                 std::optional<CostClock> clock) = 0;

  // The file is .svg, .pdf or .png. Throws BadOutput.
  virtual void writePlot(const Plot& plot, const std::filesystem::path& file) = 0;
  // Writes as PNG one picture as it is, or several side by side, each under its label.
  virtual void writePictures(const std::vector<LabelledPicture>& pictures,
                             const std::filesystem::path& file, const PictureTexts& texts) = 0;

  // The same in memory, for documents that contain plots and pictures.
  virtual std::string svgOf(const Plot& plot) = 0;
  virtual std::string pngOf(const Image<std::uint8_t>& picture) = 0;

  // Writes a mesh with values as VTK PolyData. Throws BadOutput.
  virtual void writeVtp(const FieldMesh& mesh, const std::filesystem::path& file) = 0;
};

// The one symbol of the library.
inline constexpr const char* displayFactoryName = "umbraMakeDisplay";
using DisplayFactory = Display* (*)();

}  // namespace umbra
