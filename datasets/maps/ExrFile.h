// Channels written into OpenEXR files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "filters/core/maps/Image.h"

namespace umbra {

enum class ExrPixel { Half, Float };

// One image per channel name, all of one size and with one channel. `attributes` become string
// attributes.
struct ExrPart {
  std::string name;  // of a file with several parts; viewers show "name.channel"
  std::map<std::string, Image<float>> channels;
  std::map<std::string, std::string> attributes;
};

// The first texel's coordinates, as viewers of EXR files count.
struct ExrOrigin {
  int x = 0, y = 0;
};

// Both write scan lines, ZIP-compressed. They throw BadOutput; nothing half-written remains.
void writeExr(const std::filesystem::path& file,
              const std::map<std::string, Image<float>>& channels,
              const std::map<std::string, std::string>& attributes,
              ExrPixel pixel = ExrPixel::Float, const ExrOrigin& origin = {});
// Several parts, each with a name of its own.
void writeExr(const std::filesystem::path& file, const std::vector<ExrPart>& parts,
              ExrPixel pixel = ExrPixel::Float);

}  // namespace umbra
