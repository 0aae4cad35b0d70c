#include "latticeworld/simulation/ode/ode_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/digest.h"
#include "latticeworld/common/enum_names.h"
#include "latticeworld/scene/surface_table.h"
#include "latticeworld/simulation/ode/asset_prism.h"
#include "latticeworld/simulation/ode/ground_contact.h"
#include "latticeworld/simulation/ode/ode_body.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/ode/wheel_ground.h"

namespace latticeworld {
namespace {

constexpr int kSolverIterations = 20;
constexpr double kErrorReduction = 0.3;          // share of a contact's depth undone in a step
constexpr double kContactSoftness = 1e-6;        // CFM
constexpr double kSurfaceLayer_m = 0.001;        // depth at which contacts rest
constexpr double kMaxCorrectingSpeed_mps = 2.0;  // so that a deep contact does not shoot bodies off
constexpr double kObstacleFriction = 0.3;        // bodies against trunks, walls and each other
constexpr double kPlacingClearance_m = 0.002;
constexpr double kWakingFriction = 0.02;  // a change of friction that what rests may feel

// How a contact pushes along the surface.
struct Traction {
  Eigen::Vector3d along = Eigen::Vector3d::Zero();  // first friction direction; zero: any
  double friction_along = 0.0;
  double friction_across = 0.0;
  double speed_mps = 0.0;       // of the body along `along` that friction pushes towards
  double slip_mps_per_n = 0.0;  // speed that the contact gives way along `along` under a force
};

Eigen::Vector3d AnyTangent(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d other =
      std::abs(normal.x()) < 0.7 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  return other.cross(normal).normalized();
}

class OdeWorld : public PhysicsWorld {
 public:
  explicit OdeWorld(std::shared_ptr<const Scene> scene)
      : scene_(std::move(scene)),
        ground_(scene_->atmosphere.ground()),
        surfaces_(*scene_, ground_) {
    ReadyOde();
    world_ = dWorldCreate();
    contact_group_ = dJointGroupCreate(0);
    dWorldSetGravity(world_, 0.0, 0.0, -kGravity_mps2);
    dWorldSetQuickStepNumIterations(world_, kSolverIterations);
    dWorldSetERP(world_, kErrorReduction);
    dWorldSetCFM(world_, 1e-9);
    dWorldSetContactMaxCorrectingVel(world_, kMaxCorrectingSpeed_mps);
    dWorldSetContactSurfaceLayer(world_, kSurfaceLayer_m);
    dWorldSetAutoDisableFlag(world_, 0);
    for (const auto& entry : EnumNames(SurfaceClass{})) {
      woken_friction_[static_cast<std::size_t>(entry.value)] = surfaces_.Of(entry.value).friction;
    }
  }
  ~OdeWorld() override {
    dJointGroupDestroy(contact_group_);
    bodies_.clear();
    dWorldDestroy(world_);
  }

  BodyId Add(const BodySpec& spec, const Eigen::Vector3d& position_m, double yaw_rad) override {
    ReadyOde();
    const BodyId id = ++last_id_;
    OdeBody& body = *bodies_.emplace(id, std::make_unique<OdeBody>(world_, spec)).first->second;
    BodyMotion motion;
    motion.position_m = position_m;
    const Eigen::AngleAxisd heading(yaw_rad, Eigen::Vector3d::UnitZ());
    motion.orientation = heading;
    if (!spec.upright && !spec.wheels.empty()) {
      const Eigen::Vector3d normal = ground().NormalAt({position_m.x(), position_m.y()});
      motion.orientation =
          Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal) * heading;
    }
    body.SetMotion(motion);
    LiftOutOfGround(&body);
    return id;
  }

  void Remove(BodyId body) override { bodies_.erase(body); }

