#include "app/display/PictureFile.h"

#include <QBuffer>
#include <QByteArray>
#include <QFont>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

constexpr int gap = 12;                     // pixels between pictures
constexpr double screenShape = 16.0 / 9.0;  // which a sheet comes near

// The image shares the picture's memory.
QImage wrapped(const Image<std::uint8_t>& picture) {
  return QImage(picture.values().data(), picture.width(), picture.height(), picture.width() * 3,
                QImage::Format_RGB888);
}

// Pictures of one size in rows and columns, each under its label.
struct SheetLayout {
  int columns, width, height, labelHeight;

  int rowsOf(int count) const { return (count + columns - 1) / columns; }
  QSize sizeOf(int count) const {
    return {gap + columns * (width + gap), rowsOf(count) * (labelHeight + height) + gap};
  }
};

// The number of columns with which the sheet comes nearest to a screen's shape.
SheetLayout layoutOf(int count, int width, int height) {
  SheetLayout best{};
  double least = std::numeric_limits<double>::infinity();
  for (int columns = count; columns >= 1; --columns) {
    const SheetLayout layout{columns, width, height, std::max(height / 18, 20)};
    const QSize size = layout.sizeOf(count);
    const double off = std::abs(std::log(size.width() / (screenShape * size.height())));
    if (off < least) least = off, best = layout;
  }
  return best;
}

QImage sheetOf(const std::vector<LabelledPicture>& pictures) {
  const int count = int(pictures.size());
  const SheetLayout layout =
      layoutOf(count, pictures.front().colour.width(), pictures.front().colour.height());
  const auto [columns, width, height, labelHeight] = layout;
  QImage sheet(layout.sizeOf(count), QImage::Format_RGB888);
  if (sheet.isNull())
    throw Error(ErrorKind::WorkFailed, "the pictures side by side do not fit into memory");
  sheet.fill(Qt::white);
  QPainter painter(&sheet);
  painter.setRenderHint(QPainter::TextAntialiasing);
  QFont font("Sans");
  font.setPixelSize(labelHeight * 11 / 20);
  painter.setFont(font);
  painter.setPen(QColor("#1f2933"));
  for (int i = 0; i < count; ++i) {
    const int x = gap + i % columns * (width + gap);
    const int y = i / columns * (labelHeight + height);
    painter.drawText(QRect(x, y, width, labelHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(QString::fromStdString(pictures[i].label),
                                                      Qt::ElideRight, width));
    painter.drawImage(x, y + labelHeight, wrapped(pictures[i].colour));
  }
  return sheet;
}

std::string encoded(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (!image.save(&buffer, "PNG"))
    throw Error(ErrorKind::WorkFailed, "a picture cannot be encoded as PNG");
  return bytes.toStdString();
}

}  // namespace

void writePng(const std::vector<LabelledPicture>& pictures, const std::filesystem::path& file,
              const PictureTexts& texts) {
  QImage image = pictures.size() == 1 ? wrapped(pictures.front().colour) : sheetOf(pictures);
  for (const auto& [name, text] : texts)
    image.setText(QString::fromStdString(name), QString::fromStdString(text));
  // The file is written to memory first: an image writer on a full disk reports success.
  writeTextAtomically(file, encoded(image));
}

std::string pngOf(const Image<std::uint8_t>& picture) {
  return encoded(wrapped(picture));
}

}  // namespace umbra
