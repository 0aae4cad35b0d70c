#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "latticeworld/meshes/crown_growth.h"
#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"
#include "latticeworld/meshes/trunk.h"

namespace latticeworld {
namespace {

// A crown that is widest further up than this is no cone but a cloud of tufts, like a pine's.
constexpr double kCone = 0.2;

// How much of what a cone of boughs has, by detail.
struct ConeParts {
  int whorls;   // rings of boughs
  int boughs;   // of a ring
  int sprays;   // of needles along either side of a bough
  int needles;  // triangles of a spray
  int hanging;  // sprays below it
  float size;   // of what hangs and ends, times the finest
};

struct Bough {
  Vec3 base_m, middle_m, tip_m;  // bent: a parabola

  Vec3 At(float share) const {
    const float rest = 1.0f - share;
    return rest * rest * base_m + 2.0f * rest * share * middle_m + share * share * tip_m;
  }
};

class ConeGrower {
 public:
  ConeGrower(const ConeParts& parts, float droop, float radius_m, RandomStream* random,
             MeshBuilder* builder)
      : parts_(parts), droop_(droop), radius_m_(radius_m), random_(random), builder_(builder) {}

  void AddBough(const Bough& bough) {
    const Vec3 way = bough.tip_m - bough.base_m;
    const float length_m = way.norm();
    const Vec3 along = way / length_m;
    const Vec3 side = Vec3(-way.y(), way.x(), 0.0f).normalized();
    const float wood_m = 0.02f * length_m;
    if (parts_.sprays > 0) {
      builder_->AddTube({bough.base_m, bough.At(0.85f)}, {wood_m, 0.0f}, 3, MeshPart::kBark);
    } else {
      const Vec3 half = 2.4f * wood_m * (Vec3::UnitZ() + side).normalized();
      builder_->AddTriangle(bough.base_m + half, bough.base_m - half, bough.At(0.9f),
                            MeshPart::kBark);
    }
    for (int i = 0; i < parts_.sprays; ++i) {
      const float share = (static_cast<float>(i) + 0.45f) / static_cast<float>(parts_.sprays);
      for (const float hand : {-1.0f, 1.0f}) AddSpray(bough, along, hand * side, length_m, share);
    }
    for (int i = 0; i < parts_.hanging; ++i) {
      AddHanging(
          bough, along, (i % 2 == 0 ? 1.0f : -1.0f) * side, length_m,
          (static_cast<float>(i) + Draw(random_, 0.2, 1.0)) / static_cast<float>(parts_.hanging));
    }
    const bool near = parts_.sprays > 0;
    Leaf end;
    end.base_m = bough.At(near ? 0.6f : 0.05f);
    end.tip_m = bough.tip_m;
    end.half_width_m = (near ? 0.1f * parts_.size : 0.9f) * length_m;
    end.fold = -0.4f;
    builder_->BeginSpray();
    AddLeaf(end, MeshPart::kLeaves, builder_);
  }

 private:
  // Needles along a twig to one side, shorter towards the tip of the bough, which hangs a little:
  // arrowheads, each beginning within the one before.
  void AddSpray(const Bough& bough, const Vec3& along, const Vec3& side, float length_m,
                float share) {
    const Vec3 root = bough.At(0.08f + 0.85f * share);
    const float reach_m = length_m * (0.5f - 0.3f * share) * Draw(random_, 0.8, 1.2);
    const Vec3 out =
        (side + 0.8f * along - (0.2f + 0.5f * droop_) * Draw(random_, 0.3, 1.5) * Vec3::UnitZ())
            .normalized();
    builder_->BeginSpray();
    if (parts_.needles == 1) {
      const Vec3 back = root - 0.1f * length_m * along;
      const Vec3 front = root + 0.55f * reach_m * along + 0.1f * reach_m * side;
      builder_->AddTriangle(back, front, root + reach_m * out, MeshPart::kLeaves);
      return;
    }
    const Vec3 across = (along - along.dot(out) * out).normalized();
    for (int i = 0; i < parts_.needles; ++i) {
      const float from = static_cast<float>(i) / static_cast<float>(parts_.needles);
      const float step = 1.5f / static_cast<float>(parts_.needles);
      const float half_m = reach_m * (0.26f - 0.14f * from) * Draw(random_, 0.8, 1.2);
      const Vec3 foot = root + from * reach_m * out;
      const Vec3 bend = Draw(random_, -0.06, 0.02) * reach_m * Vec3::UnitZ();
      builder_->AddTriangle(foot - half_m * across + bend, foot + half_m * across + bend,
                            root + std::min(1.1f, from + step) * reach_m * out, MeshPart::kLeaves);
    }
  }

  // A twig that hangs from the bough, which many do like a curtain.
  void AddHanging(const Bough& bough, const Vec3& along, const Vec3& side, float length_m,
                  float share) {
    const float spread_m = 0.3f * length_m * (1.0f - 0.6f * share) * Draw(random_, 0.0, 1.0);
    const Vec3 top = bough.At(0.15f + 0.8f * share) + spread_m * side;
    const Vec3 half = 0.095f * parts_.size * length_m * (along + 0.5f * side).normalized();
    const float hang_m = (0.16f + 0.14f * droop_) * std::max(length_m, 0.45f * radius_m_) *
                         Draw(random_, 0.7, 1.3) * std::sqrt(parts_.size);
    builder_->BeginSpray();
    builder_->AddTriangle(top - half, Vec3(top + 0.2f * half - hang_m * Vec3::UnitZ()), top + half,
                          MeshPart::kLeaves);
  }

