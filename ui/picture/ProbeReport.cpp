#include "ui/picture/ProbeReport.h"

namespace umbra {

const TechniqueResult* resultOf(const Probe& probe, std::string_view id) {
  for (const TechniqueResult& result : probe.techniques)
    if (result.technique->info().id == id) return &result;
  return nullptr;
}

const char* verdictOf(double error) {
  // Less than one grey level of the picture is no error that anybody sees.
  constexpr double visible = 1.0 / 255.0;
  if (error > visible) return "light bleeding";
  if (error < -visible) return "over-darkening";
  return "no visible error";
}

}  // namespace umbra
