#include "app/display/PictureFile.h"

#include <QBuffer>
#include <QByteArray>
#include <QFont>
#include <QImage>
#include <QPainter>
#include <algorithm>

#include "filters/core/support/AtomicFile.h"
#include "filters/core/support/Error.h"

namespace umbra {
namespace {

constexpr int gap = 12;          // pixels between pictures
constexpr int labelHeight = 40;  // pixels above a picture
constexpr int fontHeight = 22;   // pixels
constexpr int mostInARow = 4;

// The image shares the picture's memory.
QImage wrapped(const Image<std::uint8_t>& picture) {
  return QImage(picture.values().data(), picture.width(), picture.height(), picture.width() * 3,
                QImage::Format_RGB888);
}

QImage sheetOf(const std::vector<LabelledPicture>& pictures) {
  const int count = int(pictures.size());
  const int columns = std::min(count, mostInARow), rows = (count + columns - 1) / columns;
  const int width = pictures.front().colour.width(), height = pictures.front().colour.height();
  QImage sheet(gap + columns * (width + gap), rows * (labelHeight + height) + gap,
               QImage::Format_RGB888);
  if (sheet.isNull())
    throw Error(ErrorKind::WorkFailed, "the pictures side by side do not fit into memory");
  sheet.fill(Qt::white);
  QPainter painter(&sheet);
  painter.setRenderHint(QPainter::TextAntialiasing);
  QFont font("Sans");
  font.setPixelSize(fontHeight);
  painter.setFont(font);
  painter.setPen(QColor("#1f2933"));
  for (int i = 0; i < count; ++i) {
    const int x = gap + i % columns * (width + gap);
    const int y = i / columns * (labelHeight + height);
    painter.drawText(QRect(x, y, width, labelHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     QString::fromStdString(pictures[i].label));
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

void writePng(const std::vector<LabelledPicture>& pictures, const std::filesystem::path& file) {
  const QImage image = pictures.size() == 1 ? wrapped(pictures.front().colour) : sheetOf(pictures);
  // The file is written to memory first: an image writer on a full disk reports success.
  writeTextAtomically(file, encoded(image));
}

std::string pngOf(const Image<std::uint8_t>& picture) {
  return encoded(wrapped(picture));
}

}  // namespace umbra
