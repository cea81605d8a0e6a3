#include "datasets/meshes/GltfFile.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "datasets/json/JsonText.h"
#include "datasets/meshes/MeshFileText.h"
#include "filters/core/support/Error.h"
#include "filters/core/support/InputFile.h"
#include "filters/core/support/Text.h"

namespace umbra::meshfile {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

// Beginnings of the names of extensions that change no shape but how numbers are stored, which
// accessors say by themselves.
constexpr std::array<std::string_view, 6> harmlessExtensions{
    "KHR_materials_", "KHR_technique",         "KHR_texture_",
    "KHR_lights_",    "KHR_mesh_quantization", "EXT_texture_"};

bool isHarmless(std::string_view extension) {
  return std::any_of(harmlessExtensions.begin(), harmlessExtensions.end(),
                     [&](std::string_view known) { return extension.starts_with(known); });
}

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);  // little-endian, as this machine is
  return word;
}

void appendWord(std::string& out, std::size_t word) {
  for (int i = 0; i < 4; ++i) out += char(word >> (8 * i) & 0xff);
}

// A file's JSON, and of a binary one the chunks after it.
struct Parts {
  std::string_view json, chunks;
  bool isBinary = false;
};

constexpr std::size_t headerBytes = 12, chunkHeaderBytes = 8;

Parts partsIn(std::string_view content, const std::string& name) {
  if (!content.starts_with("glTF")) return {content, {}, false};
  if (content.size() < headerBytes + chunkHeaderBytes)
    refuse(name, "is truncated: it ends within its header");
  const std::size_t promised = wordAt(content, 8), length = wordAt(content, headerBytes);
  if (wordAt(content, 4) != 2)
    refuse(name,
           "is glTF of version " + std::to_string(wordAt(content, 4)) + "; version 2 is read");
  const std::size_t start = headerBytes + chunkHeaderBytes;
  if (promised > content.size() || length > content.size() - start)
    refuse(name, "is truncated: it promises " + std::to_string(std::max(promised, start + length)) +
                     " bytes and has " + std::to_string(content.size()));
  return {content.substr(start, length), content.substr(start + length), true};
}

bool lists(const OrderedJson& json, const char* key, std::string_view value) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array()) return false;
  return std::any_of(found->begin(), found->end(), [&](const OrderedJson& element) {
    return element.is_string() && element.get_ref<const std::string&>() == value;
  });
}

// A reader must refuse a file that requires what it does not know (glTF 2.0, 3.12).
void checkRequired(const OrderedJson& json, const std::string& name) {
  const auto required = json.find("extensionsRequired");
  if (required == json.end() || !required->is_array()) return;
  for (const OrderedJson& extension : *required) {
    const std::string text =
        extension.is_string() ? extension.get<std::string>() : quoted(extension);
    if (!isHarmless(text))
      refuse(name,
             "needs the extension " + clipped(text) + ", which is not read; export without it");
  }
}

bool has(const OrderedJson& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && !found->empty();
}

void checkVersion(const OrderedJson& json, const std::string& name) {
  const OrderedJson asset = json.is_object() ? json.value("asset", OrderedJson()) : OrderedJson();
  const auto version = asset.find("version");
  if (!asset.is_object() || version == asset.end() || !version->is_string())
    refuse(name, "is no glTF file: it has no asset.version");
  const std::string text = version->get<std::string>();
  if (!text.starts_with("2."))
    refuse(name, "is glTF of version " + clipped(text) + "; version 2 is read");
}

