#include "exporting/glb_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>

namespace latticeworld {
namespace {

std::uint32_t WordAt(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

std::size_t BytesOf(int component) {
  static const std::map<int, std::size_t> bytes = {{5122, 2}, {5123, 2}, {5125, 4}, {5126, 4}};
  return bytes.at(component);
}

std::size_t ComponentsOf(const std::string& type) {
  static const std::map<std::string, std::size_t> components = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  return components.at(type);
}

}  // namespace

GlbReader::GlbReader(const std::string& glb) {
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(WordAt(glb, 4), 2u);
  EXPECT_EQ(WordAt(glb, 8), glb.size());
  const std::size_t length = WordAt(glb, 12);
  EXPECT_EQ(glb.substr(16, 4), "JSON");
  json_ = nlohmann::json::parse(glb.substr(20, length));
  const std::size_t binary = WordAt(glb, 20 + length);
  EXPECT_EQ(28 + length + binary, glb.size());
  binary_ = glb.substr(28 + length);
  EXPECT_LE(json_["buffers"][0]["byteLength"].get<std::size_t>(), binary_.size());

  for (const auto& view : json_["bufferViews"]) {
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
              binary_.size());
  }
  for (const auto& accessor : json_["accessors"]) {
    const auto& view = json_["bufferViews"][accessor["bufferView"].get<int>()];
    const std::size_t prop = ComponentsOf(accessor["type"]) * BytesOf(accessor["componentType"]);
    const std::size_t stride = view.value("byteStride", prop);
    const std::size_t count = accessor["count"];
    EXPECT_GT(count, 0u);
    EXPECT_LE((count - 1) * stride + prop, view["byteLength"].get<std::size_t>());
  }
}

const nlohmann::json* GlbReader::Node(const std::string& name) const {
  for (const auto& node : json_["nodes"]) {
    if (node["name"] == name) return &node;
  }
  return nullptr;
}

std::vector<const nlohmann::json*> GlbReader::Children(const std::string& name) const {
  std::vector<const nlohmann::json*> children;
  const nlohmann::json* parent = Node(name);
  if (parent == nullptr) return children;
  for (const int child : (*parent)["children"]) children.push_back(&json_["nodes"][child]);
  return children;
}

std::vector<double> GlbReader::Read(int number) const {
  const auto& accessor = json_["accessors"][number];
  const auto& view = json_["bufferViews"][accessor["bufferView"].get<int>()];
  const int component = accessor["componentType"];
  const std::size_t components = ComponentsOf(accessor["type"]);
  const std::size_t stride = view.value("byteStride", components * BytesOf(component));
  const std::size_t start = view["byteOffset"];
  std::vector<double> values;
  for (std::size_t i = 0; i < accessor["count"].get<std::size_t>(); ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      const char* at = binary_.data() + start + i * stride + c * BytesOf(component);
      const auto read = [at](auto value) {
        std::memcpy(&value, at, sizeof value);
        return static_cast<double>(value);
      };
      double value = 0.0;
      if (component == 5122) value = read(std::int16_t());
      if (component == 5123) value = read(std::uint16_t());
      if (component == 5125) value = read(std::uint32_t());
      if (component == 5126) value = read(float());
      if (accessor.value("normalized", false)) value = std::max(-1.0, value / 32767.0);
      values.push_back(value);
    }
  }
  return values;
}

std::vector<Eigen::Vector3d> GlbReader::ReadVectors(int accessor) const {
  const std::vector<double> values = Read(accessor);
  std::vector<Eigen::Vector3d> vectors;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3)
    vectors.emplace_back(values[i], values[i + 1], values[i + 2]);
  return vectors;
}

}  // namespace latticeworld
