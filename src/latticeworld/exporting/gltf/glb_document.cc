#include "latticeworld/exporting/gltf/glb_document.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

// These numbers are the format's.
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963, kNoTarget = 0;
constexpr int kShort = 5122, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr std::uint32_t kMagic = 0x46546c67, kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr std::size_t kAlignment = 4;
// 65535 is kept for strips that end.
constexpr std::size_t kMostShortVertices = 65535;

constexpr char kInstancing[] = "EXT_mesh_gpu_instancing";
constexpr char kQuantization[] = "KHR_mesh_quantization";
constexpr char kLights[] = "KHR_lights_punctual";

Json ToJson(const Eigen::Vector3f& v) { return Json::array({v.x(), v.y(), v.z()}); }

void AppendWord(std::uint32_t word, std::string* bytes) {
  for (int shift = 0; shift < 32; shift += 8)
    bytes->push_back(static_cast<char>((word >> shift) & 0xffu));
}

void Pad(char with, std::string* bytes) {
  while (bytes->size() % kAlignment != 0) bytes->push_back(with);
}

}  // namespace

struct GlbDocument::Parts {
  std::string binary;
  Json accessors = Json::array(), views = Json::array(), images = Json::array();
  Json textures = Json::array(), materials = Json::array(), meshes = Json::array();
  Json nodes = Json::array(), lights = Json::array();
  bool instancing = false, quantization = false;
  GlbNames names = GlbNames::kAsGiven;
};

GlbDocument::GlbDocument(GlbNames names) : parts_(std::make_unique<Parts>()) {
  parts_->names = names;
}
GlbDocument::~GlbDocument() = default;

std::string GlbDocument::Named(const std::string& name) const {
  if (parts_->names == GlbNames::kAsGiven) return name;
  constexpr std::string_view kTakenOut = "[].:/ \t\r\n";
  std::string plain = name;
  for (char& c : plain) {
    if (kTakenOut.find(c) != std::string_view::npos) c = '_';
  }
  return plain;
}

int GlbDocument::AddView(const void* data, std::size_t bytes, int target) {
  Pad('\0', &parts_->binary);
  Json view = {{"buffer", 0}, {"byteOffset", parts_->binary.size()}, {"byteLength", bytes}};
  if (target != kNoTarget) view["target"] = target;
  parts_->binary.append(static_cast<const char*>(data), bytes);
  parts_->views.push_back(std::move(view));
  return static_cast<int>(parts_->views.size()) - 1;
}

