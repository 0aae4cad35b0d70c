#include "latticeworld/meshes/branching.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "latticeworld/meshes/plant_parts.h"

namespace latticeworld {
namespace {

constexpr float kPipeExponent = 2.3f;

// The way to a point from a node: what goes down or back towards the trunk counts as longer.
float GrowingWay(const Vec3& from_m, const Vec3& to_m) {
  const Vec3 way = to_m - from_m;
  const float length = way.norm();
  const Vec3 outward(from_m.x(), from_m.y(), 0.0f);
  const float outward_length = outward.norm();
  float along = way.z() / (length + 1e-6f) * 0.5f;
  if (outward_length > 1e-6f) along += way.dot(outward) / (length * outward_length + 1e-6f) * 0.5f;
  return length * (1.3f - 0.6f * along);
}

// The thickest child of each node; -1: none.
std::vector<int> MainChildren(const Branching& branching) {
  std::vector<int> main(branching.nodes_m.size(), -1);
  for (std::size_t i = 0; i < branching.nodes_m.size(); ++i) {
    const int parent = branching.parents[i];
    if (parent < 0) continue;
    int& best = main[static_cast<std::size_t>(parent)];
    if (best < 0 || branching.radii_m[i] > branching.radii_m[static_cast<std::size_t>(best)]) {
      best = static_cast<int>(i);
    }
  }
  return main;
}

// A branch from where it leaves its parent to its tip.
struct Chain {
  std::vector<Vec3> axis_m;
  std::vector<float> radii_m;  // 0 at the tip
};

// The branches that do not belong to the first nodes, the thickest first.
std::vector<Chain> ChainsOf(const Branching& branching, int skip_nodes) {
  const std::vector<int> main = MainChildren(branching);
  std::vector<Chain> chains;
  for (std::size_t i = static_cast<std::size_t>(skip_nodes); i < branching.nodes_m.size(); ++i) {
    const int parent = branching.parents[i];
    if (parent < 0) continue;
    if (parent >= skip_nodes && main[static_cast<std::size_t>(parent)] == static_cast<int>(i)) {
      continue;  // its parent's branch goes on into it
    }
    Chain chain;
    chain.axis_m.push_back(branching.nodes_m[static_cast<std::size_t>(parent)]);
    chain.radii_m.push_back(branching.radii_m[i]);
    for (auto node = static_cast<int>(i); node >= 0; node = main[static_cast<std::size_t>(node)]) {
      chain.axis_m.push_back(branching.nodes_m[static_cast<std::size_t>(node)]);
      const int next = main[static_cast<std::size_t>(node)];
      chain.radii_m.push_back(next >= 0 ? branching.radii_m[static_cast<std::size_t>(next)] : 0.0f);
    }
    chains.push_back(std::move(chain));
  }
  std::stable_sort(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) {
    return a.radii_m.front() > b.radii_m.front();
  });
  return chains;
}

}  // namespace

Branching GrowBranching(const std::vector<Vec3>& start_m, const std::vector<float>& start_lengths_m,
                        const std::vector<Vec3>& points_m, float balance) {
  Branching grown;
  grown.nodes_m = start_m;
  grown.lengths_m = start_lengths_m;
  for (std::size_t i = 0; i < start_m.size(); ++i) grown.parents.push_back(static_cast<int>(i) - 1);

  struct Open {
    int point;
    int from;
    float cost, length_m;
  };
  std::vector<Open> open;
  const auto offer = [&](int node, Open* to) {
    const auto n = static_cast<std::size_t>(node);
    const Vec3& point = points_m[static_cast<std::size_t>(to->point)];
    const float cost = GrowingWay(grown.nodes_m[n], point) + balance * grown.lengths_m[n];
    if (cost >= to->cost) return;
    to->cost = cost;
    to->from = node;
    to->length_m = grown.lengths_m[n] + (point - grown.nodes_m[n]).norm();
  };
  for (std::size_t i = 0; i < points_m.size(); ++i) {
    open.push_back({static_cast<int>(i), -1, std::numeric_limits<float>::max(), 0.0f});
    for (std::size_t n = 0; n < start_m.size(); ++n) offer(static_cast<int>(n), &open.back());
  }
  while (!open.empty()) {
    const auto best = std::min_element(
        open.begin(), open.end(), [](const Open& a, const Open& b) { return a.cost < b.cost; });
    const Open joined = *best;
    *best = open.back();
    open.pop_back();
    grown.nodes_m.push_back(points_m[static_cast<std::size_t>(joined.point)]);
    grown.parents.push_back(joined.from);
    grown.lengths_m.push_back(joined.length_m);
    for (Open& other : open) offer(static_cast<int>(grown.nodes_m.size()) - 1, &other);
  }
  grown.radii_m.assign(grown.nodes_m.size(), 0.0f);
  return grown;
}

