#include "app/TechniqueSet.h"

#include <spdlog/spdlog.h>

#include "filters/core/Error.h"

namespace umbra {

std::vector<std::shared_ptr<Technique>> makeTechniques(const Session& session,
                                                       const TechniqueCatalogue& catalogue,
                                                       const std::vector<std::string>& ids) {
  const StorageFormat format = session.frame.map.format;
  std::vector<std::shared_ptr<Technique>> techniques;
  for (const std::string& id : ids) {
    std::vector<std::string> notices;
    techniques.push_back(techniqueOf(session, catalogue, id, &notices));
    for (const std::string& notice : notices) spdlog::warn("{}: {}", id, notice);
    const std::string refusal = techniques.back()->refusal(format);
    if (!refusal.empty())
      throw Error(ErrorKind::BadCommandLine,
                  "--format " + std::string(nameOf(format)) + ": " + id + ": " + refusal);
  }
  return techniques;
}

void checkGpuFormat(const Session& session) {
  const StorageFormat format = session.frame.map.format;
  if (format != StorageFormat::Half && format != StorageFormat::Float)
    throw Error(ErrorKind::BadCommandLine,
                "--format: " + std::string(nameOf(format)) +
                    " is only for depth maps, a scene takes half or float");
}

}  // namespace umbra
