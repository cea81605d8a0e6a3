#include "datasets/maps/DepthGuesses.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "filters/core/support/Parameters.h"

namespace umbra {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Values crowd in a tenth where more than this part of them lies there.
constexpr double crowdShare = 0.5;
// A background is this part of the texels at least.
constexpr double backgroundShare = 0.05;

std::string holding(std::size_t texels, const std::string& what) {
  return std::to_string(texels) + (texels == 1 ? " texel holds " : " texels hold ") + what;
}

std::string percent(std::size_t part, std::size_t whole) {
  return std::to_string(std::lround(100.0 * double(part) / double(whole))) + " %";
}

// A bound in as few digits as the file's numbers have: 0.7 stands for the float nearest to it.
double inFewDigits(double value, RasterNumber number) {
  const std::string text = shortest(value, number);
  double read = value;
  std::from_chars(text.data(), text.data() + text.size(), read);
  return read;
}

class Guesser {
 public:
  Guesser(const RawDepths& raw, const DepthImport& present) : raw_(raw), present_(present) {}

  std::vector<DepthGuess> all() {
    guessMarks();
    guessRange();
    if (raw_.finite > 0 && raw_.lowest.value >= 0.0 && raw_.highest.value <= 1.0) guessProjection();
    return std::move(guesses_);
  }

 private:
  void add(const std::string& reason, const std::string& action, const DepthImport& import,
           bool needsPlanes = false) {
    if (import != present_) guesses_.push_back({reason, action, import, needsPlanes});
  }

  void mark(const std::string& reason, double value) {
    DepthImport import = present_;
    import.miss = {DepthMiss::Kind::Value, value};
    add(reason + ".", "These saw nothing", import);
    ++marks_;
  }

  std::string shown(double value) const { return shortest(value, raw_.info.number); }

  // Values that are perhaps no depths, but stand for what the light did not reach.
  void guessMarks() {
    const RawDepths::End &lowest = raw_.lowest, &highest = raw_.highest;
    if (raw_.finite > 0 && highest.apart)
      mark(holding(highest.texels, shown(highest.value)) + ", and no other value exceeds " +
               shown(highest.next),
           highest.value);
    if (raw_.plusInfinite > 0) mark(holding(raw_.plusInfinite, "infinity"), infinity);
    if (raw_.minusInfinite > 0) mark(holding(raw_.minusInfinite, "−infinity"), -infinity);
    if (raw_.notNumbers > 0) mark(holding(raw_.notNumbers, "no number"), std::nan(""));
    if (raw_.finite > 0 && lowest.apart)
      mark(holding(lowest.texels, shown(lowest.value)) + ", and all others hold " +
               shown(lowest.next) + " or more",
           lowest.value);
    if (marks_ < 2) return;
    DepthImport import = present_;
    import.miss = {DepthMiss::Kind::Clamp, 0.0};
    add("Several values are perhaps no depths.", "Take the nearest bound for each", import);
  }

  void guessRange() {
    const double least = std::min(present_.atZero, present_.atOne),
                 most = std::max(present_.atZero, present_.atOne);
    const bool beyond = raw_.low < std::min(least, rounded(least, raw_.info.number)) ||
                        raw_.high > std::max(most, rounded(most, raw_.info.number));
    if (raw_.finite == 0 || !(raw_.low < raw_.high) || !beyond) return;
    DepthImport import = present_;
    const bool falling = present_.atZero > present_.atOne;
    import.atZero = inFewDigits(falling ? raw_.high : raw_.low, raw_.info.number);
    import.atOne = inFewDigits(falling ? raw_.low : raw_.high, raw_.info.number);
    add("Values lie from " + shown(raw_.low) + " to " + shown(raw_.high) + ", beyond the range.",
        "Take this range", import);
  }

  void project(const std::string& reason, const std::string& action, DepthProjection::Kind kind) {
    DepthImport import = present_;
    import.projection.kind = kind;
    const DepthProjection& planes = import.projection;
    add(reason, action, import, !(planes.near > 0.0 && planes.far > planes.near));
  }

  void guessProjection() {
    if (present_.projection.kind != DepthProjection::Kind::Linear) return;
    if (present_.atZero > present_.atOne) return;
    const std::size_t hit = raw_.finite - raw_.zeros, below = raw_.finite - raw_.ones;
    const bool backgroundIsZero = raw_.zeros > 0 && raw_.ones == 0;
    if (backgroundIsZero && double(raw_.inLowestTenth) > crowdShare * double(hit)) {
      project(holding(raw_.zeros, "exactly 0") + ", and " + percent(raw_.inLowestTenth, hit) +
                  " of the others lie below 0.1: a reversed projection leaves it so.",
              "Reversed, with near and far", DepthProjection::Kind::Reversed);
    } else if (backgroundIsZero && double(raw_.zeros) >= backgroundShare * double(raw_.finite)) {
      DepthImport import = present_;
      std::swap(import.atZero, import.atOne);
      add(holding(raw_.zeros, "exactly 0") + " and none 1: nearer is perhaps larger.",
          "Turn the range round", import);
    }
    if (double(raw_.inHighestTenth) > crowdShare * double(below))
      project(percent(raw_.inHighestTenth, below) +
                  (raw_.ones > 0 ? " of the values other than 1" : " of the values") +
                  " lie above 0.9: a perspective projection leaves it so.",
              "Perspective, with near and far", DepthProjection::Kind::Perspective);
  }

  const RawDepths& raw_;
  const DepthImport& present_;
  std::vector<DepthGuess> guesses_;
  int marks_ = 0;
};

}  // namespace

std::vector<DepthGuess> depthGuesses(const RawDepths& raw, const DepthImport& present) {
  return Guesser(raw, present).all();
}

}  // namespace umbra
