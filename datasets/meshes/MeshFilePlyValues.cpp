#include "datasets/meshes/MeshFilePlyValues.h"

#include <bit>
#include <cmath>

#include "datasets/meshes/MeshFileText.h"

namespace umbra::meshfile {

std::string_view PlyValues::word() {
  const std::string_view word = nextWord(rest_);
  if (word.empty()) throw PlyProblem{true, ""};
  return word;
}

std::uint64_t PlyValues::bytes(int count) {
  if (rest_.size() < std::size_t(count)) throw PlyProblem{true, ""};
  std::uint64_t value = 0;
  for (int i = 0; i < count; ++i) {
    const int shift = format_ == PlyFormat::BigEndian ? count - 1 - i : i;
    value |= std::uint64_t(static_cast<unsigned char>(rest_[std::size_t(i)])) << (8 * shift);
  }
  rest_.remove_prefix(std::size_t(count));
  return value;
}

double PlyValues::real(const PlyType& type) {
  if (format_ == PlyFormat::Ascii) {
    const std::string_view found = word();
    const std::optional<double> value = realFrom(found);
    if (!value) throw PlyProblem{false, std::string(found)};
    return *value;
  }
  if (!type.real) return double(whole(type));
  const std::uint64_t value = bytes(type.bytes);
  return type.bytes == 4 ? double(std::bit_cast<float>(std::uint32_t(value)))
                         : std::bit_cast<double>(value);
}

std::int64_t PlyValues::whole(const PlyType& type) {
  if (format_ == PlyFormat::Ascii) {
    const std::string_view found = word();
    std::optional<std::int64_t> value = wholeFrom(found);
    // A type of real numbers writes 4 as 4.0.
    const std::optional<double> number = type.real && !value ? realFrom(found) : std::nullopt;
    if (number && std::floor(*number) == *number && std::abs(*number) < 1e15)
      value = std::int64_t(*number);
    if (!value) throw PlyProblem{false, std::string(found)};
    return *value;
  }
  if (type.real) {
    const double value = real(type);
    if (std::floor(value) != value || std::abs(value) > 1e15)
      throw PlyProblem{false, std::to_string(value)};
    return std::int64_t(value);
  }
  const std::uint64_t value = bytes(type.bytes);
  const std::uint64_t sign = std::uint64_t(1) << (8 * type.bytes - 1);
  if (type.isSigned && (value & sign)) return std::int64_t(value) - std::int64_t(sign << 1);
  return std::int64_t(value);
}

void PlyValues::skip(const PlyType& type, std::uint64_t count) {
  if (format_ == PlyFormat::Ascii) {
    for (std::uint64_t i = 0; i < count; ++i) word();
    return;
  }
  const std::uint64_t size = count * std::uint64_t(type.bytes);
  if (rest_.size() < size) throw PlyProblem{true, ""};
  rest_.remove_prefix(size);
}

bool PlyValues::hasMore() const {
  return !trimmed(rest_).empty();
}

}  // namespace umbra::meshfile
