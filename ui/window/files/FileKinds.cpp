#include "ui/window/files/FileKinds.h"

#include <QObject>

#include "datasets/maps/Raster.h"
#include "datasets/meshes/MeshFileReader.h"

namespace umbra {
namespace {

// From ".obj .ply".
QString patternsOf(const std::string& extensions) {
  return "*" + QString::fromStdString(extensions).replace(" ", " *");
}

}  // namespace

QString meshPatterns() {
  return patternsOf(meshfile::meshExtensions());
}

QString depthPatterns() {
  return patternsOf(rasterExtensions());
}

QString meshFilter() {
  return QObject::tr("Meshes (%1)").arg(meshPatterns());
}

QString depthFilter() {
  return QObject::tr("Depth maps (%1)").arg(depthPatterns());
}

QString everyFilter() {
  return QObject::tr("All that can be opened (%1 %2 *.json);;%3;;%4;;Sessions and lessons (*.json)")
      .arg(meshPatterns(), depthPatterns(), meshFilter(), depthFilter());
}

}  // namespace umbra
