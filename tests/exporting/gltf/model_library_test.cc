#include "latticeworld/exporting/gltf/model_library.h"

#include <gtest/gtest.h>

#include <string>

#include "exporting/glb_reader.h"
#include "generation/test_world.h"
#include "latticeworld/meshes/mesh.h"
#include "latticeworld/scene/scene.h"
#include "latticeworld/sensing/solids/ray_scene.h"
#include "latticeworld/species/species_catalogue.h"

namespace latticeworld {
namespace {

class ModelLibraryTest : public ::testing::Test {
 protected:
  const std::shared_ptr<World> world_ = MakeTestWorld();
  const Scene& scene_ = *world_->scene;
  const std::shared_ptr<const SpeciesCatalogue> species_ = SpeciesCatalogue::BuiltIn();

  // Bounds of a node's mesh, in front-left-up axes.
  static void Bounds(const GlbReader& glb, const std::string& name, Eigen::Vector3d* low,
                     Eigen::Vector3d* high) {
    ASSERT_NE(glb.Node(name), nullptr) << name;
    *low = Eigen::Vector3d::Constant(1e9);
    *high = -*low;
    const auto& mesh = glb.json()["meshes"][(*glb.Node(name))["mesh"].get<int>()];
    for (const auto& primitive : mesh["primitives"]) {
      for (const auto& p : glb.ReadVectors(primitive["attributes"]["POSITION"])) {
        const Eigen::Vector3d point(p.x(), -p.z(), p.y());
        *low = low->cwiseMin(point);
        *high = high->cwiseMax(point);
      }
    }
  }
};

TEST_F(ModelLibraryTest, EveryAssetHasItsMeshAtEveryLevelToAStepOfItsUnitBox) {
  const GlbReader glb(*ModelLibraryGlb(scene_, *species_));
  for (const Asset& asset : scene_.assets) {
    const auto& variants = scene_.catalogue->season_variants(TypeOf(asset.kind));
    for (int level = 0; level < kMeshDetails; ++level) {
      const Mesh mesh =
          BuildMesh(scene_.catalogue->models()[asset.model], variants[asset.season_variant].foliage,
                    level, MeshVariationOf(asset));
      Eigen::Vector3f low = mesh.vertices.front(), high = low;
      for (const Eigen::Vector3f& vertex : mesh.vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
      }
      Eigen::Vector3d found_low, found_high;
      Bounds(glb, ModelNameOf(scene_, asset) + "/" + std::to_string(level), &found_low,
             &found_high);
      EXPECT_LT((found_low - low.cast<double>()).cwiseAbs().maxCoeff(), 2.0 / 32767.0);
      EXPECT_LT((found_high - high.cast<double>()).cwiseAbs().maxCoeff(), 2.0 / 32767.0);
    }
  }
}

TEST_F(ModelLibraryTest, BodiesStandOnTheOriginAtTheirSize) {
  const GlbReader glb(*ModelLibraryGlb(scene_, *species_));
  for (const Species& species : species_->all()) {
    Eigen::Vector3d low, high;
    Bounds(glb, "agent/" + species.name, &low, &high);
    EXPECT_NEAR(low.z(), 0.0, 0.1 * species.height_m) << species.name;
    EXPECT_GT(high.z(), 0.5 * species.height_m) << species.name;
  }
}

TEST_F(ModelLibraryTest, PropsHaveSizeOneInTheirOwnFrame) {
  const GlbReader glb(*ModelLibraryGlb(scene_, *species_));
  Eigen::Vector3d low, high;
  Bounds(glb, "element/crate/0", &low, &high);
  EXPECT_NEAR((low - Eigen::Vector3d(-0.5, -0.5, 0.0)).norm(), 0.0, 1e-5);
  EXPECT_NEAR((high - Eigen::Vector3d(0.5, 0.5, 1.0)).norm(), 0.0, 1e-5);
  Bounds(glb, "element/gate/2", &low, &high);
  EXPECT_NEAR(low.x(), 0.0, 1e-5);  // the hinge
  EXPECT_NEAR(high.x(), 1.0, 1e-5);
}

TEST_F(ModelLibraryTest, MaterialsAreNamedAfterTheirParts) {
  const GlbReader glb(*ModelLibraryGlb(scene_, *species_));
  const std::string name = ModelNameOf(scene_, scene_.assets.front()) + "/0";
  const auto& mesh = glb.json()["meshes"][(*glb.Node(name))["mesh"].get<int>()];
  for (const auto& primitive : mesh["primitives"]) {
    const auto& material = glb.json()["materials"][primitive["material"].get<int>()];
    const std::string part = material["name"];
    EXPECT_EQ(part.substr(0, name.size() + 1), name + "/");
    for (const double value : material["pbrMetallicRoughness"]["baseColorFactor"]) {
      EXPECT_GE(value, 0.0);
      EXPECT_LE(value, 1.0);
    }
  }
}

TEST_F(ModelLibraryTest, TheSameSceneGivesTheSameBytes) {
  EXPECT_EQ(*ModelLibraryGlb(scene_, *species_), *ModelLibraryGlb(scene_, *species_));
}

}  // namespace
}  // namespace latticeworld