  void SetWalkVelocity(BodyId body, const Eigen::Vector3d& velocity_mps) override {
    At(body).SetWalkVelocity(velocity_mps);
  }
  void SetWheelRates(BodyId body, double left_radps, double right_radps) override {
    At(body).SetWheelRates(left_radps, right_radps);
  }
  void AddForce(BodyId id, const Eigen::Vector3d& force_n) override {
    OdeBody& body = At(id);
    body.Wake();
    dBodyAddForce(body.trunk(), force_n.x(), force_n.y(), force_n.z());
  }
  void AddTorque(BodyId id, const Eigen::Vector3d& torque_nm) override {
    OdeBody& body = At(id);
    body.Wake();
    dBodyAddTorque(body.trunk(), torque_nm.x(), torque_nm.y(), torque_nm.z());
  }
  void SetGround(const GroundState& ground) override {
    ground_ = ground;
    surfaces_ = SurfaceTable(*scene_, ground);
    bool changed = false;
    for (const auto& entry : EnumNames(SurfaceClass{})) {
      const double friction = surfaces_.Of(entry.value).friction;
      const double woken = woken_friction_[static_cast<std::size_t>(entry.value)];
      changed = changed || std::abs(friction - woken) > kWakingFriction;
    }
    // Weather that moves slowly shall not keep everybody awake.
    if (!changed) return;
    for (const auto& entry : EnumNames(SurfaceClass{})) {
      woken_friction_[static_cast<std::size_t>(entry.value)] = surfaces_.Of(entry.value).friction;
    }
    for (auto& [id, body] : bodies_) body->Wake();
  }
  void Place(BodyId body, const BodyMotion& motion) override { At(body).SetMotion(motion); }
  BodyMotion MotionOf(BodyId body) const override { return At(body).Motion(); }
  double SinkageOf(BodyId body) const override { return Sinkage(At(body)); }
  bool IsResting(BodyId body) const override { return At(body).resting(); }

  void Step(double step_s, std::uint64_t solver_seed) override {
    contacts_.clear();
    FindOutlines();
    TouchBodies();
    for (const Outlined& one : outlined_) {
      if (one.body->resting()) continue;
      TouchGroundOf(one.id, *one.body, step_s);
      TouchAssetsOf(one);
      TouchBoundaryOf(one);
    }
    StepOde(world_, step_s, solver_seed);
    dJointGroupEmpty(contact_group_);
    for (auto& [id, body] : bodies_) {
      body->KeepUpright();
      body->UpdateRest(step_s);
    }
  }

  const std::vector<Contact>& contacts() const override { return contacts_; }

  void AddTo(Digest* digest) const override {
    digest->Add(last_id_);
    digest->Add(ground_.wetness);
    digest->Add(ground_.snow_depth_m);
    digest->Add(ground_.blown_sand);
    for (const double friction : woken_friction_) digest->Add(friction);
    for (const auto& [id, body] : bodies_) {
      digest->Add(id);
      body->AddTo(digest);
    }
  }

 private:
  struct Outlined {
    BodyId id;
    OdeBody* body;
    Prism prism;
  };

  const HeightField& ground() const { return scene_->terrain->ground; }

  OdeBody& At(BodyId id) const {
    const auto found = bodies_.find(id);
    LW_CHECK(found != bodies_.end(), "no such body");
    return *found->second;
  }

  double Sinkage(const OdeBody& body) const {
    double depth_m = 0.0;
    for (std::size_t i = 0; i < body.wheel_count(); ++i) {
      depth_m = std::max(
          depth_m, DepthBelowGround(ground(), body.WheelCenter(i), body.spec().wheels[i].radius_m));
    }
    const BodyMotion motion = body.Motion();
    for (const GroundSample& sample : body.spec().ground_samples) {
      const Eigen::Vector3d at = motion.position_m + motion.orientation * sample.offset_m;
      depth_m = std::max(depth_m, DepthBelowGround(ground(), at, sample.radius_m));
    }
    return depth_m;
  }

  // Straight up, until nothing of the body is below the ground.
  void LiftOutOfGround(OdeBody* body) const {
    constexpr int kTries = 32;  // each undoes most of the depth even on steep ground
    BodyMotion motion = body->Motion();
    for (int i = 0; i < kTries; ++i) {
      const double depth_m = Sinkage(*body);
      if (depth_m <= 0.0) return;
      motion.position_m.z() += depth_m + kPlacingClearance_m;
      body->SetMotion(motion);
    }
  }

  void FindOutlines() {
    outlined_.clear();
    for (auto& [id, body] : bodies_) outlined_.push_back({id, body.get(), body->Outline()});
  }

