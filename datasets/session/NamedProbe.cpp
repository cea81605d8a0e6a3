#include "datasets/session/NamedProbe.h"

#include <algorithm>

#include "datasets/session/Session.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

auto placeOf(std::vector<NamedProbe>& probes, std::string_view name) {
  const auto place = std::find_if(probes.begin(), probes.end(),
                                  [&](const NamedProbe& probe) { return probe.name == name; });
  if (place == probes.end())
    throw Error(ErrorKind::BadInput, "there is no probe '" + std::string(name) + "'");
  return place;
}

}  // namespace

const NamedProbe* probeNamed(const std::vector<NamedProbe>& probes, std::string_view name) {
  for (const NamedProbe& probe : probes)
    if (probe.name == name) return &probe;
  return nullptr;
}

std::vector<std::string> namesOf(const std::vector<NamedProbe>& probes) {
  std::vector<std::string> names;
  for (const NamedProbe& probe : probes) names.push_back(probe.name);
  return names;
}

std::string freeProbeName(const std::vector<NamedProbe>& probes, const std::string& wish) {
  std::string name = wish;
  for (int number = 2; probeNamed(probes, name); ++number)
    name = wish + " " + std::to_string(number);
  return name;
}

std::string whyNotProbeName(const std::vector<NamedProbe>& probes, std::string_view name) {
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20; };
  if (name.find_first_not_of(' ') == std::string_view::npos) return "a probe needs a name";
  if (name.size() > NamedProbe::longestName)
    return "the name is " + std::to_string(name.size()) + " bytes long, it should be at most " +
           std::to_string(NamedProbe::longestName);
  if (std::any_of(name.begin(), name.end(), control))
    return "the name should be one line without tabs";
  if (name == "all") return "'all' stands for every probe, give it another name";
  if (probeNamed(probes, name)) return "there is a probe '" + std::string(name) + "' already";
  return {};
}

void saveProbe(Session& session, NamedProbe probe) {
  if (session.probes.size() >= NamedProbe::most)
    throw Error(ErrorKind::BadInput, "there are " + std::to_string(NamedProbe::most) +
                                         " probes, which is as many as can be saved; delete one");
  if (const std::string reason = whyNotProbeName(session.probes, probe.name); !reason.empty())
    throw Error(ErrorKind::BadInput, reason);
  session.keptProbe = probe.name;
  session.probes.push_back(std::move(probe));
}

void renameProbe(Session& session, const std::string& from, const std::string& to) {
  const auto place = placeOf(session.probes, from);
  if (from == to) return;
  if (const std::string reason = whyNotProbeName(session.probes, to); !reason.empty())
    throw Error(ErrorKind::BadInput, reason);
  place->name = to;
  if (session.keptProbe == from) session.keptProbe = to;
}

void dropProbe(Session& session, const std::string& name) {
  session.probes.erase(placeOf(session.probes, name));
  if (session.keptProbe == name) session.keptProbe.clear();
}

}  // namespace umbra
