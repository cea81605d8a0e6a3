// Probes that are saved: places under names, to be read again and compared.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace umbra {

struct Session;

struct Pixel {
  int x = 0, y = 0;  // of the frame, or texel of a depth file; y down, from 0

  bool operator==(const Pixel&) const = default;
};

// Exactly one of `point` and `texel` is set.
struct NamedProbe {
  static constexpr std::size_t most = 12;         // in a session
  static constexpr std::size_t longestName = 60;  // bytes of UTF-8
  static constexpr double depthOnFile = 0.5;      // the receiver's, where none is set

  std::string name;                      // of all in a session, none twice
  std::optional<Eigen::Vector3d> point;  // of a scene: world, on a surface
  std::optional<Pixel> texel;            // of a depth file
  std::optional<double> receiver;        // [0,1]; where not set the surface's own

  bool operator==(const NamedProbe&) const = default;
};

// Null where there is none of that name.
const NamedProbe* probeNamed(const std::vector<NamedProbe>& probes, std::string_view name);
std::vector<std::string> namesOf(const std::vector<NamedProbe>& probes);
// The wish, or the first of "wish 2", "wish 3" … that is not taken.
std::string freeProbeName(const std::vector<NamedProbe>& probes, const std::string& wish);
// Why a further probe cannot have that name: one sentence; "" where it can.
std::string whyNotProbeName(const std::vector<NamedProbe>& probes, std::string_view name);

// All throw BadInput where it cannot be done: there are too many, or the name is not right.
// The session's probe becomes the saved one: it is where it was.
void saveProbe(Session& session, NamedProbe probe);
void renameProbe(Session& session, const std::string& from, const std::string& to);
void dropProbe(Session& session, const std::string& name);

}  // namespace umbra
