#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {
namespace {

// Plants wider than this for their height are cushions with spikes of small blossoms, like lavender
// and heather; others bear few large heads, like poppies and daisies.
constexpr double kCushion = 0.55;

struct Parts {
  int stems;
  int blossoms;  // triangles of a head or a spike
  int leaves;
  float stem_width;  // half, share of the height
  float head;        // share of the radius
  float leaf_width;  // half, share of the height
};

// Petals around a middle, facing along `up`.
void AddHead(const Vec3& centre_m, const Vec3& up, float radius_m, int petals, float cup,
             RandomStream* random, MeshBuilder* builder) {
  const Vec3 u = Vec3(Vec3::UnitY()).cross(up).normalized();
  const Vec3 v = up.cross(u);
  const double start = random->Uniform(0.0, 2.0 * M_PI);
  if (petals == 1)
    return AddLeafTriangle(centre_m, up, radius_m, random, MeshPart::kBlossom, builder);
  const double half = M_PI / petals;
  for (int i = 0; i < petals; ++i) {
    const double angle = start + 2.0 * M_PI * i / petals;
    // Each petal stands a little over the next.
    const auto edge = [&](double a, float rise) {
      return Vec3(centre_m + radius_m * (static_cast<float>(std::cos(a)) * u +
                                         static_cast<float>(std::sin(a)) * v + rise * up));
    };
    builder->AddTriangle(centre_m, edge(angle - half, cup), edge(angle + half, cup + 0.12f),
                         MeshPart::kBlossom);
  }
}

// A spike of blossoms along the upper part of a stem: crossed slender diamonds.
void AddSpike(const Vec3& foot_m, const Vec3& tip_m, float half_width_m, int triangles,
              MeshBuilder* builder) {
  Leaf spike;
  spike.base_m = foot_m;
  spike.tip_m = tip_m;
  spike.half_width_m = half_width_m;
  spike.widest = 0.35f;
  spike.fold = 0.0f;
  for (int i = 0; 2 * i < triangles; ++i) {
    spike.up = i == 0 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    AddLeaf(spike, MeshPart::kBlossom, builder);
  }
}

}  // namespace

void BuildFlower(ShapeInput input, MeshBuilder* builder) {
  constexpr std::array<Parts, kMeshDetails> kHeads = {{{5, 6, 5, 0.011f, 0.27f, 0.035f},
                                                       {4, 1, 2, 0.016f, 0.38f, 0.05f},
                                                       {2, 1, 2, 0.02f, 0.7f, 0.1f}}};
  constexpr std::array<Parts, kMeshDetails> kSpikes = {{{9, 4, 1, 0.008f, 0.09f, 0.02f},
                                                        {4, 2, 1, 0.014f, 0.16f, 0.04f},
                                                        {1, 2, 0, 0.0f, 0.45f, 0.0f}}};
  const bool cushion = input.model.spread.mean >= kCushion;
  const Parts& parts = (cushion ? kSpikes : kHeads)[static_cast<std::size_t>(input.detail)];
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const float cup = Draw(random, 0.2, 0.5);
  const double start = random->Uniform(0.0, 2.0 * M_PI);
  const float head_m = std::min(parts.head * radius_m, 0.4f * height_m);
  for (int i = 0; i < parts.stems; ++i) {
    const double angle = start + kGoldenAngle_rad * i + random->Uniform(-0.2, 0.2);
    const Vec3 heading = Heading(angle);
    const Vec3 side = LeftOf(heading);
    const float share =
        parts.stems == 1 ? 0.0f : std::sqrt((static_cast<float>(i) + 0.3f) / parts.stems);
    const Vec3 base = 0.3f * share * radius_m * heading - 0.03f * height_m * Vec3::UnitZ();
    // Cushions are domes; heads stand at all heights.
    const float high =
        cushion ? std::sqrt(1.0f - 0.6f * share * share) : (i == 0 ? 1.0f : Draw(random, 0.7, 1.0));
    const Vec3 top = (cushion ? 0.9f : 0.7f) * share * radius_m * heading +
                     high * (height_m - (cushion ? 0.0f : 0.6f * head_m)) * Vec3::UnitZ();
    const Vec3 tip = top + 0.1f * radius_m * Heading(random->Uniform(0.0, 2.0 * M_PI));
    if (parts.stem_width > 0.0f && (input.detail < 2 || i == 0)) {
      AddBlade({base, top}, parts.stem_width * height_m, side, MeshPart::kBark, builder);
    }
    builder->BeginSpray();
    if (cushion) {
      AddSpike(base + (input.detail < 2 ? 0.45f : 0.15f) * (top - base), tip, head_m,
               parts.blossoms, builder);
    } else {
      AddHead(top, (Vec3::UnitZ() + 0.45f * heading).normalized(), head_m, parts.blossoms, cup,
              random, builder);
    }
    if (cushion && input.detail == 2) {
      // The green below it.
      Leaf green;
      green.base_m = base;
      green.tip_m = base + 0.6f * (top - base);
      green.up = Vec3::UnitY();
      green.half_width_m = Draw(random, 0.5, 0.7) * radius_m;
      builder->BeginSpray();
      AddLeaf(green, MeshPart::kLeaves, builder);
    }
    const int leaves = input.detail < 2 ? parts.leaves : (i == 0 ? parts.leaves - !cushion : 0);
    for (int k = 0; k < leaves; ++k) {
      const Vec3 way = Heading(angle + kGoldenAngle_rad * (k + 1));
      const Vec3 root = base + 0.09f * static_cast<float>(k) * (top - base);
      const Vec3 end = root + (cushion ? 0.5f : 0.45f) * radius_m * way +
                       Draw(random, 0.1, cushion ? 0.35 : 0.2) * height_m * Vec3::UnitZ();
      builder->BeginSpray();
      AddBlade({root, end}, parts.leaf_width * height_m, LeftOf(way), MeshPart::kLeaves, builder);
    }
  }
  builder->FitToUnitBox();
}

}  // namespace latticeworld
