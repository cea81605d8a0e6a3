// Where a value stands on a slider, and back.
#pragma once

namespace umbra {

// `low` and `high` are inclusive; a logarithmic scale from 0 has 0 at its first position and
// ten decades above it.
struct SliderScale {
  double low = 0.0, high = 1.0;
  bool logarithmic = false;
  bool whole = false;  // values are integers, one position each

  // Positions are 0 … positions(): the ends are exactly low and high.
  int positions() const;
  int positionOf(double value) const;
  // Rounded to what a position resolves, so that a dragged value is short to read and to write.
  double valueAt(int position) const;
  // The value `steps` clicks up (or down) of a box's arrow keys, within the range.
  double stepped(double value, int steps) const;

 private:
  bool isLogarithmic() const { return logarithmic && low >= 0.0 && high > 0.0; }
  double smallest() const { return low > 0.0 ? low : high * 1e-10; }  // of a logarithmic scale
};

}  // namespace umbra
