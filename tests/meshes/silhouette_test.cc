#include "meshes/silhouette.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace latticeworld {
namespace {

using Shares = std::array<double, 3>;  // by axis

// Means over the variations.
Shares MeanCover(const AssetModel& model, double foliage, int detail) {
  Shares shares = {};
  for (int variation = 0; variation < kMeshVariations; ++variation) {
    const Mesh mesh = BuildMesh(model, foliage, detail, variation);
    for (int axis = 0; axis < 3; ++axis) {
      shares[static_cast<std::size_t>(axis)] += CoveredShare(mesh, axis) / kMeshVariations;
    }
  }
  return shares;
}

bool IsLarge(AssetKind kind) {
  return kind == AssetKind::kTree || kind == AssetKind::kBush || kind == AssetKind::kStone ||
         kind == AssetKind::kBuilding;
}

TEST(SilhouetteTest, CoversWhatATriangleDoes) {
  Mesh mesh;
  mesh.vertices = {{0.0f, -1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 1.0f}};
  mesh.triangles = {{0, 1, 2}};
  mesh.parts = {MeshPart::kStone};
  EXPECT_NEAR(CoveredShare(mesh, 0), 0.5, 0.01);
  EXPECT_NEAR(CoveredShare(mesh, 1), 0.0, 0.01);
}

TEST(SilhouetteTest, LargeThingsCoverAsMuchAtEveryDetailFromEverySide) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (!IsLarge(model.kind)) continue;
    const Shares fine = MeanCover(model, 1.0, 0);
    for (int detail = 1; detail < kMeshDetails; ++detail) {
      const Shares coarse = MeanCover(model, 1.0, detail);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(coarse[axis] / fine[axis], 1.0, 0.25)
            << model.name << ", detail " << detail << ", axis " << axis;
      }
    }
  }
}

TEST(SilhouetteTest, BareAndHalfBareCrownsCoverAboutAsMuchAtEveryDetail) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (model.kind != AssetKind::kTree && model.kind != AssetKind::kBush) continue;
    for (const double foliage : {0.0, 0.5}) {
      const Shares fine = MeanCover(model, foliage, 0);
      for (int detail = 1; detail < kMeshDetails; ++detail) {
        const Shares coarse = MeanCover(model, foliage, detail);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_NEAR(coarse[axis] / fine[axis], 1.0, 0.4)
              << model.name << ", foliage " << foliage << ", detail " << detail << ", axis "
              << axis;
        }
      }
    }
  }
}

TEST(SilhouetteTest, SmallThingsCoverAboutAsMuchAtEveryDetail) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (IsLarge(model.kind)) continue;
    const Shares fine = MeanCover(model, 1.0, 0);
    for (int detail = 1; detail < kMeshDetails; ++detail) {
      const Shares coarse = MeanCover(model, 1.0, detail);
      EXPECT_NEAR((coarse[0] + coarse[1] + coarse[2]) / (fine[0] + fine[1] + fine[2]), 1.0, 0.4)
          << model.name << ", detail " << detail;
    }
  }
}

TEST(SilhouetteTest, TreesCoverLessWithLessFoliage) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (model.kind != AssetKind::kTree) continue;
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      const auto cover = [&](double foliage) {
        return CoveredShare(BuildMesh(model, foliage, detail, 1), 0);
      };
      const double bare = cover(0.0), half = cover(0.5), full = cover(1.0);
      EXPECT_LT(bare, 0.6 * half) << model.name << ", detail " << detail;
      EXPECT_LT(half, 1.02 * full) << model.name << ", detail " << detail;
      EXPECT_GT(full, 0.2) << model.name << ", detail " << detail;
    }
  }
}

}  // namespace
}  // namespace latticeworld
