#include "analysis/stored/StoredFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace umbra {
namespace {

// Kernels up to this radius are tried, and the one given.
constexpr int largestTried = 12;
// The part of the map that assumptions are tried on, in texels a side. The kernels read beyond it.
constexpr int partSide = 96;
// Shifts are tried to this many texels, in halves.
constexpr int largestShift = 2;

// What is read of the map around the part: a kernel, and a shift with its neighbour.
int apronOf(const StoredQuestion& question) {
  return std::max(largestTried, question.kernel.effectiveRadius()) + largestShift + 1;
}

Image<double> partOf(const Image<double>& image, int left, int top, int width, int height) {
  Image<double> part(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) part(x, y) = image(left + x, top + y);
  return part;
}

// A rectangle of the map in which what is stored is held against what is assumed.
struct Window {
  int left = 0, top = 0, width = 0, height = 0;
};

class Fitter {
 public:
  Fitter(const StoredQuestion& question, const Image<double>& stored,
         const std::function<void()>& between)
      : question_(question), between_(between) {
    const Image<double> exact = expectedUnder(given(), question).values;
    const Window window = windowOf(exact, stored);
    for (const bool below : {false, true}) {
      const Image<double> asRead = below ? turned(stored) : stored;
      Side side;
      side.window = window;
      const int apron = apronOf(question);
      const int left = std::max(side.window.left - apron, 0),
                top = std::max(side.window.top - apron, 0);
      const int right = std::min(side.window.left + side.window.width + apron, exact.width()),
                bottom = std::min(side.window.top + side.window.height + apron, exact.height());
      side.map = partOf(question.map, left, top, right - left, bottom - top);
      side.stored =
          partOf(asRead, side.window.left, side.window.top, side.window.width, side.window.height);
      side.left = side.window.left - left;
      side.top = side.window.top - top;
      sides_.push_back(std::move(side));
    }
  }

  std::optional<StoredExplanation> best() {
    const Image<double> exact = baseOf(given());
    before_ = rms(exact, given());
    tryAll();
    const double most = std::min(mostLeft * before_, mostOfSpread * spreadOf(sides_[0].stored));
    if (!best_ || (!best_->isWhole && best_->after > most)) return std::nullopt;
    best_->before = before_;
    return best_;
  }

 private:
  // What is stored, read from above or from below, and the map around it.
  struct Side {
    Window window;
    DepthMap map;
    Image<double> stored;
    int left = 0, top = 0;  // of the window in `map`
  };

  StoredAssumption given() const {
    StoredAssumption assumption;
    assumption.kernel = question_.kernel;
    return assumption;
  }

  // Where the difference is largest, and far enough from the edge that all kernels end within the
  // map, if it is wide enough for that: edges may be treated in another way.
  Window windowOf(const Image<double>& exact, const Image<double>& stored) const {
    const auto sideOf = [&](int extent) {
      const int margin = extent > 4 * apronOf(question_) ? apronOf(question_) : 0;
      return std::pair(margin, std::min(partSide, extent - 2 * margin));
    };
    const auto [marginX, width] = sideOf(exact.width());
    const auto [marginY, height] = sideOf(exact.height());
    Window found{marginX, marginY, width, height};
    double largest = -1.0;
    for (int top = marginY; top + height + marginY <= exact.height(); top += (height + 1) / 2)
      for (int left = marginX; left + width + marginX <= exact.width(); left += (width + 1) / 2) {
        double sum = 0.0;
        for (int y = top; y < top + height; ++y)
          for (int x = left; x < left + width; ++x) {
            const double difference = std::abs(stored(x, y) - exact(x, y));
            if (std::isfinite(difference)) sum += difference;
          }
        if (sum > largest) largest = sum, found = {left, top, width, height};
      }
    return found;
  }

  const Side& sideOf(const StoredAssumption& assumption) const {
    return sides_[assumption.rowsFromBelow ? 1 : 0];
  }

  Image<double> baseOf(const StoredAssumption& assumption) const {
    return valuesIn(sideOf(assumption).map, assumption, question_);
  }