  // Sort and sweep along x (Baraff 1992); ties by id, so that the order is always the same.
  void TouchBodies() {
    sweep_.resize(outlined_.size());
    for (std::size_t i = 0; i < sweep_.size(); ++i) sweep_[i] = i;
    const auto low = [&](std::size_t i) {
      return outlined_[i].prism.center_m.x() - outlined_[i].prism.radius_m;
    };
    std::sort(sweep_.begin(), sweep_.end(), [&](std::size_t a, std::size_t b) {
      return low(a) != low(b) ? low(a) < low(b) : a < b;
    });
    for (std::size_t i = 0; i < sweep_.size(); ++i) {
      const Outlined& a = outlined_[sweep_[i]];
      const double high = a.prism.center_m.x() + a.prism.radius_m;
      for (std::size_t j = i + 1; j < sweep_.size() && low(sweep_[j]) < high; ++j) {
        const Outlined& b = outlined_[sweep_[j]];
        if (a.body->resting() && b.body->resting()) continue;
        const PrismContacts overlap = Overlap(a.prism, b.prism);
        if (overlap.count == 0) continue;
        // A moving body wakes its neighbour; beside one that merely stands, the sleeper is a wall.
        if (!a.body->still()) b.body->Wake();
        if (!b.body->still()) a.body->Wake();
        for (int k = 0; k < overlap.count; ++k) {
          PrismContact contact = overlap.contact[static_cast<std::size_t>(k)];
          if (a.body->resting()) {
            contact.normal = -contact.normal;
            Push(b, contact, ContactKind::kBody, a.id, a.body);
          } else {
            Push(a, contact, ContactKind::kBody, b.id, b.body);
          }
        }
      }
    }
  }

  void TouchGroundOf(BodyId id, OdeBody& body, double step_s) {
    wheel_touch_.clear();
    int carrying = 0;  // wheels
    for (std::size_t i = 0; i < body.wheel_count(); ++i) {
      wheel_touch_.push_back(
          TouchGround(ground(), body.WheelCenter(i), body.spec().wheels[i].radius_m));
      if (wheel_touch_.back().count > 0) ++carrying;
    }
    for (std::size_t i = 0; i < body.wheel_count(); ++i) {
      const GroundContacts& touch = wheel_touch_[i];
      const WheelLoad load{body.mass_kg() / std::max(1, carrying), body.spec().wheels[i]};
      for (int k = 0; k < touch.count; ++k) {
        const GroundContact& one = touch.contact[static_cast<std::size_t>(k)];
        const SurfaceProperties& surface = SurfaceAt(one.position_m);
        const double friction = surface.friction * body.spec().grip;
        Traction traction;
        traction.along = body.WheelAxis(i).cross(one.normal);
        traction.friction_along = friction;
        traction.friction_across = friction * body.spec().wheel_side_grip;
        traction.slip_mps_per_n =
            SlipPerForce(load, surface, friction, body.WheelRate(i)) * touch.count;
        Note({id, ContactKind::kGround, 0, one.position_m, one.normal, one.depth_m, 0.0});
        Join(body.wheel(i), nullptr, one.position_m, one.normal, one.depth_m, traction);
        ResistRolling(body.wheel(i), load, surface, one.normal, traction.along, step_s,
                      1.0 / touch.count);
      }
    }
    const BodyMotion motion = body.Motion();
    for (const GroundSample& sample : body.spec().ground_samples) {
      const Eigen::Vector3d at = motion.position_m + motion.orientation * sample.offset_m;
      const GroundContacts touch = TouchGround(ground(), at, sample.radius_m);
      for (int k = 0; k < touch.count; ++k) {
        const GroundContact& one = touch.contact[static_cast<std::size_t>(k)];
        Note({id, ContactKind::kGround, 0, one.position_m, one.normal, one.depth_m, 0.0});
        Join(body.trunk(), nullptr, one.position_m, one.normal, one.depth_m,
             WalkTraction(body, one.position_m, one.normal));
      }
    }
  }

  // Feet push the ground away: friction acts towards the wanted velocity along the surface.
  Traction WalkTraction(const OdeBody& body, const Eigen::Vector3d& at,
                        const Eigen::Vector3d& normal) const {
    Traction traction;
    traction.friction_along = SurfaceAt(at).friction * body.spec().grip;
    traction.friction_across = traction.friction_along;
    const Eigen::Vector3d& wanted = body.walk_velocity_mps();
    const Eigen::Vector3d along = wanted - wanted.dot(normal) * normal;
    if (along.squaredNorm() > 1e-12) {
      traction.along = along;
      traction.speed_mps = wanted.norm();
    }
    return traction;
  }

  void TouchAssetsOf(const Outlined& one) {
    const WorldPoint at{one.prism.center_m.x(), one.prism.center_m.y()};
    scene_->index.ForEachNear(at, one.prism.radius_m, [&](std::uint32_t index) {
      const PrismContacts overlap = Overlap(one.prism, PrismOf(scene_->assets[index]));
      for (int k = 0; k < overlap.count; ++k) {
        Push(one, overlap.contact[static_cast<std::size_t>(k)], ContactKind::kAsset, index,
             nullptr);
      }
    });
  }