void SmoothBranching(int fixed, Branching* branching) {
  const std::vector<int> main = MainChildren(*branching);
  const std::vector<Vec3> before = branching->nodes_m;
  for (std::size_t i = static_cast<std::size_t>(fixed); i < before.size(); ++i) {
    if (main[i] < 0) continue;
    branching->nodes_m[i] = 0.5f * before[i] +
                            0.25f * before[static_cast<std::size_t>(branching->parents[i])] +
                            0.25f * before[static_cast<std::size_t>(main[i])];
  }
}

void ThickenBranching(float foot_m, Branching* branching) {
  std::vector<float> pipes(branching->nodes_m.size(), 0.0f);
  float most = 0.0f;
  for (std::size_t i = pipes.size(); i-- > 0;) {
    if (pipes[i] == 0.0f) pipes[i] = 1.0f;
    if (branching->parents[i] >= 0) {
      pipes[static_cast<std::size_t>(branching->parents[i])] += pipes[i];
    }
    most = std::max(most, pipes[i]);
  }
  for (std::size_t i = 0; i < pipes.size(); ++i) {
    branching->radii_m[i] = foot_m * std::pow(pipes[i] / most, 1.0f / kPipeExponent);
  }
}

void AddBranches(const Branching& branching, const BranchTubes& tubes, MeshBuilder* builder) {
  int left = tubes.most;
  for (const Chain& chain : ChainsOf(branching, tubes.skip_nodes)) {
    const int sides = chain.radii_m.front() >= tubes.thick_m ? tubes.thick_sides : tubes.sides;
    const int segments = static_cast<int>(chain.axis_m.size()) - 1;
    const int triangles = sides * (2 * segments - 1) + sides - 2;
    if (triangles > left) continue;
    left -= triangles;
    builder->AddTube(chain.axis_m, chain.radii_m, sides, MeshPart::kBark);
  }
}

void AddBranchBlades(const Branching& branching, const BranchTubes& tubes, float least_half_width_m,
                     MeshBuilder* builder) {
  int left = tubes.most;
  for (const Chain& chain : ChainsOf(branching, tubes.skip_nodes)) {
    const std::size_t segments = chain.axis_m.size() - 1;
    std::vector<Vec3> path = {chain.axis_m.front()};
    if (segments > 1 && left >= 3) path.push_back(chain.axis_m[(segments + 1) / 2]);
    path.push_back(chain.axis_m.back());
    const int triangles = 2 * static_cast<int>(path.size()) - 3;
    if (triangles > left) break;
    left -= triangles;
    // Sides alternate between upright and level, so that all views see some of them.
    const Vec3 along = path.back() - path.front();
    Vec3 side = along.cross(left % 2 == 0 ? Vec3::UnitZ() : Vec3(along.y(), -along.x(), 0.1f));
    side /= side.norm() + 1e-6f;
    AddBlade(path, std::max(least_half_width_m, chain.radii_m.front()), side, MeshPart::kBark,
             builder);
  }
}

}  // namespace latticeworld