  // Calls visit(assumed, stored) for each texel of the window that holds a number.
  template <class Visit>
  void forEach(const Image<double>& base, const StoredAssumption& assumption,
               const Visit& visit) const {
    const Side& side = sideOf(assumption);
    for (int y = 0; y < side.window.height; ++y)
      for (int x = 0; x < side.window.width; ++x) {
        const double value = side.stored(x, y);
        if (std::isfinite(value))
          visit(mixedAt(base, side.left + x - assumption.shiftX, side.top + y - assumption.shiftY),
                value);
      }
  }

  double rms(const Image<double>& base, const StoredAssumption& assumption) const {
    double sum = 0.0, count = 0.0;
    forEach(base, assumption, [&](double assumed, double stored) {
      const double difference = assumption.scale * assumed + assumption.offset - stored;
      sum += difference * difference;
      ++count;
    });
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
  }

  // Whether nothing is left but rounding.
  bool isWhole(const Image<double>& base, const StoredAssumption& assumption) const {
    const StoredExpectation expected = expectedIn(sideOf(assumption).map, assumption, question_);
    bool isRounding = true;
    const Side& side = sideOf(assumption);
    const double scale = std::abs(assumption.scale);
    const double ofOffset = 0x1p-23 * std::abs(assumption.offset);
    for (int y = 0; y < side.window.height && isRounding; ++y)
      for (int x = 0; x < side.window.width; ++x) {
        const double value = side.stored(x, y);
        const double atX = side.left + x - assumption.shiftX,
                     atY = side.top + y - assumption.shiftY;
        const double assumed = assumption.scale * mixedAt(base, atX, atY) + assumption.offset;
        if (std::isfinite(value) &&
            std::abs(assumed - value) > scale * mixedAt(expected.allowance, atX, atY) + ofOffset)
          isRounding = false;
      }
    return isRounding;
  }

  // Fewer changes that explain all are better than more; then what leaves less.
  void consider(const Image<double>& base, const StoredAssumption& assumption) {
    StoredExplanation found{assumption, changesOf(assumption, question_.kernel), false, 0.0, 0.0};
    if (found.changes == 0) return;
    found.after = rms(base, assumption);
    if (found.after > 0.5 * before_) return;
    found.isWhole = isWhole(base, assumption);
    const auto worth = [](const StoredExplanation& one) {
      // What is not explained is compared by what is left, each change counted as twice as much. Of
      // two that explain all, as on a map of stripes, the one that shifts less is meant.
      const double shift = std::abs(one.assumption.shiftX) + std::abs(one.assumption.shiftY);
      return one.isWhole ? std::tuple(0, double(one.changes), shift, one.after)
                         : std::tuple(1, one.after * std::pow(2.0, one.changes), shift, 0.0);
    };
    if (!best_ || worth(found) < worth(*best_)) best_ = found;
  }

  // The scale and the offset by least squares, where the base varies at all.
  void considerScaled(const Image<double>& base, StoredAssumption assumption) {
    double n = 0.0, sumB = 0.0, sumS = 0.0, bb = 0.0, bs = 0.0;
    forEach(base, assumption, [&](double assumed, double stored) {
      ++n, sumB += assumed, sumS += stored, bb += assumed * assumed, bs += assumed * stored;
    });
    const double variance = n * bb - sumB * sumB;
    if (!(variance > 1e-9 * n * bb)) return;
    assumption.scale = (n * bs - sumB * sumS) / variance;
    assumption.offset = (sumS - assumption.scale * sumB) / n;
    // What least squares leave of 1 and of 0 is rounding.
    if (std::abs(assumption.scale - 1.0) < 1e-9) assumption.scale = 1.0;
    if (std::abs(assumption.offset) < 1e-9 * std::sqrt((bb + 1e-300) / n)) assumption.offset = 0.0;
    if (std::abs(assumption.scale) > 1e-6) consider(base, assumption);
  }

