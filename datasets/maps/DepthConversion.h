// Turns the values of a depth file into linear depths, row by row, and keeps count of what is no
// depth.
#pragma once

#include <string>
#include <vector>

#include "datasets/maps/DepthFile.h"
#include "datasets/maps/Raster.h"

namespace umbra {

class DepthConversion {
 public:
  // Messages begin with `where`, the file's name.
  DepthConversion(const DepthImport& import, std::string where)
      : import_(import), where_(std::move(where)) {}

  // Throws BadInput where the bounds are one number of the file's.
  void begin(const RasterInfo& info);
  void add(int y, std::span<const double> row);
  // What was read. Throws BadInput for wrong texels that the import does not say what to do with.
  DepthFile finish();

 private:
  struct Wrong {
    int x, y;  // in the file's own count
    double value;
  };

  // The distance to the light, or without a projection the linear depth, of a value that is a
  // depth.
  double read(double value, int x, int y) const;
  bool isInside(double value) const;
  double replaced(double value, int x, int y);
  [[noreturn]] void refuse() const;
  void scaleDistances();

  DepthImport import_;
  std::string where_;
  RasterInfo info_;
  DepthFile file_;
  bool missIsMark_ = false;
  std::size_t wrong_ = 0, clamped_ = 0, marked_ = 0, beyond_ = 0;
  std::vector<Wrong> first_;  // of the wrong ones
  int lowX_ = 0, lowY_ = 0, highX_ = 0, highY_ = 0;
};

}  // namespace umbra
