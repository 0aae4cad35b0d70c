#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {
namespace {

// A slender diamond of two crossed leaves, or of one.
void AddEar(const Vec3& foot_m, const Vec3& tip_m, float half_width_m, bool crossed,
            MeshBuilder* builder) {
  builder->BeginSpray();
  Leaf ear;
  ear.base_m = foot_m;
  ear.tip_m = tip_m;
  ear.half_width_m = half_width_m;
  ear.widest = 0.45f;
  ear.fold = 0.0f;
  for (const Vec3& up : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
    ear.up = up;
    AddLeaf(ear, MeshPart::kBlossom, builder);
    if (!crossed) return;
  }
}

}  // namespace

void BuildCereal(ShapeInput input, MeshBuilder* builder) {
  struct Stalks {
    int count, leaves;
    float half_width, ear;  // shares of the height
  };
  constexpr std::array<Stalks, kMeshDetails> kStalks = {
      {{14, 1, 0.006f, 0.02f}, {5, 0, 0.012f, 0.045f}, {1, 2, 0.016f, 0.05f}}};
  const Stalks& stalks = kStalks[static_cast<std::size_t>(input.detail)];
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const double start = random->Uniform(0.0, 2.0 * M_PI);
  for (int i = 0; i < stalks.count; ++i) {
    const float share = stalks.count == 1 ? 0.0f : std::sqrt((i + 0.5f) / stalks.count);
    const Vec3 heading = Heading(start + kGoldenAngle_rad * i);
    const Vec3 base = 0.6f * share * radius_m * heading - 0.03f * height_m * Vec3::UnitZ();
    const Vec3 top =
        0.8f * share * radius_m * heading + height_m * Draw(random, 0.78, 0.86) * Vec3::UnitZ();
    if (stalks.count > 1) {
      AddBlade({base, top}, stalks.half_width * height_m,
               LeftOf(Heading(random->Uniform(0.0, 2.0 * M_PI))), MeshPart::kBark, builder);
    }
    const Vec3 tip = top + height_m * (0.14f * Vec3::UnitZ() + 0.05f * heading);
    AddEar(top - 0.02f * height_m * Vec3::UnitZ(), tip, stalks.ear * height_m, false, builder);
    for (int k = 0; k < stalks.leaves; ++k) {
      const Vec3 way = stalks.count > 1 ? Heading(random->Uniform(0.0, 2.0 * M_PI))
                                        : Heading(M_PI * (k + 0.25) + random->Uniform(-0.3, 0.3));
      const float root = stalks.count > 1 ? 0.4f : 0.0f;
      builder->BeginSpray();
      AddBlade(BladePath(base + root * (top - base), way, 0.35f * height_m, 0.35f, 1.3f, 2),
               2.0f * stalks.half_width * height_m, LeftOf(way), MeshPart::kLeaves, builder);
    }
  }
  builder->FitToUnitBox();
}