int GlbDocument::AddAccessor(int view, int component, std::size_t count, const char* type) {
  parts_->accessors.push_back(
      {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  return static_cast<int>(parts_->accessors.size()) - 1;
}

int GlbDocument::AddPositions(const std::vector<Eigen::Vector3f>& positions_m) {
  const int accessor = AddAccessor(
      AddView(positions_m.data(), positions_m.size() * sizeof(Eigen::Vector3f), kArrayBuffer),
      kFloat, positions_m.size(), "VEC3");
  Eigen::Vector3f low = positions_m.front(), high = low;
  for (const Eigen::Vector3f& position : positions_m) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  parts_->accessors.back()["min"] = ToJson(low);
  parts_->accessors.back()["max"] = ToJson(high);
  return accessor;
}

int GlbDocument::AddUnitPositions(const std::vector<Eigen::Vector3f>& positions) {
  constexpr float kSteps = 32767.0f;
  std::vector<std::array<std::int16_t, 4>> steps;  // the fourth keeps words aligned
  steps.reserve(positions.size());
  Eigen::Array3i low = Eigen::Array3i::Constant(32767), high = -low;
  for (const Eigen::Vector3f& position : positions) {
    Eigen::Array3i step;
    for (int i = 0; i < 3; ++i)
      step[i] = static_cast<int>(std::lround(kSteps * std::clamp(position[i], -1.0f, 1.0f)));
    low = low.min(step);
    high = high.max(step);
    steps.push_back({static_cast<std::int16_t>(step[0]), static_cast<std::int16_t>(step[1]),
                     static_cast<std::int16_t>(step[2]), 0});
  }
  const int view = AddView(steps.data(), steps.size() * sizeof(steps[0]), kArrayBuffer);
  parts_->views.back()["byteStride"] = sizeof(steps[0]);
  const int accessor = AddAccessor(view, kShort, steps.size(), "VEC3");
  parts_->accessors.back()["normalized"] = true;
  parts_->accessors.back()["min"] = Json::array({low[0], low[1], low[2]});
  parts_->accessors.back()["max"] = Json::array({high[0], high[1], high[2]});
  parts_->quantization = true;
  return accessor;
}

int GlbDocument::AddVectors(const std::vector<Eigen::Vector3f>& vectors) {
  return AddAccessor(AddView(vectors.data(), vectors.size() * sizeof(Eigen::Vector3f), kNoTarget),
                     kFloat, vectors.size(), "VEC3");
}

int GlbDocument::AddNumbers(const std::vector<std::uint32_t>& numbers) {
  const std::vector<float> values(numbers.begin(), numbers.end());
  return AddAccessor(AddView(values.data(), values.size() * sizeof(float), kNoTarget), kFloat,
                     values.size(), "SCALAR");
}

int GlbDocument::AddNormals(const std::vector<Eigen::Vector3f>& normals) {
  return AddAccessor(
      AddView(normals.data(), normals.size() * sizeof(Eigen::Vector3f), kArrayBuffer), kFloat,
      normals.size(), "VEC3");
}

int GlbDocument::AddTextureCoordinates(const std::vector<Eigen::Vector2f>& coordinates) {
  return AddAccessor(
      AddView(coordinates.data(), coordinates.size() * sizeof(Eigen::Vector2f), kArrayBuffer),
      kFloat, coordinates.size(), "VEC2");
}

int GlbDocument::AddRotations(const std::vector<Eigen::Quaternionf>& rotations) {
  std::vector<std::array<float, 4>> values;
  values.reserve(rotations.size());
  for (const Eigen::Quaternionf& q : rotations) values.push_back({q.x(), q.y(), q.z(), q.w()});
  return AddAccessor(AddView(values.data(), values.size() * sizeof(values[0]), kNoTarget), kFloat,
                     values.size(), "VEC4");
}

int GlbDocument::AddIndices(const std::vector<std::uint32_t>& corners, std::size_t vertices) {
  if (vertices > kMostShortVertices) {
    return AddAccessor(
        AddView(corners.data(), corners.size() * sizeof(std::uint32_t), kElementArrayBuffer),
        kUnsignedInt, corners.size(), "SCALAR");
  }
  const std::vector<std::uint16_t> narrow(corners.begin(), corners.end());
  return AddAccessor(
      AddView(narrow.data(), narrow.size() * sizeof(std::uint16_t), kElementArrayBuffer),
      kUnsignedShort, narrow.size(), "SCALAR");
}

int GlbDocument::AddTexture(const std::string& jpeg, const std::string& name) {
  parts_->images.push_back({{"name", Named(name)},
                            {"mimeType", "image/jpeg"},
                            {"bufferView", AddView(jpeg.data(), jpeg.size(), kNoTarget)}});
  parts_->textures.push_back({{"source", parts_->images.size() - 1}, {"sampler", 0}});
  return static_cast<int>(parts_->textures.size()) - 1;
}

int GlbDocument::AddMaterial(const GlbMaterial& material) {
  const Eigen::Vector4f& color = material.base_color;
  Json surface = {{"baseColorFactor", {color[0], color[1], color[2], color[3]}},
                  {"metallicFactor", 0.0},
                  {"roughnessFactor", material.roughness}};
  if (material.texture >= 0) surface["baseColorTexture"] = {{"index", material.texture}};
  Json json = {{"name", Named(material.name)}, {"pbrMetallicRoughness", std::move(surface)}};
  if (color[3] < 1.0f) json["alphaMode"] = "BLEND";
  if (material.both_sides) json["doubleSided"] = true;
  parts_->materials.push_back(std::move(json));
  return static_cast<int>(parts_->materials.size()) - 1;
}

int GlbDocument::AddMesh(const std::string& name, const std::vector<GlbPrimitive>& primitives) {
  Json list = Json::array();
  for (const GlbPrimitive& primitive : primitives) {
    Json attributes = {{"POSITION", primitive.positions}};
    if (primitive.normals >= 0) attributes["NORMAL"] = primitive.normals;
    if (primitive.texture_coordinates >= 0)
      attributes["TEXCOORD_0"] = primitive.texture_coordinates;
    list.push_back({{"attributes", std::move(attributes)},
                    {"indices", primitive.indices},
                    {"material", primitive.material}});
  }
  parts_->meshes.push_back({{"name", Named(name)}, {"primitives", std::move(list)}});
  return static_cast<int>(parts_->meshes.size()) - 1;
}

int GlbDocument::AddSun(const std::string& name, const Eigen::Vector3f& linear_color,
                        double illuminance_lux) {
  parts_->lights.push_back({{"name", Named(name)},
                            {"type", "directional"},
                            {"color", ToJson(linear_color)},
                            {"intensity", illuminance_lux}});
  return static_cast<int>(parts_->lights.size()) - 1;
}

int GlbDocument::AddNode(const GlbNode& node) {
  Json json = {{"name", Named(node.name)}};
  if (node.mesh >= 0) json["mesh"] = node.mesh;
  if (node.translation_m) json["translation"] = ToJson(*node.translation_m);
  if (node.rotation) {
    const Eigen::Quaternionf& q = *node.rotation;
    json["rotation"] = Json::array({q.x(), q.y(), q.z(), q.w()});
  }
  if (node.scale) json["scale"] = ToJson(*node.scale);
  if (!node.children.empty()) json["children"] = node.children;
  if (node.light >= 0) json["extensions"][kLights] = {{"light", node.light}};
  if (node.instances) {
    parts_->instancing = true;
    Json& attributes = json["extensions"][kInstancing]["attributes"];
    attributes = {{"TRANSLATION", node.instances->translations},
                  {"ROTATION", node.instances->rotations},
                  {"SCALE", node.instances->scales}};
    if (node.instances->assets >= 0) attributes["_ASSET"] = node.instances->assets;
  }
  const GlbExtras& extras = node.extras;
  if (!extras.kind.empty()) json["extras"]["kind"] = extras.kind;
  if (!extras.model.empty()) json["extras"]["model"] = extras.model;
  if (extras.asset) json["extras"]["asset"] = *extras.asset;
  parts_->nodes.push_back(std::move(json));
  return static_cast<int>(parts_->nodes.size()) - 1;
}

Result<std::string> GlbDocument::Finish(const std::vector<int>& root_nodes,
                                        const std::string& name) const {
  try {
    Json json;
    json["asset"] = {{"version", "2.0"}, {"generator", "LatticeWorld"}};
    Json used = Json::array(), required = Json::array();
    if (!parts_->lights.empty()) {
      used.push_back(kLights);
      json["extensions"][kLights] = {{"lights", parts_->lights}};
    }
    if (parts_->instancing) {
      used.push_back(kInstancing);
      required.push_back(kInstancing);  // without it things would stand in the middle of the world
    }
    if (parts_->quantization) {
      used.push_back(kQuantization);
      required.push_back(kQuantization);
    }
    if (!used.empty()) json["extensionsUsed"] = std::move(used);
    if (!required.empty()) json["extensionsRequired"] = std::move(required);
    json["scene"] = 0;
    json["scenes"] = {{{"name", name}, {"nodes", root_nodes}}};
    const auto add = [&json](const char* key, const Json& list) {
      if (!list.empty()) json[key] = list;
    };
    add("nodes", parts_->nodes);
    add("meshes", parts_->meshes);
    add("materials", parts_->materials);
    add("textures", parts_->textures);
    add("images", parts_->images);
    if (!parts_->textures.empty()) {
      constexpr int kLinear = 9729, kLinearMipmapLinear = 9987, kClampToEdge = 33071;
      json["samplers"] = {{{"magFilter", kLinear},
                           {"minFilter", kLinearMipmapLinear},
                           {"wrapS", kClampToEdge},
                           {"wrapT", kClampToEdge}}};
    }
    add("accessors", parts_->accessors);
    add("bufferViews", parts_->views);
    if (!parts_->binary.empty()) json["buffers"] = {{{"byteLength", parts_->binary.size()}}};

    // Names come from files of users, which may hold anything: what is not UTF-8 is replaced.
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    Pad(' ', &text);
    const std::size_t padding = (kAlignment - parts_->binary.size() % kAlignment) % kAlignment;
    const std::size_t binary = parts_->binary.size() + padding;
    const std::size_t total = kHeaderBytes + kChunkHeaderBytes + text.size() +
                              (binary > 0 ? kChunkHeaderBytes + binary : 0);
    if (total > std::numeric_limits<std::uint32_t>::max())
      return ResourceExhausted("a GLB holds at most 4 GiB, this one would have " +
                               std::to_string(total) + " bytes: take a region, or coarser ground");
    std::string glb;
    glb.reserve(total);
    AppendWord(kMagic, &glb);
    AppendWord(kVersion, &glb);
    AppendWord(static_cast<std::uint32_t>(total), &glb);
    AppendWord(static_cast<std::uint32_t>(text.size()), &glb);
    AppendWord(kJsonChunk, &glb);
    glb += text;
    if (binary > 0) {
      AppendWord(static_cast<std::uint32_t>(binary), &glb);
      AppendWord(kBinaryChunk, &glb);
      glb += parts_->binary;
      glb.append(padding, '\0');
    }
    return glb;
  } catch (const std::bad_alloc&) {
    return ResourceExhausted("not enough memory for the GLB");
  } catch (const std::exception& error) {
    return Internal(std::string("cannot write the GLB: ") + error.what());
  }
}

}  // namespace latticeworld
