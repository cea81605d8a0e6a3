// Lloyd's relaxation of layer splits on the GPU (Lauritzen 2008, §4.1.3): the samples between
// texels and their weighted sums are made there, and a few numbers for each split come back.
#pragma once

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "filters/core/technique/Lloyd.h"
#include "filters/gpu/SplitPace.h"
#include "filters/gpu/gl/Program.h"
#include "filters/gpu/gl/Texture.h"

namespace umbra {

// Every call needs a current context (4.5 core) and leaves no program bound.
class SplitRelaxer {
 public:
  explicit SplitRelaxer(WeightClamp clamp = {}) : clamp_(clamp) {}

  // Says that the depth map is not the one of the last `advance` any more.
  void mapChanged() { mapChanged_ = true; }

  // Whether `advance` has anything to do.
  bool due(int count, SplitPace pace) const {
    return mapChanged_ || moving() || pace != pace_ || int(splits().size()) != count;
  }
  // Does one frame's work on `count` splits of `depth`, an array of R32F textures with linear
  // depth, at least two texels a side, whose first layer is read. Another count starts from uniform
  // splits. At a gradual pace it takes the sums that an earlier frame asked for, if they have
  // arrived, and asks for more until nothing moves; then it costs nothing. Returns whether splits()
  // changed.
  bool advance(const gl::Texture& depth, int count, SplitPace pace);

  // Whether a later frame will move splits, as far as is known.
  bool moving() const { return relaxation_ && !relaxation_->settled(); }
  std::vector<double> splits() const {  // ascending
    return relaxation_ ? relaxation_->result().splits : std::vector<double>();
  }
  // The relaxation for the present map, with the cost before each iteration.
  LloydResult result() const { return relaxation_ ? relaxation_->result() : LloydResult{}; }

  void releaseGraphicsResources();

 private:
  struct DeleteSync {
    using pointer = GLsync;
    void operator()(GLsync sync) const { glDeleteSync(sync); }
  };
  using Fence = std::unique_ptr<std::remove_pointer_t<GLsync>, DeleteSync>;

  void start(int count, SplitPace pace);
  void takeSamples(const gl::Texture& depth);
  void request();
  bool arrived() const;
  void receive();
  void freeMemory();

  WeightClamp clamp_;
  SplitPace pace_ = SplitPace::Converged;
  std::optional<Relaxation> relaxation_;
  bool mapChanged_ = true;
  bool oldSums_ = false;  // the sums on their way are of the map before

  gl::ProgramCache programs_;
  // These exist only while splits move: values and weights, and two buffers that take turns for
  // sums.
  gl::Texture samples_;
  gl::BufferHandle fine_, coarse_;
  std::size_t capacity_ = 0;  // bytes of either buffer
  GLuint sums_ = 0;           // the buffer that will hold one sum a cluster
  std::size_t asked_ = 0;     // clusters whose sums are on their way
  Fence fence_;
};

}  // namespace umbra
