#include "latticeworld/meshes/mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

namespace latticeworld {
namespace {

constexpr std::array<double, 3> kFoliages = {0.0, 0.5, 1.0};

// Every built-in model at every detail, in every variation, with all foliage, and every other one
// with some and none.
void ForEveryMesh(
    const std::function<void(const AssetModel&, double, int, int, const Mesh&)>& check) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      for (int variation = 0; variation < kMeshVariations; ++variation) {
        for (const double foliage : kFoliages) {
          if (foliage < 1.0 && variation % 2 == detail % 2) continue;
          SCOPED_TRACE(model.name + ", detail " + std::to_string(detail) + ", variation " +
                       std::to_string(variation) + ", foliage " + std::to_string(foliage));
          check(model, foliage, detail, variation, BuildMesh(model, foliage, detail, variation));
        }
      }
    }
  }
}

std::size_t Count(const Mesh& mesh, MeshPart part) {
  return static_cast<std::size_t>(std::count(mesh.parts.begin(), mesh.parts.end(), part));
}

bool SameBytes(const Mesh& a, const Mesh& b) {
  return a.vertices.size() == b.vertices.size() && a.triangles == b.triangles &&
         a.parts == b.parts &&
         std::memcmp(a.vertices.data(), b.vertices.data(),
                     a.vertices.size() * sizeof(a.vertices[0])) == 0;
}

struct Box {
  Eigen::Vector3f low, high;
};
Box BoxOf(const Mesh& mesh) {
  Box box = {Eigen::Vector3f::Constant(1e9f), Eigen::Vector3f::Constant(-1e9f)};
  for (const auto& v : mesh.vertices) {
    box.low = box.low.cwiseMin(v);
    box.high = box.high.cwiseMax(v);
  }
  return box;
}

const AssetModel& FirstOf(Shape shape) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (model.shape == shape) return model;
  }
  ADD_FAILURE() << "the catalogue has no " << NameOf(shape);
  return Catalogue::BuiltIn()->models().front();
}

TEST(MeshTest, TrianglesAreSoundAndInTheUnitBox) {
  ForEveryMesh([](const AssetModel&, double, int, int, const Mesh& mesh) {
    ASSERT_FALSE(mesh.triangles.empty());
    ASSERT_EQ(mesh.parts.size(), mesh.triangles.size());
    for (const auto& v : mesh.vertices) {
      ASSERT_TRUE(v.allFinite());
      ASSERT_LE(std::max(std::abs(v.x()), std::abs(v.y())), 1.0f);
      ASSERT_LE(v.z(), 1.0f);
      ASSERT_GE(v.z(), -0.101f);
    }
    std::vector<char> used(mesh.vertices.size(), 0);
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        ASSERT_LT(corner, mesh.vertices.size());
        used[corner] = 1;
      }
      const Eigen::Vector3f a = mesh.vertices[triangle[0]], b = mesh.vertices[triangle[1]],
                            c = mesh.vertices[triangle[2]];
      ASSERT_GT((b - a).cross(c - a).norm(), 0.0f);
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), 1),
              static_cast<std::ptrdiff_t>(mesh.vertices.size()));
  });
}

TEST(MeshTest, KeepsToItsBudgetOfTriangles) {
  ForEveryMesh([](const AssetModel& model, double, int detail, int, const Mesh& mesh) {
    std::array<std::size_t, kMeshDetails> budget = {60, 16, 4};
    switch (model.kind) {
      case AssetKind::kTree:
        budget = {15000, 2000, 300};
        break;
      case AssetKind::kBush:
        budget = {5000, 700, 100};
        break;
      case AssetKind::kStone:
        budget = {320, 80, 20};
        break;
      case AssetKind::kBuilding:
        budget = {400, 80, 26};
        break;
      case AssetKind::kDeadBranch:
        budget = {180, 60, 24};
        break;
      case AssetKind::kCrop:
        budget = model.shape == Shape::kVine    ? std::array<std::size_t, 3>{240, 70, 12}
                 : model.shape == Shape::kMaize ? std::array<std::size_t, 3>{80, 20, 4}
                                                : budget;
        break;
      default:
        break;
    }
    if (model.shape == Shape::kParts) budget = {800, 600, 400};
    EXPECT_LE(mesh.triangles.size(), budget[static_cast<std::size_t>(detail)]);
  });
}

