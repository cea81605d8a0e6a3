#include "ui/picture/FrameFigures.h"

#include <QObject>
#include <QStringList>
#include <cmath>

#include "analysis/cost/TechniqueCost.h"
#include "filters/gpu/ChannelBaker.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
namespace {

// One decimal where there are fewer than ten.
QString mebibytes(double bytes) {
  const double count = bytes / 1048576.0;
  return QString::number(count, 'f', count < 9.95 && count != std::floor(count) ? 1 : 0);
}

}  // namespace

QString passTimesText(const std::vector<PassTime>& times) {
  QStringList parts;
  for (const PassTime& time : times)
    parts << QString("%1 %2").arg(QString::fromStdString(time.pass),
                                  QString::number(time.milliseconds, 'f', 1));
  return parts.isEmpty() ? QString() : parts.join(QStringLiteral(" · ")) + QObject::tr(" ms");
}

QString mapText(const FrameSettings& settings, const Technique& technique) {
  const int channels = int(technique.channels().size());
  const double texels = double(settings.map.size) * settings.map.size * settings.map.cascades.count;
  const double stored = texels * bytesStoredPerTexel(technique, settings.map.format);
  // Joined and not by arg(): to Qt, the ² would be a digit of the place marker before it.
  return QObject::tr("map ") + QString::number(settings.map.size) + QStringLiteral("² · ") +
         style::text(nameOf(settings.map.format)) + QStringLiteral(" · ") +
         (channels == 1 ? QObject::tr("1 channel") : QObject::tr("%1 channels").arg(channels)) +
         QStringLiteral(" · ") +
         QObject::tr("%1 MiB stored, %2 used")
             .arg(mebibytes(stored), mebibytes(double(textureBytes(settings, technique))));
}

QString mapToolTip() {
  return QObject::tr(
      "Stored: the channels of the method, which is what the papers count.\n"
      "Used: all textures of the program; also the depths, and where the kernel, mip levels or a "
      "summed-area table need them, further copies of the channels.");
}

}  // namespace umbra