void BuildMaize(ShapeInput input, MeshBuilder* builder) {
  struct Parts {
    int leaves, points, tassels;
    float half_width;  // of leaves, share of the height
  };
  constexpr std::array<Parts, kMeshDetails> kParts = {
      {{11, 4, 3, 0.018f}, {6, 3, 1, 0.03f}, {2, 2, 1, 0.028f}}};
  const Parts& parts = kParts[static_cast<std::size_t>(input.detail)];
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const double start = random->Uniform(0.0, 2.0 * M_PI);
  const Vec3 base = -0.03f * height_m * Vec3::UnitZ(), top = 0.88f * height_m * Vec3::UnitZ();
  AddBlade({base, top}, 0.014f * height_m * (1.0f + 0.6f * input.detail), Vec3::UnitX(),
           MeshPart::kBark, builder);
  if (input.detail == 0) {
    AddBlade({base, top}, 0.014f * height_m, Vec3::UnitY(), MeshPart::kBark, builder);
  }
  for (int i = 0; i < parts.leaves; ++i) {
    // Leaves stand in two rows.
    const float share = (static_cast<float>(i) + 0.7f) / (static_cast<float>(parts.leaves) + 1.2f);
    const Vec3 way = Heading(start + M_PI * i + random->Uniform(-0.9, 0.9));
    const float length_m =
        std::hypot(radius_m, 0.3f * height_m) * 1.15f * (1.0f - 0.7f * std::abs(share - 0.4f));
    builder->BeginSpray();
    AddBlade(BladePath(share * top, way, length_m, 0.3f, 1.6f, parts.points),
             parts.half_width * height_m, LeftOf(way), MeshPart::kLeaves, builder);
  }
  for (int i = 0; i < parts.tassels; ++i) {
    const Vec3 way = Heading(start + kGoldenAngle_rad * i);
    builder->BeginSpray();
    AddBlade({top, top + 0.12f * height_m * (Vec3::UnitZ() + (i == 0 ? 0.0f : 0.45f) * way)},
             0.012f * height_m * (1.0f + 0.8f * input.detail), LeftOf(way), MeshPart::kBlossom,
             builder);
  }
  // Cobs between the leaves.
  for (int i = 0; i < (input.detail == 0 ? 2 : 0); ++i) {
    const Vec3 way = Heading(start + 1.3 + 2.2 * i);
    const Vec3 foot = (0.42f + 0.09f * static_cast<float>(i)) * top;
    AddEar(foot, foot + 0.13f * height_m * (Vec3::UnitZ() + 0.4f * way), 0.022f * height_m, true,
           builder);
  }
  builder->FitToUnitBox();
}

void BuildRapeseed(ShapeInput input, MeshBuilder* builder) {
  struct Parts {
    int stems, leaves, blossoms;
    float leaf, blossom;  // half widths, shares of the height
  };
  constexpr std::array<Parts, kMeshDetails> kParts = {
      {{5, 9, 45, 0.04f, 0.042f}, {3, 3, 10, 0.07f, 0.09f}, {1, 1, 2, 0.08f, 0.135f}}};
  const Parts& parts = kParts[static_cast<std::size_t>(input.detail)];
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const double start = random->Uniform(0.0, 2.0 * M_PI);
  std::vector<Vec3> tops;
  for (int i = 0; i < parts.stems; ++i) {
    const Vec3 heading = Heading(start + kGoldenAngle_rad * i);
    const float share = parts.stems == 1 ? 0.0f : std::sqrt((i + 0.3f) / parts.stems);
    tops.push_back(0.75f * share * radius_m * heading +
                   height_m * Draw(random, 0.78, 0.9) * Vec3::UnitZ());
    AddBlade({-0.03f * height_m * Vec3::UnitZ(), tops.back()},
             0.009f * height_m * (1.0f + input.detail), LeftOf(heading), MeshPart::kBark, builder);
  }
  for (int i = 0; i < parts.leaves; ++i) {
    const Vec3 way = Heading(start + 1.0 + kGoldenAngle_rad * i);
    const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(parts.leaves);
    const Vec3 root = 0.55f * share * tops[static_cast<std::size_t>(i % parts.stems)];
    builder->BeginSpray();
    AddBlade(
        {root, root + (0.8f - 0.4f * share) * radius_m * way + 0.05f * height_m * Vec3::UnitZ()},
        parts.leaf * height_m, LeftOf(way), MeshPart::kLeaves, builder);
  }
  for (int i = 0; i < parts.blossoms; ++i) {
    // Blossom covers the upper quarter of each stem.
    const Vec3& top = tops[static_cast<std::size_t>(i % parts.stems)];
    const Vec3 centre = top + Vec3(0.0f, 0.0f, -0.2f * height_m * Draw(random, 0.0, 1.0)) +
                        0.12f * radius_m * DrawDirection(random);
    builder->BeginSpray();
    AddLeafTriangle(centre, (DrawDirection(random) + 0.8f * Vec3::UnitZ()).normalized(),
                    parts.blossom * height_m, random, MeshPart::kBlossom, builder);
  }
  builder->FitToUnitBox();
}

}  // namespace latticeworld