  void considerShifts(const Image<double>& base, StoredAssumption assumption) {
    for (int j = -2 * largestShift; j <= 2 * largestShift; ++j)
      for (int i = -2 * largestShift; i <= 2 * largestShift; ++i) {
        assumption.shiftX = 0.5 * i;
        assumption.shiftY = 0.5 * j;
        consider(base, assumption);
      }
  }

  std::vector<Kernel> kernels() const {
    std::vector<Kernel> all{question_.kernel};
    const auto add = [&](const Kernel& kernel) {
      if (std::find(all.begin(), all.end(), kernel) == all.end()) all.push_back(kernel);
    };
    add({KernelShape::None, 0, 0.0});
    for (int radius = 1; radius <= largestTried; ++radius) {
      add({KernelShape::Box, radius, 0.0});
      add({KernelShape::Gaussian, radius, 0.0});
    }
    return all;
  }

  void tryAll() {
    for (const bool below : {false, true})
      for (const Kernel& kernel : kernels()) {
        between_();
        StoredAssumption assumption = given();
        assumption.kernel = kernel;
        assumption.rowsFromBelow = below;
        tryQuantities(assumption);
      }
    for (int radius = 1; radius <= largestTried; ++radius) {
      between_();
      trySigma(radius);
    }
  }

  void tryQuantities(StoredAssumption assumption) {
    const auto channels = int(question_.technique.channels().size());
    const auto tryOne = [&](bool shifted) {
      const Image<double> base = baseOf(assumption);
      consider(base, assumption);
      considerScaled(base, assumption);
      if (shifted) considerShifts(base, assumption);
    };
    const bool isGivenKernel = assumption.kernel == question_.kernel;
    for (StoredQuantity quantity : {StoredQuantity::Own, StoredQuantity::AfterFilter,
                                    StoredQuantity::Depth, StoredQuantity::Reversed}) {
      assumption.quantity = quantity;
      tryOne(!assumption.rowsFromBelow && (isGivenKernel || quantity == StoredQuantity::Own));
    }
    assumption.quantity = StoredQuantity::OtherChannel;
    for (assumption.other = 0; assumption.other < channels; ++assumption.other)
      if (assumption.other != question_.channel) tryOne(isGivenKernel);
  }

  // The sigma that leaves least, by a search of the golden section.
  void trySigma(int radius) {
    StoredAssumption assumption = given();
    assumption.kernel = {KernelShape::Gaussian, radius, 0.0};
    const auto left = [&](double sigma) {
      assumption.kernel.sigma = sigma;
      return rms(baseOf(assumption), assumption);
    };
    constexpr double golden = 0.6180339887498949;
    double low = 0.3, high = 2.0 * radius;
    double a = high - golden * (high - low), b = low + golden * (high - low);
    double atA = left(a), atB = left(b);
    while (high - low > 1e-7 * high) {
      if (atA < atB) {
        high = b, b = a, atB = atA, a = high - golden * (high - low), atA = left(a);
      } else {
        low = a, a = b, atA = atB, b = low + golden * (high - low), atB = left(b);
      }
    }
    assumption.kernel.sigma = 0.5 * (low + high);
    consider(baseOf(assumption), assumption);
  }

  const StoredQuestion& question_;
  const std::function<void()>& between_;
  std::vector<Side> sides_;  // from above, from below
  double before_ = 0.0;
  std::optional<StoredExplanation> best_;
};

}  // namespace

double spreadOf(const Image<double>& stored) {
  double count = 0.0, sum = 0.0, squares = 0.0;
  for (double value : stored.values())
    if (std::isfinite(value)) ++count, sum += value;
  const double mean = count > 0.0 ? sum / count : 0.0;
  for (double value : stored.values())
    if (std::isfinite(value)) squares += (value - mean) * (value - mean);
  return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

std::optional<StoredExplanation> explainStored(const StoredQuestion& question,
                                               const Image<double>& stored,
                                               const std::function<void()>& between) {
  return Fitter(question, stored, between).best();
}

}  // namespace umbra
