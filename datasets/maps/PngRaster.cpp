// Depths in grey PNG pictures of 8 or 16 bits. A value is a fraction of the largest whole number,
// as a window depth is; what the file says of gamma is about light, which a depth is not.
#include <png.h>

#include <csetjmp>
#include <cstring>

#include "datasets/maps/Raster.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

namespace fs = std::filesystem;

// A picture that is read through libpng. A call of libpng that fails ends by a jump, which would
// leave out destructors: all are made in `guarded`, by work that owns nothing.
class PngPicture {
 public:
  PngPicture(const fs::path& file, std::string_view content) : file_(file), rest_(content) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngPicture::fail,
                                  [](png_structp, png_const_charp) {});
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (info_) return;
    png_destroy_read_struct(&png_, nullptr, nullptr);
    refuseRaster(file_, "cannot be read as PNG: there is no memory for it");
  }
  ~PngPicture() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngPicture(const PngPicture&) = delete;
  PngPicture& operator=(const PngPicture&) = delete;

  void readHeader() {
    guarded([this] {
      png_set_read_fn(png_, this, &PngPicture::give);
      // A longer chunk of text or colours than this has nothing to do with depths.
      png_set_chunk_malloc_max(png_, 1u << 20);
      png_set_user_limits(png_, largestRasterSide, largestRasterSide);
      png_read_info(png_, info_);
    });
  }
  int width() const { return int(png_get_image_width(png_, info_)); }
  int height() const { return int(png_get_image_height(png_, info_)); }
  int bits() const { return png_get_bit_depth(png_, info_); }
  bool isGrey() const { return png_get_color_type(png_, info_) == PNG_COLOR_TYPE_GRAY; }
  bool isInterlaced() const { return png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE; }
  void begin() {
    guarded([this] {
      if (bits() < 8) png_set_expand_gray_1_2_4_to_8(png_);
      png_set_interlace_handling(png_);
      png_read_update_info(png_, info_);
    });
  }
  // Big-endian values; of an interlaced picture the row as it was, to be completed.
  void readRow(std::vector<unsigned char>& row) {
    unsigned char* bytes = row.data();
    guarded([this, bytes] { png_read_row(png_, bytes, nullptr); });
  }
  // What follows the values is read, too, so that a picture that was cut off is told.
  void end() {
    guarded([this] { png_read_end(png_, nullptr); });
  }

 private:
  template <class Work>
  void guarded(const Work& work) {
    if (setjmp(png_jmpbuf(png_)) != 0)
      refuseRaster(file_, "cannot be read as PNG: " + clipped(oneLine(problem_)));
    work();
  }
  static void fail(png_structp png, png_const_charp what) {
    auto* picture = static_cast<PngPicture*>(png_get_error_ptr(png));
    std::strncpy(picture->problem_, what, sizeof picture->problem_ - 1);
    png_longjmp(png, 1);
  }
  static void give(png_structp png, png_bytep bytes, std::size_t count) {
    auto* picture = static_cast<PngPicture*>(png_get_io_ptr(png));
    if (count > picture->rest_.size()) png_error(png, "it is truncated");
    std::memcpy(bytes, picture->rest_.data(), count);
    picture->rest_.remove_prefix(count);
  }

  const fs::path& file_;
  std::string_view rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  char problem_[80] = {};
};

}  // namespace

void readPng(const fs::path& file, const std::string& channel, const RasterSink& sink) {
  if (!channel.empty()) refuseRaster(file, "a grey picture has no named channels");
  const std::string content = contentOf(file, std::uintmax_t(5) << 30);
  PngPicture picture(file, content);
  picture.readHeader();
  if (!picture.isGrey())
    refuseRaster(file, "is a colour picture, or has transparency; a depth map has one grey value");
  const int width = picture.width(), height = picture.height();
  checkRasterSize(file, width, height, picture.bits());
  const bool isWide = picture.bits() == 16;
  picture.begin();
  sink.begin({width, height, 0, 0, isWide ? RasterNumber::Fraction16 : RasterNumber::Fraction8});
  const std::size_t bytes = std::size_t(width) * (isWide ? 2 : 1);
  std::vector<double> row(std::size_t(width), 0.0);
  const auto give = [&](int y, const std::vector<unsigned char>& stored) {
    for (std::size_t x = 0; x < row.size(); ++x)
      row[x] = isWide ? (stored[2 * x] * 256 + stored[2 * x + 1]) / 65535.0 : stored[x] / 255.0;
    sink.row(y, row);
  };
  // An interlaced picture comes seven times, each time with more of its pixels.
  constexpr int interlacedPasses = 7;
  std::vector<std::vector<unsigned char>> stored(picture.isInterlaced() ? std::size_t(height) : 1,
                                                 std::vector<unsigned char>(bytes));
  for (int pass = 1; picture.isInterlaced() && pass < interlacedPasses; ++pass)
    for (auto& one : stored) picture.readRow(one);
  for (int y = 0; y < height; ++y) {
    auto& one = stored[picture.isInterlaced() ? std::size_t(y) : 0];
    picture.readRow(one);
    give(y, one);
  }
  picture.end();
}

}  // namespace umbra
