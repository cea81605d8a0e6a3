#include "datasets/maps/DepthFile.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfVersion.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "datasets/maps/ExrAttributes.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Parameters.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

// A shadow map of this size a side takes 2 GB in double; a header that promises more is damaged.
constexpr int largestSide = 16384;

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw Error(ErrorKind::BadInput, file.string() + ": " + what);
}

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
      refuse(file, "is a deep file; a depth map has one value per pixel");
    const std::string prefix =
        input.parts() > 1 && header.hasName() ? header.name() + "." : std::string();
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
      places.push_back({part, c.name(), prefix + c.name()});
  }
  return places;
}

ChannelPlace channelToRead(const fs::path& file, const std::vector<ChannelPlace>& places,
                           const std::string& wanted) {
  if (wanted.empty() && places.size() == 1) return places.front();
  const std::string name = wanted.empty() ? "Z" : wanted;
  for (const ChannelPlace& place : places)
    if (place.title == name) return place;
  for (const ChannelPlace& place : places)
    if (place.name == name) return place;
  std::vector<std::string> titles;
  for (const ChannelPlace& place : places) titles.push_back(place.title);
  refuse(file, "there is no channel '" + name + "'; there are " + joined(titles) +
                   (wanted.empty() ? ": name one as FILE.exr:CHANNEL" : ""));
}

// Refuses a size that no file of this length can hold, before memory is allocated for it. Only the
// DCT compressions store more than deflate's 1032 bytes in one byte; a pixel takes at least two
// bytes.
void checkSize(const fs::path& file, const Imf::Header& header, std::int64_t width,
               std::int64_t height) {
  const Imf::Compression compression = header.compression();
  if (compression == Imf::DWAA_COMPRESSION || compression == Imf::DWAB_COMPRESSION) return;
  const auto bytes = std::int64_t(fs::file_size(file));
  if (2 * width * height > 1100 * bytes)
    refuse(file, "promises " + std::to_string(width) + " × " + std::to_string(height) +
                     " pixels, which its " + std::to_string(bytes) + " bytes cannot hold");
}

// The values that become 0 and 1.
struct Range {
  double near, far;

  std::string text() const { return "from " + toText(near) + " to " + toText(far); }
};

// The fewest digits that stand for this value and no other: 1.0000001 is not 1.
std::string exactly(float value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

void checkChannel(const fs::path& file, const ChannelPlace& place, const Imf::Channel& channel) {
  if (channel.type == Imf::UINT)
    refuse(file, "channel '" + place.title + "' holds whole numbers; a depth is half or float");
  if (channel.xSampling != 1 || channel.ySampling != 1)
    refuse(file, "channel '" + place.title + "' is subsampled; a depth has one value per pixel");
}

// Some rows at a time, so that no second copy of the map is needed.
DepthMap readChannel(const fs::path& file, const std::string& wanted, const Range& range) {
  constexpr int rows = 256;
  Imf::MultiPartInputFile input(file.c_str());
  const ChannelPlace place = channelToRead(file, channelsOf(file, input), wanted);
  const Imf::Header& header = input.header(place.part);
  checkChannel(file, place, header.channels()[place.name.c_str()]);
  const Imath::Box2i window = header.dataWindow();
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  checkSize(file, header, width, height);
  DepthMap map(width, height);
  Image<float> values(width, std::min(rows, height));
  Imf::InputPart part(input, place.part);
  for (int first = 0; first < height; first += rows) {
    const int last = std::min(first + rows, height) - 1;
    // OpenEXR addresses pixels from the data window's origin, wherever it lies.
    const Imath::Box2i block({window.min.x, window.min.y + first},
                             {window.max.x, window.min.y + last});
    Imf::FrameBuffer frame;
    frame.insert(place.name, Imf::Slice::Make(Imf::FLOAT, values.values().data(), block));
    part.setFrameBuffer(frame);
    part.readPixels(block.min.y, block.max.y);
    for (int y = first; y <= last; ++y)
      for (int x = 0; x < width; ++x) {
        const float value = values(x, y - first);
        const double z = (value - range.near) / (range.far - range.near);
        if (!(z >= 0.0 && z <= 1.0))
          refuse(file, "texel " + std::to_string(x) + "," + std::to_string(y) + " is " +
                           exactly(value) + "; depths are finite numbers " + range.text());
        map(x, y) = z;
      }
  }
  return map;
}

// OpenEXR checks this limit before it allocates anything. The limit is a setting of the whole
// process, and files are read on several threads.
void limitImageSize() {
  static const bool limited = [] {
    Imf::Header::setMaxImageSize(largestSide, largestSide);
    return true;
  }();
  (void)limited;
}

}  // namespace

DepthMap readDepthFile(const fs::path& file, const std::string& channel, double near, double far) {
  if (!std::isfinite(near) || !std::isfinite(far) || near == far)
    refuse(file,
           "the depth range " + Range{near, far}.text() + " is empty; near and far must differ");
  if (!std::isfinite(far - near))
    refuse(file, "the depth range " + Range{near, far}.text() + " is too wide to divide by");
  checkExrAttributes(file);
  DepthMap map;
  try {
    limitImageSize();
    map = readChannel(file, channel, Range{near, far});
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    std::string what = error.what();
    std::replace(what.begin(), what.end(), '\n', ' ');
    refuse(file, "cannot be read as OpenEXR: " + what);
  }
  return map;
}

std::pair<fs::path, std::string> splitDepthArgument(const std::string& argument) {
  const std::size_t colon = argument.rfind(':');
  if (colon == std::string::npos || colon < 4) return {argument, ""};
  std::string extension = argument.substr(colon - 4, 4);
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".exr") return {argument, ""};
  return {argument.substr(0, colon), argument.substr(colon + 1)};
}

}  // namespace umbra
