#include "datasets/session/file/SessionInExr.h"

#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>

#include <nlohmann/json.hpp>

#include "datasets/maps/ExrAttributes.h"
#include "datasets/session/file/SessionFile.h"
#include "filters/core/support/InputFile.h"

namespace umbra {

std::string sessionText(const Workspace& workspace) {
  Workspace whole = workspace;
  SceneSource& source = whole.shared.source;
  if (source.kind != SourceKind::Catalogue)
    source.name = std::filesystem::absolute(source.name).lexically_normal().string();
  return toJson(whole).dump();
}

std::map<std::string, std::string> sessionAttributes(const Workspace& workspace,
                                                     const std::string& version) {
  return {{"umbrascope.version", version}, {sessionAttribute, sessionText(workspace)}};
}

std::optional<std::string> sessionInExr(const std::filesystem::path& file) {
  checkInput(file);
  checkExrAttributes(file);
  try {
    const Imf::MultiPartInputFile input(file.c_str());
    const Imf::Header& header = input.header(0);
    for (const char* name : {workspaceAttribute, sessionAttribute})
      if (const auto* text = header.findTypedAttribute<Imf::StringAttribute>(name))
        return text->value();
  } catch (const std::exception&) {
    return std::nullopt;  // whoever reads it as a depth map says what is wrong
  }
  return std::nullopt;
}

}  // namespace umbra