  // The edge of the world is a soft wall that no body passes.
  void TouchBoundaryOf(const Outlined& one) {
    const double limit_m = scene_->geometry().half_size_m() - one.prism.radius_m;
    for (int axis = 0; axis < 2; ++axis) {
      const double beyond_m = std::abs(one.prism.center_m[axis]) - limit_m;
      if (beyond_m <= 0.0) continue;
      PrismContact contact;
      contact.normal = Eigen::Vector3d::Zero();
      contact.normal[axis] = one.prism.center_m[axis] > 0.0 ? -1.0 : 1.0;
      contact.position_m = CenterOf(*one.body);
      contact.depth_m = beyond_m;
      Push(one, contact, ContactKind::kBoundary, 0, nullptr);
    }
  }

  static Eigen::Vector3d CenterOf(const OdeBody& body) {
    const dReal* center = dBodyGetPosition(body.trunk());
    return {center[0], center[1], center[2]};
  }

  // Contact of an outline; acts on the trunk at the height of its centre, so that it stops the body
  // without tipping it.
  void Push(const Outlined& a, const PrismContact& contact, ContactKind kind, std::uint32_t other,
            const OdeBody* b) {
    Eigen::Vector3d at = contact.position_m;
    const bool on_top = contact.normal.z() > 0.5;
    if (!on_top) at.z() = CenterOf(*a.body).z();
    Eigen::Vector3d closing = a.body->VelocityAt(at);
    if (b != nullptr) closing -= b->VelocityAt(at);
    Note({a.id, kind, other, at, contact.normal, contact.depth_m,
          std::max(0.0, -closing.dot(contact.normal))});
    Traction traction;
    if (on_top && b == nullptr) {
      traction = WalkTraction(*a.body, at, contact.normal);
    } else {
      traction.friction_along = kObstacleFriction;
      traction.friction_across = kObstacleFriction;
    }
    Join(a.body->trunk(), b == nullptr || b->resting() ? nullptr : b->trunk(), at, contact.normal,
         contact.depth_m, traction);
  }

  void Note(const Contact& contact) { contacts_.push_back(contact); }

  const SurfaceProperties& SurfaceAt(const Eigen::Vector3d& at) const {
    return surfaces_.Of(scene_->terrain->SurfaceAt({at.x(), at.y()}));
  }

  void Join(dBodyID a, dBodyID b, const Eigen::Vector3d& at, const Eigen::Vector3d& normal,
            double depth_m, const Traction& traction) {
    dContact contact = {};
    contact.surface.mode = dContactApprox1 | dContactMu2 | dContactFDir1 | dContactSoftERP |
                           dContactSoftCFM | dContactMotion1;
    contact.surface.mu = traction.friction_along;
    contact.surface.mu2 = traction.friction_across;
    contact.surface.soft_erp = kErrorReduction;
    contact.surface.soft_cfm = kContactSoftness;
    contact.surface.motion1 = traction.speed_mps;
    if (traction.slip_mps_per_n > 0.0) {
      contact.surface.mode |= dContactSlip1;
      contact.surface.slip1 = traction.slip_mps_per_n;
    }
    const double length = traction.along.norm();
    const Eigen::Vector3d along =
        length > 1e-9 ? Eigen::Vector3d(traction.along / length) : AnyTangent(normal);
    for (int i = 0; i < 3; ++i) {
      contact.geom.pos[i] = at[i];
      contact.geom.normal[i] = normal[i];
      contact.fdir1[i] = along[i];
    }
    contact.geom.depth = depth_m;
    dJointAttach(dJointCreateContact(world_, contact_group_, &contact), a, b);
  }

  std::shared_ptr<const Scene> scene_;
  dWorldID world_ = nullptr;
  dJointGroupID contact_group_ = nullptr;
  GroundState ground_;
  SurfaceTable surfaces_;  // under that state
  // Friction by SurfaceClass when a change of it last woke the bodies up.
  std::array<double, kSurfaceClassCount> woken_friction_{};
  BodyId last_id_ = 0;
  std::map<BodyId, std::unique_ptr<OdeBody>> bodies_;
  std::vector<Outlined> outlined_;           // of this step
  std::vector<GroundContacts> wheel_touch_;  // of one body
  std::vector<std::size_t> sweep_;           // into outlined_, by lowest x
  std::vector<Contact> contacts_;
};

}  // namespace

std::unique_ptr<PhysicsWorld> MakeOdeWorld(std::shared_ptr<const Scene> scene) {
  return std::make_unique<OdeWorld>(std::move(scene));
}

}  // namespace latticeworld
