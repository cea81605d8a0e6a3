#include "ui/picture/FrameFigures.h"

#include <QObject>
#include <QStringList>

#include "filters/gpu/ChannelBaker.h"
#include "ui/widgets/base/Style.h"

namespace umbra {
QString passTimesText(const std::vector<PassTime>& times) {
  QStringList parts;
  for (const PassTime& time : times)
    parts << QString("%1 %2").arg(QString::fromStdString(time.pass),
                                  QString::number(time.milliseconds, 'f', 1));
  return parts.isEmpty() ? QString() : parts.join(QStringLiteral(" · ")) + QObject::tr(" ms");
}

QString mapText(const FrameSettings& settings, const Technique& technique) {
  const int channels = int(technique.channels().size());
  const double mebibytes = double(textureBytes(settings, technique)) / 1048576.0;
  // Joined and not by arg(): to Qt, the ² would be a digit of the place marker before it.
  return QObject::tr("map ") + QString::number(settings.map.size) + QStringLiteral("² · ") +
         style::text(nameOf(settings.map.format)) + QStringLiteral(" · ") +
         (channels == 1 ? QObject::tr("1 channel") : QObject::tr("%1 channels").arg(channels)) +
         QStringLiteral(" · ") + QString::number(mebibytes, 'f', 0) +
         QObject::tr(" MiB of textures");
}

}  // namespace umbra
