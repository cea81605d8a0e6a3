#include "datasets/maps/ExrAttributes.h"

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

constexpr std::uint32_t magic = 20000630, severalParts = 0x1000;
constexpr std::size_t longestWord = 255;  // bytes, of an attribute and of its type

// Walks a header, whose layout is: attributes, each a name, a type, a size and as many bytes; an
// empty name ends it. Nothing where the file ends or errs.
class HeaderWalk {
 public:
  HeaderWalk(const std::filesystem::path& file, std::uintmax_t size)
      : file_(file), size_(size), stream_(file, std::ios::binary) {}

  void check() {
    if (number() != magic) return;
    const std::optional<std::uint32_t> version = number();
    if (!version) return;
    // An empty header ends the list in a file of several parts.
    while (checkHeader() && (*version & severalParts)) {
    }
  }

 private:
  // Whether it had attributes and ended as it should.
  bool checkHeader() {
    for (bool any = false;; any = true) {
      const std::optional<std::string> name = word();
      if (!name || name->empty()) return name && any;
      const std::optional<std::string> type = word();
      const std::optional<std::uint32_t> length = number();
      if (!type || !length) return false;
      const auto left = size_ - std::uintmax_t(stream_.tellg());
      if (*length > left)
        throw Error(ErrorKind::BadInput, file_.string() + ": the attribute '" + clipped(*name) +
                                             "' promises " + std::to_string(*length) +
                                             " bytes, the file has " + std::to_string(left) +
                                             " after it");
      stream_.seekg(*length, std::ios::cur);
    }
  }

  std::optional<std::uint32_t> number() {  // the first byte is the lowest
    unsigned char bytes[4] = {};
    if (!stream_.read(reinterpret_cast<char*>(bytes), 4)) return std::nullopt;
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | std::uint32_t(bytes[3]) << 24;
  }

  std::optional<std::string> word() {
    std::string text;
    for (char c = 0; stream_.get(c) && text.size() <= longestWord; text += c)
      if (c == '\0') return text;
    return std::nullopt;
  }

  const std::filesystem::path& file_;
  std::uintmax_t size_;
  std::ifstream stream_;
};

}  // namespace

void checkExrAttributes(const std::filesystem::path& file) {
  const std::uintmax_t size = checkInput(file);
  HeaderWalk(file, size).check();
}

}  // namespace umbra
