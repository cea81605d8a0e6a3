#include "datasets/maps/ExrFile.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>

#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

using Channels = std::map<std::string, Image<float>>;
using Attributes = std::map<std::string, std::string>;

// The header of one part and where the library finds its pixels. The images must outlive it.
class Part {
 public:
  Part(const fs::path& file, const Channels& channels, const Attributes& attributes, ExrPixel pixel,
       const ExrOrigin& origin = {}) {
    if (channels.empty()) throw Error(ErrorKind::BadOutput, file.string() + ": has no channel");
    const Image<float>& first = channels.begin()->second;
    const Imath::Box2i window({origin.x, origin.y},
                              {origin.x + first.width() - 1, origin.y + first.height() - 1});
    header_ = Imf::Header(window, window);
    header_.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, text] : attributes) header_.insert(name, Imf::StringAttribute(text));
    halves_.reserve(channels.size());
    for (const auto& [name, image] : channels) {
      if (image.width() != first.width() || image.height() != first.height() ||
          image.channels() != 1)
        throw Error(ErrorKind::BadOutput,
                    file.string() + ": channel '" + name + "' differs in size from the others");
      add(name, image, pixel);
    }
  }

  Imf::Header& header() { return header_; }
  const Imf::FrameBuffer& pixels() const { return pixels_; }
  int height() const { return header_.dataWindow().size().y + 1; }

 private:
  void add(const std::string& name, const Image<float>& image, ExrPixel pixel) {
    const Imf::PixelType type = pixel == ExrPixel::Half ? Imf::HALF : Imf::FLOAT;
    header_.channels().insert(name, Imf::Channel(type));
    const void* data = image.values().data();
    if (pixel == ExrPixel::Half) {
      Image<half>& rounded = halves_.emplace_back(image.width(), image.height());
      std::copy(image.values().begin(), image.values().end(), rounded.values().begin());
      data = rounded.values().data();
    }
    // The library only reads through the pointer when it writes a file.
    pixels_.insert(name, Imf::Slice::Make(type, const_cast<void*>(data), header_.dataWindow()));
  }

  Imf::Header header_;
  Imf::FrameBuffer pixels_;
  std::vector<Image<half>> halves_;  // what `pixels_` points into
};

}  // namespace

void writeExr(const fs::path& file, const Channels& channels, const Attributes& attributes,
              ExrPixel pixel, const ExrOrigin& origin) {
  Part part(file, channels, attributes, pixel, origin);
  writeAtomically(file, [&](const fs::path& temporary) {
    Imf::OutputFile output(temporary.c_str(), part.header());
    output.setFrameBuffer(part.pixels());
    output.writePixels(part.height());
  });
}

void writeExr(const fs::path& file, const std::vector<ExrPart>& parts, ExrPixel pixel) {
  if (parts.empty()) throw Error(ErrorKind::BadOutput, file.string() + ": has no part");
  std::vector<Part> written;
  std::vector<Imf::Header> headers;
  written.reserve(parts.size());
  for (const ExrPart& part : parts) {
    Part& next = written.emplace_back(file, part.channels, part.attributes, pixel);
    next.header().setName(part.name);
    next.header().setType(Imf::SCANLINEIMAGE);
    headers.push_back(next.header());
  }
  writeAtomically(file, [&](const fs::path& temporary) {
    Imf::MultiPartOutputFile output(temporary.c_str(), headers.data(), int(headers.size()));
    for (std::size_t i = 0; i < written.size(); ++i) {
      Imf::OutputPart part(output, int(i));
      part.setFrameBuffer(written[i].pixels());
      part.writePixels(written[i].height());
    }
  });
}

}  // namespace umbra