TEST(MeshTest, TheSameIsTheSameAndVariationsDiffer) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      const Mesh first = BuildMesh(model, 0.7, detail, 0);
      EXPECT_TRUE(SameBytes(first, BuildMesh(model, 0.7, detail, 0))) << model.name;
      // Blocks of a few triangles are all the same, and so is what is put together from parts.
      if (model.kind == AssetKind::kBuilding && (detail > 0 || !model.is_house())) continue;
      for (int variation = 1; variation < kMeshVariations; ++variation) {
        EXPECT_FALSE(SameBytes(first, BuildMesh(model, 0.7, detail, variation)))
            << model.name << ", detail " << detail << ", variation " << variation;
      }
    }
  }
}

TEST(MeshTest, DetailsFillTheSameBox) {
  ForEveryMesh([](const AssetModel& model, double foliage, int, int, const Mesh& mesh) {
    if (foliage < 1.0) return;
    const Box box = BoxOf(mesh);
    EXPECT_NEAR(box.high.z(), 1.0f, 1e-5f);
    EXPECT_LE(box.low.z(), 0.35f);
    EXPECT_NEAR(box.high.x(), 1.0f, 1e-5f);
    EXPECT_NEAR(box.low.x(), -1.0f, 1e-5f);
    // Logs and rows of vines are narrower than long.
    if (model.shape == Shape::kBranch || model.shape == Shape::kVine) return;
    EXPECT_NEAR(box.high.y(), 1.0f, 1e-5f);
    EXPECT_NEAR(box.low.y(), -1.0f, 1e-5f);
  });
}

TEST(MeshTest, StandsOnTheGround) {
  ForEveryMesh([](const AssetModel&, double foliage, int, int, const Mesh& mesh) {
    if (foliage < 1.0) return;
    EXPECT_LE(BoxOf(mesh).low.z(), 0.12f);
  });
}

TEST(MeshTest, LessFoliageIsASubsetOfTheSameLeaves) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      std::array<std::vector<std::array<float, 9>>, 3> leaves;
      for (std::size_t i = 0; i < 3; ++i) {
        const Mesh mesh = BuildMesh(model, kFoliages[i], detail, 1);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
          if (mesh.parts[t] != MeshPart::kLeaves && mesh.parts[t] != MeshPart::kBlossom) continue;
          std::array<float, 9> corners;
          for (std::size_t k = 0; k < 3; ++k) {
            std::copy_n(mesh.vertices[mesh.triangles[t][k]].data(), 3, &corners[3 * k]);
          }
          leaves[i].push_back(corners);
        }
        std::sort(leaves[i].begin(), leaves[i].end());
      }
      EXPECT_LE(leaves[0].size(), leaves[1].size()) << model.name;
      EXPECT_LE(leaves[1].size(), leaves[2].size()) << model.name;
      // Crowns are stretched to the box by their twigs too, which only bare ones have.
      if (model.kind == AssetKind::kTree || model.kind == AssetKind::kBush) continue;
      EXPECT_TRUE(
          std::includes(leaves[2].begin(), leaves[2].end(), leaves[1].begin(), leaves[1].end()))
          << model.name << ", detail " << detail;
    }
  }
}

TEST(MeshTest, BareTreesShowTheirWoodAndNoLeaf) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (model.kind != AssetKind::kTree && model.kind != AssetKind::kBush) continue;
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      const Mesh bare = BuildMesh(model, 0.0, detail, 2), full = BuildMesh(model, 1.0, detail, 2);
      EXPECT_EQ(Count(bare, MeshPart::kLeaves), 0u) << model.name;
      EXPECT_GE(Count(bare, MeshPart::kBark), 26u) << model.name << ", detail " << detail;
      EXPECT_GT(Count(full, MeshPart::kLeaves), Count(full, MeshPart::kBark)) << model.name;
    }
  }
}

TEST(MeshTest, ATrunkHasItsRadiusAtBreastHeight) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (model.collision != Collision::kTrunk) continue;
    const double breast = 1.3 / model.height_m.mean, radius = 1.0 / model.crown_per_trunk;
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      for (int variation = 0; variation < kMeshVariations; ++variation) {
        const Mesh mesh = BuildMesh(model, 1.0, detail, variation);
        int ring = 0;
        for (const auto& v : mesh.vertices) {
          const double off = std::hypot(v.x(), v.y());
          if (std::abs(v.z() - breast) < 0.06 * breast && std::abs(off - radius) < 0.1 * radius) {
            ++ring;
          }
        }
        EXPECT_GE(ring, 3) << model.name << ", detail " << detail << ", variation " << variation;
      }
    }
  }
}

