#include "datasets/session/Session.h"

#include "filters/core/support/Error.h"
#include "filters/core/technique/Composition.h"

namespace umbra {
namespace {

void setAll(const ParameterValues& values, std::span<const Parameter> parameters,
            const std::string& id) {
  for (const auto& [name, value] : values) {
    const std::string where = id + "." + name;
    parameterNamed(parameters, name, where).set(value, where);
  }
}

// As the session says, whatever its storage format holds.
std::unique_ptr<Technique> unlimited(const Session& session, const TechniqueCatalogue& catalogue,
                                     const std::string& id) {
  std::unique_ptr<Technique> technique = catalogue.make(id);
  setAll(parametersOf(session, id), technique->parameters(), id);
  return technique;
}

}  // namespace

ParameterValues parametersOf(const Session& session, const std::string& id) {
  const auto set = session.parameters.find(id);
  return set == session.parameters.end() ? ParameterValues{} : set->second;
}

void setParameters(Session& session, const std::string& id, ParameterValues values) {
  if (values.empty())
    session.parameters.erase(id);
  else
    session.parameters[id] = std::move(values);
}

std::unique_ptr<Technique> techniqueOf(const Session& session, const TechniqueCatalogue& catalogue,
                                       const std::string& id, std::vector<std::string>* notices) {
  std::unique_ptr<Technique> technique = unlimited(session, catalogue, id);
  const std::vector<std::string> limited = technique->limitTo(session.frame.map.format);
  if (notices) notices->insert(notices->end(), limited.begin(), limited.end());
  return technique;
}

std::string whyReadInexactly(const Session& session, const Technique& technique) {
  return session.source.kind == SourceKind::DepthFile ? "" : whyInexact(session.frame, technique);
}

void editParameters(Session& session, const TechniqueCatalogue& catalogue, const std::string& id,
                    const std::function<void(std::span<const Parameter>)>& change) {
  const std::unique_ptr<Technique> technique = unlimited(session, catalogue, id);
  const std::vector<Parameter> parameters = technique->parameters();
  change(parameters);
  ParameterValues values;
  for (const Parameter& parameter : parameters)
    if (const ParameterValue value = parameter.get(); value != parameter.defaultValue)
      values[std::string(parameter.name)] = value;
  setParameters(session, id, std::move(values));
}

void checkTogether(const ParameterValues& values, Technique& technique, std::string_view where) {
  const std::vector<Parameter> parameters = technique.parameters();
  setAll(values, parameters, std::string(where));
  for (const auto& [name, value] : values) {
    const ParameterValue became = parameterNamed(parameters, name, where).get();
    if (became != value)
      throw Error(ErrorKind::BadInput, std::string(where) + "." + name + ": '" + toText(value) +
                                           "' contradicts the other parameters, which make it '" +
                                           toText(became) + "'");
  }
}

}  // namespace umbra
