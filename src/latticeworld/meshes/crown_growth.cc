#include "latticeworld/meshes/crown_growth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "latticeworld/meshes/plant_parts.h"

namespace latticeworld {
namespace {

class CrownGrower {
 public:
  CrownGrower(const Branching& wood, std::size_t trunk_nodes, const Crown& crown,
              const CrownStyle& style, MeshBuilder* builder)
      : wood_(wood), trunk_nodes_(trunk_nodes), crown_(crown), style_(style), builder_(builder) {}

  // Sprays of leaves around the outer wood, turned outwards and up, unevenly.
  void AddLeaves(int count, RandomStream* random) {
    for (int i = 0; i < count; ++i) {
      const Vec3 off = DrawDirection(random) * std::cbrt(Draw(random, 0.0, 1.0));
      const Vec3 centre = Node(random) + style_.parts.clump * crown_.size_m() * off;
      Vec3 outward = centre - crown_.centre_m();
      outward.z() *= 0.6f;
      const Vec3 normal = 0.8f * outward / (outward.norm() + 1e-6f) + 0.5f * off +
                          0.25f * Vec3::UnitZ() + 0.7f * DrawDirection(random);
      builder_->BeginSpray();
      AddLeafTriangle(centre, normal / (normal.norm() + 1e-6f), Leaf_m(), random, MeshPart::kLeaves,
                      builder_);
    }
  }

  // Tufts of needles that stand up from the outer wood, three triangles a tuft.
  void AddTufts(int count, RandomStream* random) {
    for (int i = 0; i < count; ++i) {
      Vec3 off = DrawDirection(random) * std::cbrt(Draw(random, 0.0, 1.0));
      off.z() *= 0.35f;
      const Vec3 foot = Node(random) + style_.parts.clump * crown_.size_m() * off;
      builder_->BeginSpray();
      for (int k = 0; k < 3; ++k) {
        Vec3 way = DrawDirection(random) + 0.55f * Vec3::UnitZ();
        way *= Leaf_m() * Draw(random, 0.8, 1.3) / (way.norm() + 1e-6f);
        Vec3 side = way.cross(DrawDirection(random));
        side *= 0.27f * Leaf_m() / (side.norm() + 1e-6f);
        builder_->AddTriangle(foot - 0.2f * way, foot + way + side, foot + way - side,
                              MeshPart::kLeaves);
      }
    }
  }

  // Bare twigs: slender blades that leave the outer wood.
  void AddTwigs(int count, float rise, RandomStream* random) {
    const float width_m = style_.parts.twig_width * crown_.size_m();
    for (int i = 0; i < count; ++i) {
      const std::size_t node = NodeIndex(random);
      const Vec3 parent = wood_.nodes_m[static_cast<std::size_t>(wood_.parents[node])];
      const Vec3 base = parent + Draw(random, 0.2, 1.0) * (wood_.nodes_m[node] - parent);
      const Vec3 outward = base - crown_.centre_m();
      Vec3 way =
          outward / (outward.norm() + 1e-6f) + 0.9f * DrawDirection(random) + rise * Vec3::UnitZ();
      way *= Draw(random, 0.5, 1.2) * style_.parts.twig * crown_.size_m() / (way.norm() + 1e-6f);
      Vec3 side = way.cross(DrawDirection(random));
      side *= width_m / (side.norm() + 1e-6f);
      builder_->AddTriangle(base + side, base - side, base + way, MeshPart::kBark);
    }
  }

 private:
  std::size_t NodeIndex(RandomStream* random) const {
    return static_cast<std::size_t>(random->UniformInt(static_cast<int>(trunk_nodes_),
                                                       static_cast<int>(wood_.nodes_m.size()) - 1));
  }
  const Vec3& Node(RandomStream* random) const { return wood_.nodes_m[NodeIndex(random)]; }
  float Leaf_m() const { return style_.parts.leaf * crown_.size_m(); }

  const Branching& wood_;
  std::size_t trunk_nodes_;
  const Crown& crown_;
  const CrownStyle& style_;
  MeshBuilder* builder_;
};

}  // namespace

void AddCrown(const Branching& wood, std::size_t trunk_nodes, const Crown& crown,
              const CrownStyle& style, const ShapeInput& input, MeshBuilder* builder) {
  const CrownParts& parts = style.parts;
  // Streams of their own: the leaves are the same however bare the crown is.
  RandomStream leaves = input.random, twigs = input.random;
  const auto bare = static_cast<float>(1.0 - input.foliage);
  BranchTubes tubes;
  tubes.thick_m = style.thick_m;
  tubes.skip_nodes = static_cast<int>(trunk_nodes);
  tubes.most = parts.wood;
  builder->Reserve(
      static_cast<std::size_t>(parts.wood + parts.blades + parts.leaves + parts.twigs));
  AddBranches(wood, tubes, builder);
  CrownGrower grower(wood, trunk_nodes, crown, style, builder);
  const int twig_count = static_cast<int>(std::lround(bare * static_cast<float>(parts.twigs)));
  tubes.most = parts.blades;
  AddBranchBlades(wood, tubes, parts.blade_width * crown.size_m(), builder);
  grower.AddTwigs(twig_count, static_cast<float>(0.35 - 0.9 * input.model.droop), &twigs);
  if (style.needles) {
    grower.AddTufts(parts.leaves / 3, &leaves);
  } else {
    grower.AddLeaves(parts.leaves, &leaves);
  }
}

}  // namespace latticeworld
