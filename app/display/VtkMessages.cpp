#include "app/display/VtkMessages.h"

#include <spdlog/spdlog.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <utility>

#include "filters/core/support/Error.h"

namespace umbra {
namespace {

// "ERROR: In file.cxx, line 7\nvtkClass (0x5581): what\n\n" becomes "vtkClass: what".
std::string essence(std::string text) {
  if (const std::size_t header = text.find(", line "); header != std::string::npos)
    if (const std::size_t end = text.find('\n', header); end != std::string::npos)
      text.erase(0, end + 1);
  if (const std::size_t address = text.find(" (0x"); address != std::string::npos)
    if (const std::size_t end = text.find(')', address); end != std::string::npos)
      text.erase(address, end + 1 - address);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

}  // namespace

vtkStandardNewMacro(VtkMessages);

void VtkMessages::DisplayText(const char* text) {
  spdlog::info("{}", essence(text));
}

void VtkMessages::DisplayErrorText(const char* text) {
  if (firstError_.empty()) firstError_ = essence(text);
}

void VtkMessages::DisplayWarningText(const char* text) {
  spdlog::warn("{}", essence(text));
}

void VtkMessages::DisplayGenericWarningText(const char* text) {
  DisplayWarningText(text);
}

void VtkMessages::throwFirstError() {
  const std::string error = std::exchange(firstError_, {});
  if (!error.empty()) throw Error(ErrorKind::WorkFailed, error);
}

}  // namespace umbra
