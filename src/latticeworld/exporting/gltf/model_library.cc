#include "latticeworld/exporting/gltf/model_library.h"

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "latticeworld/exporting/body_meshes.h"
#include "latticeworld/exporting/gltf/model_mesh.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/ray_scene.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {

std::string ModelNameOf(const Scene& scene, const Asset& asset) {
  const auto& variants = scene.catalogue->season_variants(TypeOf(asset.kind));
  return scene.catalogue->models()[asset.model].name + "/" + variants[asset.season_variant].name +
         "/" + std::to_string(MeshVariationOf(asset));
}

Result<std::string> ModelLibraryGlb(const Scene& scene, const SpeciesCatalogue& species) {
  std::map<std::string, std::vector<std::uint32_t>> members;
  for (std::uint32_t i = 0; i < scene.assets.size(); ++i)
    members[ModelNameOf(scene, scene.assets[i])].push_back(i);

  GlbDocument document;
  std::vector<int> roots;
  const auto add_node = [&](const std::string& name, int mesh) {
    GlbNode node;
    node.name = name;
    node.mesh = mesh;
    roots.push_back(document.AddNode(node));
  };
  for (const auto& [name, assets] : members) {
    const Asset& example = scene.assets[assets.front()];
    const double foliage =
        scene.catalogue->season_variants(TypeOf(example.kind))[example.season_variant].foliage;
    const ModelColors colors = MeanColors(scene, assets);
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      const std::string mesh_name = name + "/" + std::to_string(detail);
      const Mesh mesh = BuildMesh(scene.catalogue->models()[example.model], foliage, detail,
                                  MeshVariationOf(example));
      if (mesh.triangles.empty()) continue;
      const ModelGeometry geometry = AddGeometry(mesh, /*quantized=*/true, &document);
      add_node(mesh_name,
               AddModel(mesh_name, geometry, AddMaterials(mesh_name, colors, geometry, &document),
                        &document));
    }
  }
  const ArtisticStyle style = scene.environment.coarse.artistic_style;
  for (const Species& entry : species.all())
    add_node("agent/" + entry.name, AddBody(entry, style, &document));
  for (const auto& entry : EnumNames(PropKind())) {
    const int mesh = AddProp(entry.value, style, &document);
    for (int detail = 0; detail < kMeshDetails; ++detail)
      add_node("element/" + std::string(entry.name) + "/" + std::to_string(detail), mesh);
  }
  return document.Finish(roots, "models");
}

}  // namespace latticeworld