// Edges of the triangles of a part that no neighbour shares turned round, with both ends above the
// ground; blades are left out: pieces of at most three triangles.
int OpenEdges(const Mesh& mesh, MeshPart part) {
  using Corner = std::tuple<float, float, float>;
  const auto corner = [&](std::uint32_t i) {
    const auto& v = mesh.vertices[i];
    return Corner(v.x(), v.y(), v.z());
  };
  std::vector<std::size_t> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.parts[t] == part) triangles.push_back(t);
  }
  // Pieces, by shared vertices.
  std::vector<std::uint32_t> leader(mesh.vertices.size());
  std::iota(leader.begin(), leader.end(), 0u);
  const std::function<std::uint32_t(std::uint32_t)> find = [&](std::uint32_t v) {
    while (leader[v] != v) v = leader[v] = leader[leader[v]];
    return v;
  };
  for (const std::size_t t : triangles) {
    leader[find(mesh.triangles[t][1])] = find(mesh.triangles[t][0]);
    leader[find(mesh.triangles[t][2])] = find(mesh.triangles[t][0]);
  }
  std::map<std::uint32_t, int> sizes;
  for (const std::size_t t : triangles) ++sizes[find(mesh.triangles[t][0])];
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const std::size_t t : triangles) {
    if (sizes[find(mesh.triangles[t][0])] <= 3) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      if (mesh.vertices[a].z() < 0.0f && mesh.vertices[b].z() < 0.0f) continue;
      ++edges[{corner(a), corner(b)}];
      --edges[{corner(b), corner(a)}];
    }
  }
  int open = 0;
  for (const auto& [edge, count] : edges) open += count > 0 ? count : 0;
  return open;
}

TEST(MeshTest, WoodAndStonesAreClosed) {
  ForEveryMesh([](const AssetModel& model, double, int, int, const Mesh& mesh) {
    // Herbs have blades for stems.
    if (model.kind == AssetKind::kTree || model.kind == AssetKind::kBush ||
        model.kind == AssetKind::kDeadBranch) {
      EXPECT_EQ(OpenEdges(mesh, MeshPart::kBark), 0);
    }
    EXPECT_EQ(OpenEdges(mesh, MeshPart::kStone) * (model.kind == AssetKind::kStone), 0);
  });
}

// How much more often a ray goes out of the mesh than into it.
int SignedCrossings(const Mesh& mesh, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& direction) {
  int crossings = 0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3f a = mesh.vertices[triangle[0]] - from,
                          b = mesh.vertices[triangle[1]] - from,
                          c = mesh.vertices[triangle[2]] - from;
    const float x = direction.dot(a.cross(b)), y = direction.dot(b.cross(c)),
                z = direction.dot(c.cross(a));
    if (!((x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0))) continue;
    if (direction.dot((b - a).cross(c - a)) * a.dot((b - a).cross(c - a)) <= 0.0f) continue;
    crossings += direction.dot((b - a).cross(c - a)) > 0.0f ? 1 : -1;
  }
  return crossings;
}

TEST(MeshTest, HousesAndStonesAreClosedAndFaceOutwards) {
  // From the middle each ray upwards or sideways leaves through one surface more than it enters.
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (!model.is_house() && model.kind != AssetKind::kStone) continue;
    for (int detail = 0; detail < kMeshDetails; ++detail) {
      for (int variation = 0; variation < kMeshVariations; ++variation) {
        const Mesh mesh = BuildMesh(model, 1.0, detail, variation);
        for (int i = 0; i < 60; ++i) {
          const double angle = 2.399963 * i, z = (i + 0.5) / 60.0;
          const Eigen::Vector3f direction(
              static_cast<float>(std::cos(angle) * std::sqrt(1.0 - z * z)),
              static_cast<float>(std::sin(angle) * std::sqrt(1.0 - z * z)), static_cast<float>(z));
          EXPECT_GE(SignedCrossings(mesh, {0.0137f, 0.0071f, 0.2f}, direction), 1)
              << model.name << ", detail " << detail << ", variation " << variation;
        }
      }
    }
  }
}

