// The values of a PLY file's body, text or binary, one after the other.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "datasets/meshes/MeshFilePlyHeader.h"

namespace umbra::meshfile {

// What could not be read where a number ought to be.
struct PlyProblem {
  bool atEnd = false;  // the body ends before the value does
  std::string found;   // otherwise what stands there
};

class PlyValues {
 public:
  PlyValues(std::string_view body, PlyFormat format) : rest_(body), format_(format) {}

  // The next value; a whole one is exact. Throws PlyProblem.
  double real(const PlyType& type);
  // The next value as a whole number: an index, or a list's length. Throws PlyProblem.
  std::int64_t whole(const PlyType& type);
  void skip(const PlyType& type, std::uint64_t count);
  // Bytes that are left. A value has one at least.
  std::size_t left() const { return rest_.size(); }
  // Whether something but blanks is left.
  bool hasMore() const;

 private:
  std::string_view word();
  std::uint64_t bytes(int count);

  std::string_view rest_;
  PlyFormat format_;
};

}  // namespace umbra::meshfile
