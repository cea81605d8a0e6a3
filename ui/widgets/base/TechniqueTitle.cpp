#include "ui/widgets/base/TechniqueTitle.h"

#include "ui/widgets/base/Style.h"

namespace umbra {

QString shortTitle(const Technique& technique) {
  const QString title = style::text(technique.info().title);
  const int open = title.lastIndexOf('('), close = title.lastIndexOf(')');
  return open >= 0 && close > open ? title.mid(open + 1, close - open - 1) : title;
}

}  // namespace umbra