// What shapes need. TinyGLTF would read pictures, too, without looking whether they lie within
// their buffers, and follow what is nested in "extras".
OrderedJson shapesOf(const OrderedJson& json) {
  OrderedJson kept;
  for (const char* key : {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews",
                          "buffers", "materials"}) {
    const auto found = json.find(key);
    if (found != json.end()) kept[key] = *found;
  }
  for (const char* key : {"scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers"}) {
    if (!kept.contains(key) || !kept[key].is_array()) continue;
    for (OrderedJson& element : kept[key])
      if (element.is_object())
        for (const char* gone : {"extras", "extensions", "camera", "skin"}) element.erase(gone);
  }
  if (!kept.contains("materials") || !kept["materials"].is_array()) return kept;
  for (OrderedJson& material : kept["materials"]) {
    OrderedJson plain = OrderedJson::object();
    if (material.is_object() && material.contains("name")) plain["name"] = material["name"];
    const OrderedJson pbr = material.is_object()
                                ? material.value("pbrMetallicRoughness", OrderedJson())
                                : OrderedJson();
    if (pbr.is_object() && pbr.contains("baseColorFactor"))
      plain["pbrMetallicRoughness"]["baseColorFactor"] = pbr["baseColorFactor"];
    material = plain;
  }
  return kept;
}

// Where TinyGLTF may read: in the file's own folder.
bool readBeside(std::vector<unsigned char>* out, std::string* problem, const std::string& path,
                void* folder) {
  try {
    const fs::path file = fs::weakly_canonical(path);
    const fs::path relative = file.lexically_relative(*static_cast<const fs::path*>(folder));
    if (relative.empty() || *relative.begin() == "..") {
      *problem += "the buffer " + clipped(path) + " lies outside of the file's folder\n";
      return false;
    }
    const std::string content = contentOf(file, largestMesh);
    out->assign(content.begin(), content.end());
    return true;
  } catch (const std::exception& error) {
    *problem += std::string(error.what()) + "\n";
    return false;
  }
}

bool existsBeside(const std::string& path, void*) {
  std::error_code problem;
  return fs::exists(path, problem);
}

std::string unchanged(const std::string& path, void*) {
  return path;
}

bool writeNothing(std::string* problem, const std::string& path, const std::vector<unsigned char>&,
                  void*) {
  *problem += path + " is not written\n";
  return false;
}

[[maybe_unused]] bool sizeBeside(std::size_t* size, std::string* problem, const std::string& path,
                                 void*) {
  std::error_code unreadable;
  *size = std::size_t(fs::file_size(path, unreadable));
  if (unreadable) *problem += path + " cannot be read\n";
  return !unreadable;
}

// Debian 13's TinyGLTF asks for a file's size through one function more, and for all of them.
template <class Callbacks>
Callbacks callbacksFor(fs::path& folder) {
  Callbacks callbacks{};
  callbacks.FileExists = existsBeside;
  callbacks.ExpandFilePath = unchanged;
  callbacks.ReadWholeFile = readBeside;
  callbacks.WriteWholeFile = writeNothing;
  if constexpr (requires { callbacks.GetFileSizeInBytes; })
    callbacks.GetFileSizeInBytes = sizeBeside;
  callbacks.user_data = &folder;
  return callbacks;
}

// The first line of what TinyGLTF says.
std::string firstLine(const std::string& said) {
  const std::size_t reason = said.find("the buffer ");
  if (reason != std::string::npos)
    return clipped(
        trimmed(std::string_view(said).substr(reason, said.find('\n', reason) - reason)));
  const std::string_view line = trimmed(std::string_view(said).substr(0, said.find('\n')));
  return line.empty() ? "it has no reason to give" : clipped(line);
}

}  // namespace

