#include "filters/core/scene/Weld.h"

#include <array>
#include <bit>
#include <unordered_map>

namespace umbra {
namespace {

using PositionBits = std::array<std::uint32_t, 3>;

struct PositionHash {
  std::size_t operator()(const PositionBits& bits) const {
    std::uint64_t hash = 0;
    for (std::uint32_t b : bits) hash = (hash ^ b) * 0x9e3779b97f4a7c15u, hash ^= hash >> 29;
    return std::size_t(hash);
  }
};

PositionBits bitsOf(const Eigen::Vector3f& p) {
  // Adding 0 makes +0 of −0.
  return {std::bit_cast<std::uint32_t>(p.x() + 0.0f), std::bit_cast<std::uint32_t>(p.y() + 0.0f),
          std::bit_cast<std::uint32_t>(p.z() + 0.0f)};
}

}  // namespace

std::vector<std::uint32_t> firstOfEqual(const std::vector<Eigen::Vector3f>& positions) {
  std::unordered_map<PositionBits, std::uint32_t, PositionHash> first;
  first.reserve(positions.size());
  std::vector<std::uint32_t> found;
  found.reserve(positions.size());
  for (const Eigen::Vector3f& p : positions)
    found.push_back(first.try_emplace(bitsOf(p), std::uint32_t(found.size())).first->second);
  return found;
}

}  // namespace umbra
