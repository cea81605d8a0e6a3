#include "filters/gpu/SplitRelaxer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "SplitCluster_comp_glsl.h"
#include "SplitReduce_comp_glsl.h"
#include "SplitSamples_comp_glsl.h"
#include "SplitSums_glsl.h"

namespace umbra {
namespace {

// The same layout as in SplitSums.glsl.
struct Sums {
  double weight, first, second;
  float low, high;
};

constexpr int groupSide = 8;     // invocations of a work group along either axis
constexpr int ownSamples = 4;    // the fewest samples of an invocation along either axis
constexpr int largestGrid = 16;  // work groups along either axis that add up samples
constexpr int run = 128;         // sums that one invocation of the reduction adds up
constexpr int reduceGroup = 32;

GLuint groupsFor(int items, int size) {
  return GLuint((items + size - 1) / size);
}

// The largest float that is not above `value`. Samples are floats and lie on the same side of both.
float roundedDown(double value) {
  const float nearest = float(value);
  return nearest > value ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
                         : nearest;
}

std::string source(std::size_t clusters, const char* body) {
  return "#version 450\n#define UMBRA_CLUSTERS " + std::to_string(clusters) + "\n" +
         SplitSums_glsl + body;
}

gl::BufferHandle makeBuffer(std::size_t bytes) {
  GLuint name = 0;
  glCreateBuffers(1, &name);
  glNamedBufferStorage(name, GLsizeiptr(bytes), nullptr, 0);
  return gl::BufferHandle(name);
}

}  // namespace

bool SplitRelaxer::advance(const gl::Texture& depth, int count, SplitPace pace) {
  const std::vector<double> before = splits();
  const bool another = !relaxation_ || int(before.size()) != count || pace != pace_;
  if (another || (mapChanged_ && pace == SplitPace::Converged)) start(count, pace);
  if (fence_ && arrived()) receive();
  if (mapChanged_) {
    relaxation_->resume();
    oldSums_ = bool(fence_);
    samples_ = gl::Texture();
    mapChanged_ = false;
  }
  if (moving() && !fence_) {
    takeSamples(depth);
    request();
  }
  if (pace == SplitPace::Converged)
    while (fence_) {
      glClientWaitSync(fence_.get(), GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
      receive();
      if (moving()) request();
    }
  if (!moving()) freeMemory();
  return splits() != before;
}

// Gradual splits go on from the last splits, so that a picture does not jump.
void SplitRelaxer::start(int count, SplitPace pace) {
  LloydOptions options{.splits = count, .movedPerIteration = pace == SplitPace::Gradual ? 2 : 0};
  if (pace == SplitPace::Gradual && int(splits().size()) == count) options.start = splits();
  relaxation_.emplace(options);
  pace_ = pace;
  fence_.reset();  // sums that were asked for are of no use any more
  oldSums_ = false;
}

void SplitRelaxer::takeSamples(const gl::Texture& depth) {
  if (samples_) return;
  samples_ = gl::Texture(GL_RG32F, depth.width() - 1, depth.height() - 1);
  const GLuint program =
      programs_.compute("second occluders", std::string("#version 450\n") + SplitSamples_comp_glsl);
  gl::setUniform(program, "umbraDepthMap", 0);
  gl::setUniform(program, "umbraLowestWeight", float(clamp_.low));
  gl::setUniform(program, "umbraHighestWeight", float(clamp_.high));
  glUseProgram(program);
  glBindTextureUnit(0, depth.name());
  glBindImageTexture(0, samples_.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
  glDispatchCompute(groupsFor(samples_.width(), groupSide), groupsFor(samples_.height(), groupSide),
                    1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
  glUseProgram(0);
}

// There is always one cluster more than splits. It stays empty unless a cluster is to be divided,
// which then needs no other program.
void SplitRelaxer::request() {
  std::vector<double> ends = relaxation_->ends();
  asked_ = ends.size() + 1;
  const std::size_t clusters = relaxation_->result().splits.size() + 1;
  std::vector<float> limits(clusters, std::numeric_limits<float>::max());
  std::transform(ends.begin(), ends.end(), limits.begin(), roundedDown);

  const auto grid = [](int samples) {
    return std::min<GLuint>(groupsFor(samples, groupSide * ownSamples), largestGrid);
  };
  const GLuint columns = grid(samples_.width()), rows = grid(samples_.height());
  int count = int(columns * rows) * groupSide * groupSide;
  const std::size_t bytes = clusters * std::size_t(count) * sizeof(Sums);
  if (bytes > capacity_) {
    fine_ = makeBuffer(bytes);
    coarse_ = makeBuffer(bytes);
    capacity_ = bytes;
  }
  const GLuint sum = programs_.compute("cluster sums", source(clusters, SplitCluster_comp_glsl));
  gl::setUniform(sum, "umbraSamples", 0);
  gl::setUniform(sum, "umbraEnds", limits);
  glUseProgram(sum);
  glBindTextureUnit(0, samples_.name());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, fine_.name());
  glDispatchCompute(columns, rows, 1);

  const GLuint reduce =
      programs_.compute("sums of cluster sums", source(clusters, SplitReduce_comp_glsl));
  gl::setUniform(reduce, "umbraRun", run);
  glUseProgram(reduce);
  GLuint from = fine_.name(), to = coarse_.name();
  while (count > 1) {
    const int coarse = (count + run - 1) / run;
    gl::setUniform(reduce, "umbraCount", count);
    gl::setUniform(reduce, "umbraCoarseCount", coarse);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, from);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, to);
    glDispatchCompute(groupsFor(coarse * int(clusters), reduceGroup), 1, 1);
    std::swap(from, to);
    count = coarse;
  }
  sums_ = from;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, 0);
  glUseProgram(0);
  fence_.reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
}

bool SplitRelaxer::arrived() const {
  const GLenum status = glClientWaitSync(fence_.get(), GL_SYNC_FLUSH_COMMANDS_BIT, 0);
  return status == GL_ALREADY_SIGNALED || status == GL_CONDITION_SATISFIED;
}

void SplitRelaxer::receive() {
  fence_.reset();
  std::vector<Sums> sums(asked_);
  glGetNamedBufferSubData(sums_, 0, GLsizeiptr(asked_ * sizeof(Sums)), sums.data());
  std::vector<ClusterSums> clusters(asked_);
  for (std::size_t i = 0; i < asked_; ++i)
    if (sums[i].weight > 0.0)
      clusters[i] = {sums[i].weight, sums[i].first, sums[i].second, sums[i].low, sums[i].high};
  relaxation_->take(clusters);
  // The splits that the last map ended with need not be at rest for this one.
  if (std::exchange(oldSums_, false)) relaxation_->resume();
}

void SplitRelaxer::freeMemory() {
  samples_ = gl::Texture();
  fine_.reset();
  coarse_.reset();
  capacity_ = 0;
  fence_.reset();
}

void SplitRelaxer::releaseGraphicsResources() {
  programs_.clear();
  freeMemory();
}

}  // namespace umbra
