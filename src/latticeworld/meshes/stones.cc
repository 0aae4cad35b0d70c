#include <algorithm>
#include <cmath>

#include "latticeworld/meshes/icosphere.h"
#include "latticeworld/meshes/plant_parts.h"
#include "latticeworld/meshes/shapes.h"

namespace latticeworld {
namespace {

// A body bounded by planes, `facets` of them, with rounded edges: how stones break. Its distance
// from the middle in a direction.
struct Rock {
  std::vector<Vec3> normals;
  std::vector<float> offsets;
  float sharpness = 10.0f;

  float Radius(const Vec3& direction) const {
    // A smooth minimum over the planes.
    float sum = 0.0f;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const float facing = std::max(0.0f, normals[i].dot(direction)) / offsets[i];
      sum += std::pow(facing, sharpness);
    }
    return 1.0f / std::pow(std::max(sum, 1e-6f), 1.0f / sharpness);
  }
};

void AddRock(const Rock& rock, float roughness, float squat, int detail, RandomStream* random,
             MeshBuilder* builder) {
  const Vec3 waves[2] = {7.0f * DrawDirection(random), 11.0f * DrawDirection(random)};
  const Icosphere sphere = MakeIcosphere(2 - detail);
  for (const Vec3& v : sphere.vertices) {
    const float bumps = 1.0f + roughness * (std::sin(waves[0].dot(v) * 1.3f) +
                                            0.6f * std::sin(waves[1].dot(v) + 1.0f));
    Vec3 p = std::clamp(rock.Radius(v), 0.4f, 1.6f) * bumps * v;
    // Sunk into the ground by its lower part, which does not narrow again.
    if (v.z() < 0.0f) {
      const float spread = 1.0f / std::sqrt(1.0f - 0.75f * v.z() * v.z());
      p.x() *= spread;
      p.y() *= spread;
    }
    p.z() = std::max(p.z() * 0.6f + squat, -0.08f + 0.02f * v.x());
    builder->AddVertex(p);
  }
  for (const auto& t : sphere.triangles) {
    builder->AddTriangle(t[0], t[1], t[2], MeshPart::kStone);
  }
  builder->FitToUnitBox();
}

}  // namespace

void BuildBoulder(ShapeInput input, MeshBuilder* builder) {
  Rock rock;
  rock.sharpness = 7.0f;
  for (int i = 0; i < 16; ++i) {
    rock.normals.push_back(DrawDirection(&input.random));
    rock.offsets.push_back(Draw(&input.random, 0.75, 1.05));
  }
  AddRock(rock, 0.025f, 0.38f, input.detail, &input.random, builder);
}

void BuildSlab(ShapeInput input, MeshBuilder* builder) {
  Rock rock;
  rock.sharpness = 16.0f;
  // Level beds above and below, steep breaks around.
  rock.normals = {(Vec3::UnitZ() + 0.12f * DrawDirection(&input.random)).normalized(),
                  -Vec3::UnitZ()};
  rock.offsets = {0.5f, 0.6f};
  const int breaks = input.random.UniformInt(5, 7);
  for (int i = 0; i < breaks; ++i) {
    const double angle = 2.0 * M_PI * (i + input.random.Uniform(-0.25, 0.25)) / breaks;
    rock.normals.push_back(
        (Heading(angle) + Draw(&input.random, -0.15, 0.25) * Vec3::UnitZ()).normalized());
    rock.offsets.push_back(Draw(&input.random, 0.75, 1.0));
  }
  AddRock(rock, 0.012f, 0.25f, input.detail, &input.random, builder);
}

}  // namespace latticeworld
