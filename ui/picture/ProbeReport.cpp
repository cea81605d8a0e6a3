#include "ui/picture/ProbeReport.h"

namespace umbra {

const TechniqueResult* resultOf(const Probe& probe, std::string_view id) {
  for (const TechniqueResult& result : probe.techniques)
    if (result.technique->info().id == id) return &result;
  return nullptr;
}

}  // namespace umbra
