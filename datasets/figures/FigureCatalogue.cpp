#include "datasets/figures/FigureCatalogue.h"

#include <algorithm>
#include <cstring>

#include "datasets/figures/FigureFile.h"
#include "datasets/json/EmbeddedFiles.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/Text.h"

namespace umbra {

std::vector<Figure> figureCatalogue() {
  std::vector<Figure> figures;
  for (const EmbeddedFile& file : embeddedFigures())
    figures.push_back(figureFromText(file.text, file.name, {}));
  std::sort(figures.begin(), figures.end(), [](const Figure& a, const Figure& b) {
    return strverscmp(a.name.c_str(), b.name.c_str()) < 0;
  });
  return figures;
}

Figure figureNamed(const std::string& name) {
  if (name.ends_with(".json")) return readFigure(name);
  std::vector<std::string> names;
  for (Figure& figure : figureCatalogue()) {
    if (figure.name == name) return std::move(figure);
    names.push_back(figure.name);
  }
  const std::string nearest = nearestWord(name, names);
  throw Error(ErrorKind::BadCommandLine,
              "there is no figure '" + clipped(name) + "'" +
                  (nearest.empty() ? "; there are " + joined(names) + ", or a file.json"
                                   : "; did you mean '" + nearest + "'?"));
}

}  // namespace umbra
