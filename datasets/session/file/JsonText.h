// JSON as people write it, read strictly.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace umbra {

// `where` is what errors begin with: a file. Throws BadInput for what is no JSON, with the byte;
// for a number that no double holds; for a key that one object has twice, of which only one could
// be meant.
nlohmann::ordered_json jsonFromText(std::string_view text, std::string_view where);

// The whole content. Throws BadInput where there is none to be read.
std::string textOf(const std::filesystem::path& file);

}  // namespace umbra
