#include "app/TechniqueSet.h"

#include <spdlog/spdlog.h>

#include "filters/core/Error.h"

namespace umbra {

std::vector<std::shared_ptr<Technique>> makeTechniques(const Session& session,
                                                       const TechniqueCatalogue& catalogue,
                                                       const TechniqueChoice& choice) {
  const StorageFormat format = session.frame.map.format;
  std::vector<std::shared_ptr<Technique>> techniques;
  for (const std::string& id : choice.ids) {
    std::vector<std::string> notices;
    std::shared_ptr<Technique> technique = techniqueOf(session, catalogue, id, &notices);
    if (const std::string refusal = technique->refusal(format); !refusal.empty()) {
      if (!choice.all)
        throw Error(ErrorKind::BadCommandLine,
                    "--format " + std::string(nameOf(format)) + ": " + refusal);
      spdlog::warn("left out: {}", refusal);
      continue;
    }
    for (const std::string& notice : notices) spdlog::warn("{}: {}", id, notice);
    techniques.push_back(std::move(technique));
  }
  return techniques;
}

void checkGpuFormat(const Session& session) {
  if (session.frame.map.format == StorageFormat::Double)
    throw Error(ErrorKind::BadCommandLine,
                "--format: double is only for depth maps, since the GPU stores 32 bits at most; a "
                "scene takes unorm8, unorm16, half or float");
}

}  // namespace umbra
