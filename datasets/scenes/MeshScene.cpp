#include "datasets/scenes/MeshScene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "datasets/scenes/ModelStage.h"
#include "filters/core/support/Text.h"

namespace umbra {
namespace {

using meshfile::MeshPart;
using meshfile::RawMesh;

// More objects than these could neither be told apart nor drawn one by one in good time.
constexpr std::size_t mostParts = 64;

Material plainMaterial() {
  Material material;
  material.colour = {0.62, 0.66, 0.70};
  return material;
}

// The parts of the file that triangles belong to, less what is not to tell them apart.
std::set<MeshPart> partsUsed(const RawMesh& raw, bool byObject, bool byMaterial) {
  std::vector<bool> isUsed(raw.parts.size(), false);
  for (std::uint32_t part : raw.triangleParts) isUsed[part] = true;
  std::set<MeshPart> parts;
  for (std::size_t part = 0; part < raw.parts.size(); ++part)
    if (isUsed[part])
      parts.insert(
          {byObject ? raw.parts[part].object : "", byMaterial ? raw.parts[part].material : ""});
  return parts;
}

// Names of a file may be anything; names of objects are unique, on one line, and not the ground's.
class ObjectNames {
 public:
  std::string unique(std::string wanted) {
    for (char& c : wanted)
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    wanted = clipped(wanted);
    std::string name = wanted;
    for (int number = 2; !taken_.insert(name).second; ++number)
      name = wanted + " (" + std::to_string(number) + ")";
    return name;
  }

 private:
  std::set<std::string> taken_{"paving", "ground"};
};

class Parts {
 public:
  Parts(const RawMesh& raw, std::string fileName) : raw_(raw), fileName_(std::move(fileName)) {}

  std::vector<ModelPart> run(MeshReport& report) {
    chooseKeys(report);
    for (std::size_t t = 0; t < raw_.triangles.size(); ++t)
      parts_[placeOf(raw_.triangleParts[t])].triangles.push_back(raw_.triangles[t]);
    return std::move(parts_);
  }

 private:
  void chooseKeys(MeshReport& report) {
    const std::size_t all = partsUsed(raw_, true, true).size();
    if (all > mostParts) byMaterial_ = false;
    if (!byMaterial_ && partsUsed(raw_, true, false).size() > mostParts) byObject_ = false;
    used_ = partsUsed(raw_, byObject_, byMaterial_);
    if (used_.size() < all)
      report.notes.push_back(
          "its " + std::to_string(all) + " named parts became " +
          (byObject_ ? std::to_string(used_.size()) + " objects" : std::string("one object")) +
          ", since more than " + std::to_string(mostParts) + " could not be told apart");
    places_.assign(raw_.parts.size(), SIZE_MAX);
  }

  std::size_t placeOf(std::uint32_t part) {
    std::size_t& place = places_[part];
    if (place != SIZE_MAX) return place;
    const MeshPart& whole = raw_.parts[part];
    const MeshPart key{byObject_ ? whole.object : "", byMaterial_ ? whole.material : ""};
    const auto [found, isNew] = known_.try_emplace(key, parts_.size());
    if (isNew) {
      const auto material = raw_.materials.find(key.material);
      parts_.push_back({names_.unique(nameOf(key)),
                        material == raw_.materials.end() ? plainMaterial() : material->second,
                        {}});
    }
    return place = found->second;
  }

  // An object's own name, and that of the material where the object has several.
  std::string nameOf(const MeshPart& key) const {
    if (key.object.empty()) return key.material.empty() ? fileName_ : key.material;
    std::size_t materials = 0;
    for (const MeshPart& other : used_) materials += other.object == key.object;
    return materials < 2 || key.material.empty() ? key.object
                                                 : key.object + " (" + key.material + ")";
  }

  const RawMesh& raw_;
  const std::string fileName_;
  bool byObject_ = true, byMaterial_ = true;
  std::set<MeshPart> used_;
  std::vector<std::size_t> places_;  // of the file's parts among `parts_`
  std::map<MeshPart, std::size_t> known_;
  ObjectNames names_;
  std::vector<ModelPart> parts_;
};

// The ends of a list of coordinates without its outermost ones: a two-hundredth at either end, and
// at least three, which a single triangle has, but one of a few.
std::pair<double, double> endsWithin(std::vector<double> values) {
  const std::size_t cut = values.size() < 16 ? 1 : std::max<std::size_t>(3, values.size() / 200);
  const auto at = [&](std::size_t place) {
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(place), values.end());
    return values[place];
  };
  const double low = at(cut);
  return {low, at(values.size() - 1 - cut)};
}

// A file is scaled by its longest side: a few vertices far away make a dot of all others.
void noteStrays(RawMesh& raw) {
  constexpr double farAway = 1000.0;  // times the longest side of what the others span
  constexpr std::size_t fewest = 8;   // vertices that tell what is far
  std::vector<bool> isUsed(raw.positions.size(), false);
  for (const meshfile::Triangle& triangle : raw.triangles)
    for (std::uint32_t vertex : triangle) isUsed[vertex] = true;
  Eigen::AlignedBox3d within;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (std::size_t v = 0; v < isUsed.size(); ++v)
      if (isUsed[v]) values.push_back(raw.positions[v][axis]);
    if (values.size() < fewest) return;
    std::tie(within.min()[axis], within.max()[axis]) = endsWithin(std::move(values));
  }
  const double side = within.sizes().maxCoeff();
  if (!(side > 0.0)) return;
  std::size_t strays = 0;
  for (std::size_t v = 0; v < isUsed.size(); ++v)
    strays += isUsed[v] && within.exteriorDistance(raw.positions[v]) > farAway * side;
  if (strays > 0)
    raw.report.notes.push_back(std::to_string(strays) +
                               (strays == 1 ? " vertex lies" : " vertices lie") +
                               " more than a thousand times as far out as all others are wide, "
                               "which makes a dot of these");
}

}  // namespace

Scene sceneFromMeshFile(const std::filesystem::path& file, UpAxis up, MeshReport* report,
                        const Progress& progress) {
  RawMesh raw = meshfile::readRawMesh(file, progress.stage(0.0, 0.8));
  noteStrays(raw);
  const std::vector<ModelPart> parts = Parts(raw, file.stem().string()).run(raw.report);
  Scene scene = stagedScene(raw, parts, {.zIsUp = up == UpAxis::Z}, progress.stage(0.8, 1.0));
  scene.name = file.stem().string();
  scene.title = file.filename().string();
  scene.description = "A mesh file on a ground plane, scaled to about four units.";
  if (report) *report = raw.report;
  return scene;
}

}  // namespace umbra
