#include "datasets/Session.h"

namespace umbra {

std::unique_ptr<Technique> techniqueOf(const Session& session, const TechniqueCatalogue& catalogue,
                                       const std::string& id, std::vector<std::string>* notices) {
  std::unique_ptr<Technique> technique = catalogue.make(id);
  if (const auto set = session.parameters.find(id); set != session.parameters.end()) {
    const std::vector<Parameter> parameters = technique->parameters();
    for (const auto& [name, value] : set->second) {
      const std::string where = id + "." + name;
      parameterNamed(parameters, name, where).set(value, where);
    }
  }
  const std::vector<std::string> limited = technique->limitTo(session.frame.map.format);
  if (notices) notices->insert(notices->end(), limited.begin(), limited.end());
  return technique;
}

}  // namespace umbra
