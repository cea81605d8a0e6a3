#include "ui/FrameFigures.h"

#include <QObject>
#include <QStringList>

#include "ui/widgets/Style.h"

namespace umbra {
namespace {

int bytesOf(StorageFormat format) {
  switch (format) {
    case StorageFormat::Unorm8:
      return 1;
    case StorageFormat::Unorm16:
    case StorageFormat::Half:
      return 2;
    case StorageFormat::Float:
      return 4;
    case StorageFormat::Double:
      return 8;
  }
  return 4;
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
  const double texels = double(settings.map.size) * settings.map.size;
  // A 32-bit depth; channels encoded, and once more where they are prefiltered.
  const int copies = technique.info().prefilterable ? 2 : 1;
  const double bytes = texels * (4.0 + double(copies * channels * bytesOf(settings.map.format)));
  // Joined and not by arg(): to Qt, the ² would be a digit of the place marker before it.
  return QObject::tr("map ") + QString::number(settings.map.size) + QStringLiteral("² · ") +
         style::text(nameOf(settings.map.format)) + QStringLiteral(" · ") +
         (channels == 1 ? QObject::tr("1 channel") : QObject::tr("%1 channels").arg(channels)) +
         QStringLiteral(" · ") + QString::number(bytes / 1048576.0, 'f', 0) + " MiB";
}

}  // namespace umbra