TEST(MeshTest, TreesStandOnOneTrunkBelowTheirCrown) {
  for (const AssetModel& model : Catalogue::BuiltIn()->models()) {
    if (model.kind != AssetKind::kTree || model.crown_base < 0.15) continue;
    const Mesh mesh = BuildMesh(model, 1.0, 0, 3);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& v = mesh.vertices[mesh.triangles[t][0]];
      if (v.z() > 0.45f * model.crown_base) continue;
      EXPECT_EQ(mesh.parts[t], MeshPart::kBark) << model.name;
      EXPECT_LT(std::hypot(v.x(), v.y()), 2.0 / model.crown_per_trunk) << model.name;
    }
  }
}

TEST(MeshTest, TheCrownsFormFollowsTheModelsNumbers) {
  AssetModel model = FirstOf(Shape::kBroadleafTree);
  const auto lowest_leaf = [&] {
    const Mesh mesh = BuildMesh(model, 1.0, 0, 0);
    float lowest = 1.0f;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.parts[t] != MeshPart::kLeaves) continue;
      lowest = std::min(lowest, mesh.vertices[mesh.triangles[t][0]].z());
    }
    return lowest;
  };
  model.crown_base = 0.1;
  const float low = lowest_leaf();
  model.crown_base = 0.6;
  EXPECT_GT(lowest_leaf(), low + 0.3f);
}

TEST(MeshTest, BlocksHaveTheirStoreysAndDoorsFaceTheFront) {
  AssetModel model = FirstOf(Shape::kFlatBlock);
  const auto window_levels = [&] {
    const Mesh mesh = BuildMesh(model, 1.0, 0, 0);
    std::map<int, int> levels;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.parts[t] != MeshPart::kWindow) continue;
      ++levels[static_cast<int>(
          std::lround(1000.0f * std::min({mesh.vertices[mesh.triangles[t][0]].z(),
                                          mesh.vertices[mesh.triangles[t][1]].z(),
                                          mesh.vertices[mesh.triangles[t][2]].z()})))];
    }
    return levels.size();
  };
  for (const int storeys : {2, 4, 6}) {
    model.height_m.mean = 3.0 * storeys + 0.9;
    model.storey_m = 3.0;
    EXPECT_EQ(window_levels(), static_cast<std::size_t>(storeys));
  }
  for (const AssetModel& building : Catalogue::BuiltIn()->models()) {
    if (!building.is_house()) continue;
    const Mesh mesh = BuildMesh(building, 1.0, 0, 0);
    EXPECT_GT(Count(mesh, MeshPart::kDoor), 0u) << building.name;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.parts[t] != MeshPart::kDoor) continue;
      EXPECT_GT(mesh.vertices[mesh.triangles[t][0]].x(), 0.5f) << building.name;
    }
  }
}

TEST(MeshTest, ModelsOfUsersWithOddNumbersAreSoundToo) {
  for (const auto& shape : EnumNames(Shape{})) {
    AssetModel model = FirstOf(shape.value);
    for (const double size : {0.05, 1.0, 60.0}) {
      for (const double form : {0.0, 1.0}) {
        model.name = "odd";
        model.height_m.mean = size;
        model.spread.mean = form == 0.0 ? 0.05 : 8.0;
        model.half_length_m.mean = form == 0.0 ? 1.0 : 40.0;
        model.half_width_m.mean = form == 0.0 ? 40.0 : 1.0;
        model.crown_base = 0.9 * form;
        model.crown_widest = form;
        model.droop = 2.0 * form - 1.0;
        model.crown_per_trunk = form == 0.0 ? 0.0 : 100.0;
        model.storey_m = form == 0.0 ? 0.0 : 0.5;
        for (int detail = 0; detail < kMeshDetails; ++detail) {
          const Mesh mesh = BuildMesh(model, 0.5, detail, 0);
          EXPECT_FALSE(mesh.triangles.empty()) << shape.name;
          for (const auto& v : mesh.vertices) {
            ASSERT_TRUE(v.allFinite()) << shape.name << " of " << size << " m";
            ASSERT_LE(v.cwiseAbs().maxCoeff(), 1.0f) << shape.name << " of " << size << " m";
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace latticeworld
