#include "latticeworld/simulation/props/felling.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "latticeworld/scene/weather/water_depth.h"
#include "latticeworld/simulation/props/blows.h"
#include "latticeworld/simulation/props/tree_body.h"

namespace latticeworld {
namespace {

constexpr double kPushTime_s = 0.1;  // over which pushes are averaged
// Weights that a body pushes with for long: more than its grip on the ground bears. What a contact
// exerts to part two bodies that overlap can be far more.
constexpr double kMostPush = 2.0;
constexpr double kLeastPush_nm = 1.0;
// What comes faster is a blow, and its force in a step is as large as the step is short.
constexpr double kFastestPush_mps = 0.5;
// Rates that trees begin to fall with: a push leaves them some of its own.
constexpr double kSlowestFall_radps = 0.15, kFastestFall_radps = 1.0;
constexpr double kUpright = 0.7;  // cosine of a lean from which on nothing has come to rest yet
constexpr double kStill_mps = 0.1, kStill_radps = 0.05;
constexpr double kStill_s = 0.5;
constexpr double kLongestFall_s = 10.0;  // then it lies where it is, moving or not
constexpr double kMoved_m = 0.3;         // from its place of rest
constexpr double kDeepest_m = 5.0;       // below the ground: lost

}  // namespace

Felling::Felling(const Scene& scene, PhysicsWorld* physics) : scene_(scene), physics_(physics) {}

AssetPhysics Felling::PhysicsOfTree(std::uint32_t asset) const {
  return PhysicsOf(*scene_.catalogue, scene_.assets[asset]);
}

bool Felling::CanFall(std::uint32_t asset) const {
  return scene_.assets[asset].kind == AssetKind::kTree && state_.trees.count(asset) == 0 &&
         state_.trees.size() + falls_.size() < kMaxFelledTrees;
}

bool Felling::GivesWay(const Contact& contact) {
  if (contact.kind != ContactKind::kAsset) return false;
  if (falls_.count(contact.other) != 0) return true;
  if (!CanFall(contact.other)) return false;
  const Eigen::Vector2d level = contact.normal.head<2>();
  const double level_share = level.norm();
  const double approach_mps = contact.approach_mps * level_share;
  if (approach_mps <= 0.0) return false;
  const double mass_kg = HittingMass(*physics_, contact.body, contact.position_m, contact.normal);
  const AssetPhysics physics = PhysicsOfTree(contact.other);
  const double stiffness = StiffnessMet(mass_kg, physics.base_stiffness_nmprad);
  const double strength_nm = physics.failing_moment_nm();
  const double moment_nm = ImpactMoment(mass_kg, approach_mps, stiffness);
  if (moment_nm < strength_nm) return false;

  Fall fall;
  fall.by = contact.body;
  fall.moment_nm = -moment_nm * level / level_share;
  const double after_mps = SpeedAfterBreaking(mass_kg, approach_mps, stiffness, strength_nm);
  const double impulse_ns = mass_kg * (approach_mps - after_mps);
  const Eigen::Vector2d push_ns = impulse_ns * level / level_share;
  fall.impulse_ns = {push_ns.x(), push_ns.y(), 0.0};
  fall.point_m = contact.position_m;
  const BodySpec& spec = physics_->SpecOf(contact.body);
  if (IsDriven(spec)) {
    // The force acts at the height of the centre of mass: breaking a tree does not make the body
    // pitch.
    const BodyMotion motion = physics_->MotionOf(contact.body);
    fall.point_m.z() =
        (motion.position_m + motion.orientation * Eigen::Vector3d(0, 0, spec.center_height_m)).z();
  }
  const Asset& tree = scene_.assets[contact.other];
  const BodySpec body = TreeBodyOf(tree, physics);
  const double about_foot_kgm2 =
      body.inertia_kgm2.x() + body.mass_kg * body.center_height_m * body.center_height_m;
  const double height_m = std::max(0.0, contact.position_m.z() - tree.z_m);
  fall.rate_radps =
      std::clamp(impulse_ns * height_m / about_foot_kgm2, kSlowestFall_radps, kFastestFall_radps);
  falls_.emplace(contact.other, fall);
  return true;
}

void Felling::Act(const Atmosphere& atmosphere) {
  for (const auto& [asset, tree] : state_.trees) {
    if (tree.body == 0) continue;
    const Asset& stood = scene_.assets[asset];
    if (tree.at_rest && physics_->IsResting(tree.body)) {
      const Eigen::Vector3d middle = 0.5 * (tree.lies.foot_m + tree.lies.tip_m);
      if (WaterDepthAt(*scene_.terrain, atmosphere, {middle.x(), middle.y()}) <= 0.0) continue;
    } else if (!tree.at_rest) {
      const BodyMotion motion = physics_->MotionOf(tree.body);
      const Eigen::Vector3d force = RootForce(stood, physics_->SpecOf(tree.body), motion);
      if (!force.isZero(0.0)) physics_->AddForceAt(tree.body, force, motion.position_m);
      const Eigen::Vector3d torque = ToppleTorque(physics_->SpecOf(tree.body), motion, tree.toward);
      if (!torque.isZero(0.0)) physics_->AddTorque(tree.body, torque);
    }
    ActOfWater(*scene_.terrain, atmosphere, TreeBuoyancyOf(stood), tree.body, physics_);
  }
}

void Felling::Push(double step_s) {
  struct Step {
    Eigen::Vector2d moment_nm = Eigen::Vector2d::Zero();
    double largest_nm = 0.0;
    BodyId by = 0;
  };
  // Forces are summed by tree and body: what a body can push with is shared by all its contacts
  // with the tree.
  struct Pushed {
    Eigen::Vector2d force_n = Eigen::Vector2d::Zero();
    Eigen::Vector2d moment_nm = Eigen::Vector2d::Zero();
  };
  std::map<std::pair<std::uint32_t, BodyId>, Pushed> pushed;
  for (const Contact& contact : physics_->contacts()) {
    if (contact.kind != ContactKind::kAsset || contact.force_n.isZero(0.0) ||
        !contact.force_n.allFinite() || contact.approach_mps > kFastestPush_mps ||
        !CanFall(contact.other)) {
      continue;
    }
    const double height_m = contact.position_m.z() - scene_.assets[contact.other].z_m;
    if (height_m <= 0.0) continue;
    Pushed& one = pushed[{contact.other, contact.body}];
    one.force_n -= contact.force_n.head<2>();
    one.moment_nm -= height_m * contact.force_n.head<2>();
  }
  std::map<std::uint32_t, Step> now;
  for (const auto& [who, one] : pushed) {
    const double limit_n = kMostPush * kGravity_mps2 * physics_->SpecOf(who.second).total_mass_kg();
    const double force_n = one.force_n.norm();
    const Eigen::Vector2d moment_nm = (force_n > limit_n ? limit_n / force_n : 1.0) * one.moment_nm;
    Step& step = now[who.first];
    step.moment_nm += moment_nm;
    if (moment_nm.norm() <= step.largest_nm) continue;
    step.largest_nm = moment_nm.norm();
    step.by = who.second;
  }
  const double keep = std::exp(-step_s / kPushTime_s);
  for (auto it = state_.pushes.begin(); it != state_.pushes.end();) {
    it->second *= keep;
    const bool over = it->second.norm() < kLeastPush_nm && now.count(it->first) == 0;
    it = over ? state_.pushes.erase(it) : std::next(it);
  }
  for (const auto& [asset, step] : now) {
    Eigen::Vector2d& push = state_.pushes.emplace(asset, Eigen::Vector2d::Zero()).first->second;
    push += (1.0 - keep) * step.moment_nm;
    if (falls_.count(asset) != 0 || push.norm() < PhysicsOfTree(asset).failing_moment_nm()) {
      continue;
    }
    Fall fall;
    fall.by = step.by;
    fall.moment_nm = push;
    fall.rate_radps = kSlowestFall_radps;
    falls_.emplace(asset, fall);
  }
}

void Felling::Begin(std::uint32_t asset, const Fall& fall) {
  const Asset& stood = scene_.assets[asset];
  physics_->SetAssetPresent(asset, false);
  if (!fall.impulse_ns.isZero(0.0)) physics_->AddImpulse(fall.by, fall.impulse_ns, fall.point_m);
  Tree tree;
  tree.toward = fall.moment_nm.normalized();
  tree.body = physics_->Add(TreeBodyOf(stood, PhysicsOfTree(asset)),
                            BeginningOfFall(stood, tree.toward, fall.rate_radps));
  tree.lies = StemOf(asset, stood, physics_->MotionOf(tree.body));
  state_.trees.emplace(asset, tree);
  state_.pushes.erase(asset);
}

bool Felling::HasLeft(const BodyMotion& motion) const {
  if (!motion.position_m.allFinite()) return true;
  const WorldPoint place = {motion.position_m.x(), motion.position_m.y()};
  return !scene_.geometry().Contains(place) ||
         motion.position_m.z() < scene_.terrain->ground.HeightAt(place) - kDeepest_m;
}

bool Felling::Follow(std::uint32_t asset, double step_s, Tree* tree) {
  const bool rests = physics_->IsResting(tree->body);
  if (tree->at_rest && rests) return false;
  const BodyMotion motion = physics_->MotionOf(tree->body);
  const FallenTree stem = StemOf(asset, scene_.assets[asset], motion);
  if (tree->at_rest) {
    const double moved_m =
        std::max((stem.foot_m - tree->lies.foot_m).norm(), (stem.tip_m - tree->lies.tip_m).norm());
    if (moved_m < kMoved_m) return false;
    tree->lies = stem;  // it floats or was pushed: it lies elsewhere
    return true;
  }
  tree->falling_s += step_s;
  const bool still = motion.linear_velocity_mps.norm() < kStill_mps &&
                     motion.angular_velocity_radps.norm() < kStill_radps;
  tree->still_s = still ? tree->still_s + step_s : 0.0;
  const bool leans = stem.tip_m.z() - stem.foot_m.z() < kUpright * scene_.assets[asset].height_m;
  const bool stopped = leans && (rests || tree->still_s >= kStill_s);
  if (!stopped && (!leans || tree->falling_s < kLongestFall_s)) return false;
  tree->at_rest = true;
  tree->lies = stem;
  return true;
}

std::string Felling::NameOf(std::uint32_t asset) { return "tree_" + std::to_string(asset); }

void Felling::Lose(Tree* tree) {
  physics_->Remove(tree->body);
  tree->body = 0;
  tree->at_rest = false;
}

void Felling::Remove(const std::string& name, std::uint64_t step, std::vector<Event>* events) {
  for (auto& [asset, tree] : state_.trees) {
    if (tree.body == 0 || NameOf(asset) != name) continue;
    events->push_back(
        {step, EventKind::kLeftWorld, "", name, physics_->MotionOf(tree.body).position_m});
    Lose(&tree);
    ListChanges();
  }
}

Felling::Outcome Felling::Step(double step_s, std::uint64_t step,
                               const std::function<std::string(BodyId)>& name_of,
                               std::vector<Event>* events) {
  Push(step_s);
  Outcome outcome;
  outcome.changes = !falls_.empty();
  const auto tell = [&](EventKind kind, std::uint32_t asset, const std::string& by,
                        const Eigen::Vector3d& place) {
    events->push_back({step, kind, by, NameOf(asset), place});
  };
  // First, while all that struck them are still there.
  for (const auto& [asset, fall] : falls_) {
    const Asset& stood = scene_.assets[asset];
    Begin(asset, fall);
    tell(EventKind::kFelledTree, asset, name_of(fall.by), {stood.x_m, stood.y_m, stood.z_m});
  }
  falls_.clear();
  for (auto& [asset, tree] : state_.trees) {
    if (tree.body == 0) continue;
    const bool looked_at = !tree.at_rest || !physics_->IsResting(tree.body);
    if (!looked_at) continue;
    if (HasLeft(physics_->MotionOf(tree.body))) {
      tell(EventKind::kLeftWorld, asset, "", physics_->MotionOf(tree.body).position_m);
      Lose(&tree);
      outcome.maps = true;
      continue;
    }
    const bool lay = tree.at_rest;
    if (!Follow(asset, step_s, &tree)) continue;
    outcome.maps = true;
    if (!lay) tell(EventKind::kTreeCameToRest, asset, "", tree.lies.foot_m);
  }
  outcome.changes |= outcome.maps;
  if (outcome.changes) ListChanges();
  return outcome;
}

}  // namespace latticeworld
