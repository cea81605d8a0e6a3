#include "app/frames/TechniqueSet.h"

#include <spdlog/spdlog.h>

#include "filters/core/support/Error.h"
#include "filters/core/technique/Composition.h"

namespace umbra {
namespace {

// Throws the reason as an error of the option that set what the technique cannot have.
[[noreturn]] void refuse(const FrameSettings& frame, const Technique& technique,
                         const std::string& reason) {
  const bool format = !technique.refusal(frame.map.format).empty();
  throw Error(
      ErrorKind::BadCommandLine,
      (format ? "--format " + std::string(nameOf(frame.map.format)) + ": " : "--") + reason);
}

}  // namespace

std::vector<std::shared_ptr<Technique>> makeTechniques(const Session& session,
                                                       const TechniqueCatalogue& catalogue,
                                                       const TechniqueChoice& choice) {
  std::vector<std::shared_ptr<Technique>> techniques;
  std::vector<std::string> leftOut;
  std::shared_ptr<Technique> last;  // the last technique that was left out
  for (const std::string& id : choice.ids) {
    std::vector<std::string> notices;
    std::shared_ptr<Technique> technique = techniqueOf(session, catalogue, id, &notices);
    if (const std::string reason = whyImpossible(session.frame, *technique); !reason.empty()) {
      if (!choice.all) refuse(session.frame, *technique, reason);
      leftOut.push_back(reason);
      last = std::move(technique);
      continue;
    }
    if (const std::string loss = whyReadInexactly(session, *technique); !loss.empty())
      notices.push_back(loss);
    for (const std::string& notice : notices) spdlog::warn("{}: {}", id, notice);
    techniques.push_back(std::move(technique));
  }
  if (techniques.empty() && last) refuse(session.frame, *last, leftOut.back());
  for (const std::string& reason : leftOut) spdlog::warn("left out: {}", reason);
  return techniques;
}

std::string whyNoGpuFormat(const Session& session) {
  if (session.frame.map.format != StorageFormat::Double) return {};
  return "--format: double is only for depth maps, since the GPU stores 32 bits at most; a scene "
         "takes unorm8, unorm16, half or float";
}

void checkGpuFormat(const Session& session) {
  if (const std::string why = whyNoGpuFormat(session); !why.empty())
    throw Error(ErrorKind::BadCommandLine, why);
}

}  // namespace umbra
