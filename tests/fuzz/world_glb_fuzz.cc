// GLB files of worlds that strangers wrote, taken apart by the format's specification: every number
// is one, and every index leads to something.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "exporting/glb_reader.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/support/stranger_scene.h"
#include "latticeworld/exporting/gltf/world_glb.h"
#include "latticeworld/species/species_catalogue.h"

namespace {

using namespace latticeworld;
using fuzz::Expect;
using nlohmann::json;

// JSON has no NaN and no infinity: what is neither number nor anything else is written as null.
bool HasNull(const json& value) {
  if (value.is_null()) return true;
  return value.is_structured() && std::any_of(value.begin(), value.end(), HasNull);
}

std::size_t CountOf(const json& document, const char* list) {
  return document.contains(list) ? document[list].size() : 0;
}

void CheckMeshes(const GlbReader& reader) {
  const json& document = reader.json();
  for (const json& mesh : document["meshes"]) {
    for (const json& primitive : mesh["primitives"]) {
      const json& attributes = primitive["attributes"];
      const std::size_t vertices =
          document["accessors"].at(attributes["POSITION"].get<std::size_t>())["count"];
      for (const json& accessor : attributes) {
        Expect(document["accessors"].at(accessor.get<std::size_t>())["count"] == vertices,
               "a mesh has as many of everything as it has vertices");
      }
      const std::vector<double> corners = reader.Read(primitive["indices"]);
      Expect(corners.size() % 3 == 0, "a mesh has whole triangles");
      Expect(*std::max_element(corners.begin(), corners.end()) < static_cast<double>(vertices),
             "a triangle's corners are vertices");
      Expect(primitive["material"].get<std::size_t>() < CountOf(document, "materials"),
             "a mesh's material is there");
    }
  }
  for (const json& material : document["materials"]) {
    for (const json& value : material["pbrMetallicRoughness"]["baseColorFactor"])
      Expect(value >= 0.0 && value <= 1.0, "a colour's parts are from 0 to 1");
  }
}

void CheckNodes(const json& document) {
  const std::size_t count = CountOf(document, "nodes");
  std::vector<int> parents(count, 0);
  for (const json& node : document["nodes"]) {
    Expect(!node.contains("mesh") || node["mesh"].get<std::size_t>() < CountOf(document, "meshes"),
           "a node's mesh is there");
    for (const json& child : node.value("children", json::array()))
      ++parents.at(child.get<std::size_t>());
    double square = 0.0;
    for (const json& part : node.value("rotation", json::array({1.0})))
      square += part.get<double>() * part.get<double>();
    Expect(std::abs(square - 1.0) < 1e-4, "a rotation is a unit quaternion");
  }
  for (const json& root : document["scenes"][0]["nodes"]) ++parents.at(root.get<std::size_t>());
  Expect(std::all_of(parents.begin(), parents.end(), [](int number) { return number == 1; }),
         "every node stands at one place of the tree");
}

void CheckAccessors(const GlbReader& reader) {
  const std::size_t count = CountOf(reader.json(), "accessors");
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<double> values = reader.Read(static_cast<int>(i));
    Expect(std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }),
           "every number of the file is finite");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  testing::GTEST_FLAG(throw_on_failure) = true;  // GlbReader's expectations end the program as well
  std::string_view input = fuzz::TextOf(data, size);
  const fuzz::ExportChoice choice = fuzz::TakeExportChoice(&input);
  WorldGlbOptions options;
  options.region = choice.region;
  options.ground_step_m = 8.0;
  options.texture_px = 16;
  options.expand = choice.expand;
  options.small_plants = choice.small_plants;
  options.detail = choice.detail;
  const auto scene = fuzz::StrangerScene(input);
  const auto glb = WorldGlb(*scene, *SpeciesCatalogue::BuiltIn(), options, Progress());
  Expect(glb.ok(), "a world that can be loaded can be exported");
  const GlbReader reader(*glb);
  Expect(!HasNull(reader.json()), "every number of the file's head is one");
  CheckAccessors(reader);
  CheckMeshes(reader);
  CheckNodes(reader.json());
  return 0;
}
