// Depths in OpenEXR files: half, float or whole numbers, tiles or scan lines, and several parts,
// whose channels are named "part.channel". Deep files are refused.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "datasets/maps/ExrAttributes.h"
#include "datasets/maps/Raster.h"
#include "filters/core/maps/Image.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

// A channel of one part of the file. Viewers show `title`: "part.channel" where the file has
// several parts.
struct ChannelPlace {
  int part = 0;
  std::string name, title;
};

std::vector<ChannelPlace> channelsOf(const fs::path& file, const Imf::MultiPartInputFile& input) {
  std::vector<ChannelPlace> places;
  for (int part = 0; part < input.parts(); ++part) {
    const Imf::Header& header = input.header(part);
    if (header.hasType() && Imf::isDeepData(header.type()))
      refuseRaster(file, "is a deep file; a depth map has one value per pixel");
    const std::string prefix =
        input.parts() > 1 && header.hasName() ? header.name() + "." : std::string();
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
      places.push_back({part, c.name(), prefix + c.name()});
  }
  return places;
}

// Only the DCT compressions store more than deflate does; a pixel takes at least two bytes.
void checkSize(const fs::path& file, const Imf::Header& header, std::int64_t width,
               std::int64_t height) {
  const Imf::Compression compression = header.compression();
  if (compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION) return;
  checkRasterSize(file, width, height, 16);
}

void checkChannel(const fs::path& file, const ChannelPlace& place, const Imf::Channel& channel) {
  if (channel.xSampling != 1 || channel.ySampling != 1)
    refuseRaster(file, "channel '" + clipped(place.title) +
                           "' is subsampled; a depth has one value per pixel");
}

RasterNumber numberOf(Imf::PixelType type) {
  if (type == Imf::UINT) return RasterNumber::Whole;
  return type == Imf::HALF ? RasterNumber::Half : RasterNumber::Float;
}

// The rows of one channel, some at a time.
template <class Value>
void readRows(Imf::MultiPartInputFile& input, const ChannelPlace& place, Imf::PixelType type,
              const Imath::Box2i& window, const RasterSink& sink) {
  constexpr int rows = 256;
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  Image<Value> values(width, std::min(rows, height));
  std::vector<double> row(std::size_t(width), 0.0);
  Imf::InputPart part(input, place.part);
  for (int first = 0; first < height; first += rows) {
    const int last = std::min(first + rows, height) - 1;
    // OpenEXR addresses pixels from the data window's origin, wherever it lies.
    const Imath::Box2i block({window.min.x, window.min.y + first},
                             {window.max.x, window.min.y + last});
    Imf::FrameBuffer frame;
    frame.insert(place.name, Imf::Slice::Make(type, values.values().data(), block));
    part.setFrameBuffer(frame);
    part.readPixels(block.min.y, block.max.y);
    for (int y = first; y <= last; ++y) {
      for (int x = 0; x < width; ++x) row[std::size_t(x)] = double(values(x, y - first));
      sink.row(y, row);
    }
  }
}

void readPlace(const fs::path& file, Imf::MultiPartInputFile& input, const ChannelPlace& place,
               const RasterSink& sink) {
  const Imf::Header& header = input.header(place.part);
  const Imf::Channel& channel = header.channels()[place.name.c_str()];
  checkChannel(file, place, channel);
  const Imath::Box2i window = header.dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  checkSize(file, header, width, height);
  sink.begin({width, height, window.min.x, window.min.y, numberOf(channel.type)});
  if (channel.type == Imf::UINT)
    readRows<std::uint32_t>(input, place, Imf::UINT, window, sink);
  else
    readRows<float>(input, place, Imf::FLOAT, window, sink);
}

// "Z (0.5 to 8)": the range of a channel's finite values tells what it may hold.
std::string withRange(const fs::path& file, Imf::MultiPartInputFile& input,
                      const ChannelPlace& place) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  try {
    readPlace(file, input, place,
              {[](const RasterInfo&) {},
               [&](int, std::span<const double> row) {
                 for (double value : row)
                   if (std::isfinite(value))
                     low = std::min(low, value), high = std::max(high, value);
               }});
  } catch (const std::exception&) {
    return clipped(place.title);  // which is no depth
  }
  return clipped(place.title) +
         (low <= high ? " (" + toText(low) + " to " + toText(high) + ")" : "");
}

// OpenEXR checks this limit before it allocates anything. The limit is a setting of the whole
// process, and files are read on several threads.
void limitImageSize() {
  static const bool limited = [] {
    Imf::Header::setMaxImageSize(largestRasterSide, largestRasterSide);
    return true;
  }();
  (void)limited;
}

ChannelPlace channelToRead(const fs::path& file, Imf::MultiPartInputFile& input,
                           const std::string& wanted) {
  const std::vector<ChannelPlace> places = channelsOf(file, input);
  if (wanted.empty() && places.size() == 1) return places.front();
  const std::string name = wanted.empty() ? "Z" : wanted;
  for (const ChannelPlace& place : places)
    if (place.title == name) return place;
  for (const ChannelPlace& place : places)
    if (place.name == name) return place;
  constexpr std::size_t most = 20;  // channels that a message names
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < std::min(places.size(), most); ++i)
    titles.push_back(withRange(file, input, places[i]));
  if (places.size() > most) titles.push_back(std::to_string(places.size() - most) + " more");
  refuseRaster(file, "there is no channel '" + clipped(name) + "'; there are " + joined(titles) +
                         std::string(wanted.empty() ? channelHint : ""));
}

// Opens the file for `work`; what OpenEXR says of a damaged one becomes one line.
template <class Work>
void withExr(const fs::path& file, const Work& work) {
  checkExrAttributes(file);
  try {
    limitImageSize();
    Imf::MultiPartInputFile input(file.c_str());
    work(input);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    refuseRaster(file, "cannot be read as OpenEXR: " + oneLine(error.what()));
  }
}

}  // namespace

void readExr(const fs::path& file, const std::string& channel, const RasterSink& sink) {
  withExr(file, [&](Imf::MultiPartInputFile& input) {
    readPlace(file, input, channelToRead(file, input, channel), sink);
  });
}

std::vector<std::string> exrChannels(const fs::path& file) {
  std::vector<std::string> titles;
  withExr(file, [&](Imf::MultiPartInputFile& input) {
    for (const ChannelPlace& place : channelsOf(file, input)) titles.push_back(place.title);
  });
  return titles;
}

}  // namespace umbra