GltfFile::GltfFile(std::string_view content, const std::string& name)
    : name_(name), model_(std::make_unique<tinygltf::Model>()) {
  std::string converted;
  const Parts parts = partsIn(plainText(content, converted), name);
  const OrderedJson json = jsonFromText(parts.json, name);
  checkVersion(json, name);
  checkRequired(json, name);
  if (lists(json, "extensionsUsed", "EXT_mesh_gpu_instancing"))
    notes_.push_back("of its instances one is shown");
  if (has(json, "skins")) notes_.push_back("its skins were not applied");
  if (has(json, "animations")) notes_.push_back("it is shown as it stands before its animations");

  std::string text = shapesOf(json).dump();
  fs::path folder = fs::weakly_canonical(fs::path(name).parent_path());
  if (folder.empty()) folder = fs::current_path();
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(callbacksFor<tinygltf::FsCallbacks>(folder));
  std::string problem, warning;
  bool read = false;
  if (parts.isBinary) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string whole = "glTF";
    appendWord(whole, 2);
    appendWord(whole, headerBytes + chunkHeaderBytes + text.size() + parts.chunks.size());
    appendWord(whole, text.size());
    (whole += "JSON") += text;
    whole += parts.chunks;
    if (whole.size() > UINT32_MAX) refuse(name, "has more than 4 GB, which no glTF may have");
    read = loader.LoadBinaryFromMemory(model_.get(), &problem, &warning,
                                       reinterpret_cast<const unsigned char*>(whole.data()),
                                       unsigned(whole.size()), folder.string());
  } else {
    read = loader.LoadASCIIFromString(model_.get(), &problem, &warning, text.data(),
                                      unsigned(text.size()), folder.string());
  }
  if (!read) refuse(name, "cannot be read as glTF: " + firstLine(problem));
}

GltfFile::~GltfFile() = default;

namespace {

double componentAt(const unsigned char* bytes, int type, bool normalized) {
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, bytes, sizeof value);
    if (!normalized || std::is_floating_point_v<T>) return double(value);
    return std::max(double(value) / double(std::numeric_limits<T>::max()), -1.0);
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return as(std::int8_t());
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return as(std::uint8_t());
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return as(std::int16_t());
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return as(std::uint16_t());
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return as(std::uint32_t());
    default:
      return as(float());
  }
}

bool isKnownComponent(int type) {
  return type >= TINYGLTF_COMPONENT_TYPE_BYTE && type <= TINYGLTF_COMPONENT_TYPE_FLOAT &&
         type != TINYGLTF_COMPONENT_TYPE_INT;
}

}  // namespace

std::vector<double> GltfFile::values(int index, int components) const {
  const std::string where = "accessor " + std::to_string(index);
  if (index < 0 || std::size_t(index) >= model_->accessors.size())
    refuse(name_, "refers to " + where + "; it has " + std::to_string(model_->accessors.size()));
  const tinygltf::Accessor& accessor = model_->accessors[std::size_t(index)];
  if (accessor.sparse.isSparse) refuse(name_, where + " is sparse, which is not read");
  if (tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)) != components ||
      !isKnownComponent(accessor.componentType))
    refuse(name_, where + " should have " + std::to_string(components) +
                      " components of a type that glTF has");
  if (accessor.bufferView < 0 || std::size_t(accessor.bufferView) >= model_->bufferViews.size())
    refuse(name_, where + " has no values");
  const tinygltf::BufferView& view = model_->bufferViews[std::size_t(accessor.bufferView)];
  const int stride = accessor.ByteStride(view);
  if (view.buffer < 0 || std::size_t(view.buffer) >= model_->buffers.size() || stride <= 0)
    refuse(name_, where + " has no values");
  const std::vector<unsigned char>& data = model_->buffers[std::size_t(view.buffer)].data;
  const std::size_t size =
      std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType)));
  // Each comparison leaves the next one nothing to overflow.
  const bool isInside =
      view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset &&
      accessor.byteOffset <= view.byteLength && accessor.count <= view.byteLength &&
      (accessor.count == 0 ||
       (accessor.count - 1) * std::size_t(stride) + size * std::size_t(components) <=
           view.byteLength - accessor.byteOffset);
  if (!isInside)
    refuse(name_,
           where + " reaches beyond its buffer, of " + std::to_string(data.size()) + " bytes");
  std::vector<double> values;
  values.reserve(accessor.count * std::size_t(components));
  for (std::size_t i = 0; i < accessor.count; ++i)
    for (int c = 0; c < components; ++c)
      values.push_back(componentAt(data.data() + view.byteOffset + accessor.byteOffset +
                                       i * std::size_t(stride) + size * std::size_t(c),
                                   accessor.componentType, accessor.normalized));
  return values;
}

}  // namespace umbra::meshfile
