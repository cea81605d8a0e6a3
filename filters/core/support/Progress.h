// Tells how far long work has come, and lets the one who hears it stop the work.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace umbra {

class Progress {
 public:
  // Nobody hears it.
  Progress() = default;
  // `hear` gets parts from 0 to 1 that do not fall, on the thread of the work. What it throws ends
  // the work.
  explicit Progress(std::function<void(double part)> hear) : hear_(std::move(hear)) {}

  // For a step of the work, counted from 0, of `count`: most steps of short ones are not told.
  void step(std::size_t index, std::size_t count) const {
    constexpr std::size_t told = 16384;
    if (hear_ && index % told == 0) tell(double(index) / double(count));
  }
  // A part of this work that is done, from 0 to 1.
  void tell(double part) const {
    if (hear_) hear_(from_ + part * (to_ - from_));
  }
  // That of a stage, which is a part of this work.
  Progress stage(double from, double to) const {
    Progress inner = *this;
    inner.from_ = from_ + from * (to_ - from_);
    inner.to_ = from_ + to * (to_ - from_);
    return inner;
  }

 private:
  std::function<void(double)> hear_;
  double from_ = 0.0, to_ = 1.0;
};

}  // namespace umbra
