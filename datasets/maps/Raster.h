// A file of numbers in rows, whatever its format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace umbra {

// What a file's numbers are stored as. A fraction is a whole number over the largest one of its
// bits, as pictures store what lies in [0, 1].
enum class RasterNumber { Half, Float, Double, Whole, Fraction8, Fraction16 };

// "half", "float", "double", "whole numbers", "fractions of 255" or "fractions of 65535".
std::string_view nameOf(RasterNumber number);
// A value as that number can hold it.
double rounded(double value, RasterNumber number);
// The fewest digits that stand for this value and no other that the number can hold: 0.7, 1e+10.
std::string shortest(double value, RasterNumber number);

struct RasterInfo {
  int width = 0, height = 0;
  int originX = 0, originY = 0;  // the first texel's coordinates in the file's own count
  RasterNumber number = RasterNumber::Float;
  std::string note;  // what a doubtful reading did; empty for none
};

// Takes a raster as it is read, so that nothing needs a second copy of it: `begin` once, then each
// row from the top down.
struct RasterSink {
  std::function<void(const RasterInfo& info)> begin;
  std::function<void(int y, std::span<const double> row)> row;
};

// A shadow map of this size a side takes 2 GB in double; a header that promises more is damaged.
inline constexpr int largestRasterSide = 16384;

// Refuses a size that no file of this length can hold, before memory is allocated for it: deflate
// stores at most 1032 bytes in one, and a value takes `bits`.
void checkRasterSize(const std::filesystem::path& file, std::int64_t width, std::int64_t height,
                     int bits);

// How a refusal ends where no channel was named: what the command line offers against it.
inline constexpr std::string_view channelHint = ": name one as FILE.exr:CHANNEL";

// Throws BadInput that begins with the file's name.
[[noreturn]] void refuseRaster(const std::filesystem::path& file, const std::string& what);

// The readers. `channel` is "" for the one that is meant where none is named. All throw BadInput
// that begins with the file's name.
void readExr(const std::filesystem::path& file, const std::string& channel, const RasterSink& sink);
void readPfm(const std::filesystem::path& file, const std::string& channel, const RasterSink& sink);
void readNpy(const std::filesystem::path& file, const std::string& channel, const RasterSink& sink);
void readPng(const std::filesystem::path& file, const std::string& channel, const RasterSink& sink);
void readTiff(const std::filesystem::path& file, const std::string& channel,
              const RasterSink& sink);
// The names that `channel` may have, in the file's order.
std::vector<std::string> exrChannels(const std::filesystem::path& file);

// The reader that a file's name asks for; null where there is none.
using RasterReader = void (*)(const std::filesystem::path&, const std::string&, const RasterSink&);
RasterReader rasterReaderOf(const std::filesystem::path& file);
// What `channel` may name in a file of any of the formats; none where they name no channels.
std::vector<std::string> rasterChannels(const std::filesystem::path& file);
// ".exr .pfm .npy .png .tif .tiff"
std::string rasterExtensions();

}  // namespace umbra