  const ConeParts& parts_;
  float droop_, radius_m_;
  RandomStream* random_;
  MeshBuilder* builder_;
};

// The cone's radius at a height and in a direction: a little full, a little uneven.
float ConeRadius_m(const Crown& crown, float z_m, double angle_rad) {
  const float share = (z_m - crown.base_m) / (crown.top_m - crown.base_m);
  const auto uneven = static_cast<float>(std::sin(3.0 * angle_rad + crown.phases_rad[0]) +
                                         std::sin(2.0 * angle_rad + crown.phases_rad[1]));
  return crown.radius_m * (std::pow(std::max(0.0f, 1.0f - share), 0.85f) + 0.02f) *
         (0.94f + 0.03f * uneven);
}

void AddCone(const Crown& crown, const ShapeInput& input, RandomStream* random,
             MeshBuilder* builder) {
  constexpr std::array<ConeParts, kMeshDetails> kParts = {
      {{24, 7, 7, 4, 14, 0.8f}, {15, 6, 4, 1, 6, 2.1f}, {11, 5, 0, 0, 2, 4.8f}}};
  const ConeParts& parts = kParts[static_cast<std::size_t>(input.detail)];
  const auto droop = static_cast<float>(input.model.droop);
  const float length_m = crown.top_m - crown.base_m;
  ConeGrower grower(parts, droop, crown.radius_m, random, builder);
  double start = 0.0;
  for (int whorl = 0; whorl < parts.whorls; ++whorl) {
    start += kGoldenAngle_rad;
    for (int i = 0; i < parts.boughs; ++i) {
      const double angle = start + 2.0 * M_PI * i / parts.boughs + random->Uniform(-0.25, 0.25);
      // Closer together towards the top, where boughs are short.
      const float left = 1.0f - (static_cast<float>(whorl) + Draw(random, 0.0, 0.8)) / parts.whorls;
      const float share = 1.0f - std::pow(left, 1.25f);
      const float z_m = crown.base_m + std::min(0.96f, share) * length_m;
      const float reach_m = ConeRadius_m(crown, z_m, angle) * Draw(random, 0.85, 1.05);
      // Upper boughs reach up, lower ones hang under their weight.
      const float rise = 0.2f - 0.45f * droop * (1.0f - share) + 0.25f * share;
      Bough bough;
      bough.base_m = z_m * Vec3::UnitZ();
      bough.tip_m = reach_m * Heading(angle) +
                    std::clamp(z_m + rise * reach_m, 0.015f * crown.top_m, 0.985f * crown.top_m) *
                        Vec3::UnitZ();
      bough.middle_m =
          0.5f * (bough.base_m + bough.tip_m) - 0.15f * reach_m * (0.3f + droop) * Vec3::UnitZ();
      grower.AddBough(bough);
    }
  }
  // The leading shoot.
  for (const Vec3& up : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
    Leaf leader;
    leader.base_m = crown.top_m * 0.92f * Vec3::UnitZ();
    leader.tip_m = crown.top_m * Vec3::UnitZ();
    leader.up = up;
    leader.half_width_m = 0.06f * crown.radius_m;
    leader.widest = 0.25f;
    builder->BeginSpray();
    AddLeaf(leader, MeshPart::kLeaves, builder);
  }
}

void AddCloud(const Crown& crown, const Trunk& trunk, const ShapeInput& input, RandomStream* random,
              MeshBuilder* builder) {
  constexpr std::array<CrownParts, kMeshDetails> kParts = {
      {{2000, 0, 0.0f, 12000, 0.05f, 0.17f, 4500, 0.16f, 0.0018f},
       {300, 40, 0.008f, 1500, 0.135f, 0.17f, 700, 0.2f, 0.0055f},
       {0, 62, 0.016f, 168, 0.3f, 0.16f, 120, 0.36f, 0.016f}}};
  const float trunk_m = crown.radius_m * TrunkShare(input.model);
  const std::vector<Vec3> points = crown.Fill(120, 0.4f, random);
  Branching wood = GrowBranching(trunk.axis_m, trunk.lengths_m, points, 0.15f);
  ThickenBranching(0.8f * trunk_m, &wood);
  SmoothBranching(static_cast<int>(trunk.axis_m.size()), &wood);
  CrownStyle style;
  style.parts = kParts[static_cast<std::size_t>(input.detail)];
  style.needles = true;
  style.thick_m = 0.35f * trunk_m;
  AddCrown(wood, trunk.axis_m.size(), crown, style, input, builder);
}

}  // namespace

void BuildConiferTree(ShapeInput input, MeshBuilder* builder) {
  const AssetModel& model = input.model;
  RandomStream* random = &input.random;
  const float height_m = input.size_m.z(), radius_m = input.size_m.x();
  const bool cone = model.crown_widest < kCone;
  const float base_m = static_cast<float>(model.crown_base) * height_m * Draw(random, 0.9, 1.1);
  const Trunk trunk = DrawTrunk(height_m, base_m, (cone ? 0.98f : 0.9f) * height_m, random);
  const Crown crown = DrawCrown(base_m, height_m * (cone ? 1.0f : 0.97f), 0.94f * radius_m,
                                static_cast<float>(model.crown_widest), 0.2f, random);
  if (cone) {
    AddCone(crown, input, random, builder);
  } else {
    AddCloud(crown, trunk, input, random, builder);
  }
  builder->FitToUnitBox();
  AddFittedTrunk(trunk, height_m, TrunkShare(model), input.detail, builder);
}

}  // namespace latticeworld
