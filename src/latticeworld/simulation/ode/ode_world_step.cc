// How a step of OdeWorld finds what touches what.

#include <algorithm>
#include <cmath>

#include "latticeworld/common/check.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/ode/ode_math.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"
#include "latticeworld/simulation/ode/wheel_ground.h"

namespace latticeworld {
namespace {

constexpr int kSolverIterations = 12;
// Chains of hinges converge slowly, and so do brakes that hold a robot on a slope.
constexpr int kFineSolverIterations = 30;
constexpr double kObstacleFriction = 0.3;  // of bodies beside trunks, walls and each other
constexpr double kDeckFriction = 0.6;      // of what stands on something: wood
constexpr double kOnTop = 0.5;             // z of the normal from which on a body stands on another
constexpr double kJudgedApproach_mps = 0.05;
constexpr double kLowestLever_m = 0.05;
constexpr double kTreeDamping = 0.2;        // share of the critical one, of a blow against a stem
constexpr double kHardestPush_mps2 = 50.0;  // times a body's mass, against a stem
constexpr std::size_t kMaxSampleContacts = 24;
constexpr double kMostOvershoot_m = 0.5;  // of the edge of the world, in one step

Eigen::Vector3d PositionOf(const dContactGeom& geom) { return ToEigen(geom.pos); }

}  // namespace

void OdeWorld::Step(double step_s, std::uint64_t solver_seed) {
  LW_CHECK(step_s > 0.0 && std::isfinite(step_s), "a step takes some time");
  contacts_.clear();
  strayed_.clear();
  SortSpans();
  TouchBodies();
  for (Entry& entry : bodies_) {
    OdeBody* body = entry.body.get();
    if (body->stands()) continue;
    body->BeginStep(step_s);
    TouchGroundOf(body, step_s);
    if (body->ball_radius_m() >= 0.0) TouchAssetsOf(&entry);
    TouchBoundaryOf(body, step_s);
  }
  joints_->Join(step_s);
  Solve(step_s, solver_seed);
  joints_->Finish(&contacts_);
  for (Entry& entry : bodies_) {
    const bool spoiled = entry.body->stands() && entry.body->Mend();
    if (spoiled || (!entry.body->stands() && !entry.body->FinishStep(step_s))) {
      strayed_.push_back(entry.id);
    }
  }
}

void OdeWorld::Solve(double step_s, std::uint64_t solver_seed) {
  // ODE has one number of iterations for all islands, but leaves out what is disabled.
  constexpr char kOut = 0, kFine = 1, kCoarse = 2;
  fine_.assign(bodies_.size(), kOut);
  bool any_fine = false;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const OdeBody& body = *bodies_[i].body;
    if (body.stands()) continue;
    fine_[i] = body.link_count() > 0 || body.Brakes() ? kFine : kCoarse;
    any_fine = any_fine || fine_[i] == kFine;
  }
  dWorldSetQuickStepNumIterations(world_, kSolverIterations);
  if (!any_fine) {
    StepOde(world_, step_s, solver_seed);
    return;
  }
  for (bool spread = true; spread;) {
    spread = false;
    for (const ContactJoint& joint : joints_->found()) {
      if (joint.body_a == 0 || joint.body_b == 0) continue;
      char& a = fine_[IndexOf(joint.body_a)];
      char& b = fine_[IndexOf(joint.body_b)];
      if (a == b) continue;
      a = b = kFine;
      spread = true;
    }
  }
  const auto set_enabled = [this](char which, bool enabled) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (fine_[i] != which) continue;
      const OdeBody& body = *bodies_[i].body;
      for (std::size_t k = 0; k < body.part_count(); ++k) {
        enabled ? dBodyEnable(body.part(k)) : dBodyDisable(body.part(k));
      }
    }
  };
  set_enabled(kFine, false);
  StepOde(world_, step_s, solver_seed);
  set_enabled(kCoarse, false);
  set_enabled(kFine, true);
  dWorldSetQuickStepNumIterations(world_, kFineSolverIterations);
  StepOde(world_, step_s, solver_seed);
  set_enabled(kCoarse, true);
}

const SurfaceProperties& OdeWorld::SurfaceAt(const Eigen::Vector3d& at) const {
  return surfaces_.Of(scene_->terrain->SurfaceAt({at.x(), at.y()}));
}

// Insertion sort: hardly anything changes its place from step to step. Ties by id, so that the
// order never depends on what was before.
void OdeWorld::SortSpans() {
  for (Span& span : spans_) {
    if (span.settled && span.body->resting()) continue;
    span.settled = span.body->resting();
    const double x = span.body->BallCenter().x(), radius_m = span.body->ball_radius_m();
    span.low_m = x - radius_m;
    span.high_m = x + radius_m;
  }
  const auto before = [](const Span& a, const Span& b) {
    return a.low_m != b.low_m ? a.low_m < b.low_m : a.body->id() < b.body->id();
  };
  for (std::size_t i = 1; i < spans_.size(); ++i) {
    const Span span = spans_[i];
    std::size_t at = i;
    for (; at > 0 && before(span, spans_[at - 1]); --at) spans_[at] = spans_[at - 1];
    spans_[at] = span;
  }
}

// Sort and sweep along x (Baraff 1992).
void OdeWorld::TouchBodies() {
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    OdeBody* a = spans_[i].body;
    for (std::size_t j = i + 1; j < spans_.size() && spans_[j].low_m < spans_[i].high_m; ++j) {
      OdeBody* b = spans_[j].body;
      if (a->stands() && b->stands()) continue;
      const double reach_m = a->ball_radius_m() + b->ball_radius_m();
      if ((a->BallCenter() - b->BallCenter()).squaredNorm() > reach_m * reach_m) continue;
      if (a->control().anchored && b->control().anchored) continue;
      TouchPair(a, b);
    }
  }
}

// Feet, which meet nothing else but the ground, stand on what is made to be held fast, also where
// it came loose.
void OdeWorld::TouchDeck(OdeBody* body, OdeBody* deck) {
  const BodySpec& spec = body->spec();
  dContactGeom contact;
  bool awake = false;
  const auto push = [&](std::size_t part, const OdeBody::BodySolid& one) {
    if (!awake) WakeEachOther(body, deck);
    awake = true;
    PushBodies({body, part}, {deck, one.part}, contact);
  };
  for (const OdeBody::BodySolid& one : deck->PosedSolids()) {
    for (const GroundSample& sample : spec.ground_samples) {
      const Eigen::Vector3d at = body->TrunkPoint(sample.offset_m);
      if (StandsOn(one.solid, at, sample.radius_m, &contact)) {
        push(0, one);
      }
    }
    for (std::size_t i = 0; i < spec.links.size(); ++i) {
      for (const GroundSample& sample : spec.links[i].ground_samples) {
        const Eigen::Vector3d at = body->LinkPoint(i, sample.offset_m);
        if (StandsOn(one.solid, at, sample.radius_m, &contact)) {
          push(1 + spec.wheels.size() + i, one);
        }
      }
    }
  }
}

// A moving body wakes its neighbour; beside one that merely stands, the sleeper is a wall.
void OdeWorld::WakeEachOther(OdeBody* a, OdeBody* b) {
  if (!a->still() && b->resting()) b->Wake();
  if (!b->still() && a->resting()) a->Wake();
}

void OdeWorld::TouchPair(OdeBody* a, OdeBody* b) {
  const auto walks = [](OdeBody* body) {
    return body->control().upright || !body->spec().links.empty();
  };
  const auto carries = [](OdeBody* body) {
    return body->spec().anchor && body->spec().anchor->kind == AnchorKind::kFixed;
  };
  if (carries(b) && walks(a)) TouchDeck(a, b);
  if (carries(a) && walks(b)) TouchDeck(b, a);
  bool awake = false;
  for (const OdeBody::BodySolid& of_a : a->PosedSolids()) {
    for (const OdeBody::BodySolid& of_b : b->PosedSolids()) {
      if (!of_a.solid.bounds().Meets(of_b.solid.bounds())) continue;
      touch_.count = 0;
      Collide(of_a.solid, of_b.solid, &touch_);
      if (touch_.count == 0) continue;
      if (!awake) WakeEachOther(a, b);
      awake = true;
      for (int k = 0; k < touch_.count; ++k) {
        PushBodies({a, of_a.part}, {b, of_b.part}, touch_.contact[static_cast<std::size_t>(k)]);
      }
    }
  }
}

void OdeWorld::TouchGroundOf(OdeBody* body, double step_s) {
  if (!body->spec().wheels.empty()) TouchGroundWithWheels(body, step_s);
  TouchGroundWithSamples(body);
}

void OdeWorld::TouchGroundWithWheels(OdeBody* body, double step_s) {
  const BodySpec& spec = body->spec();
  wheel_touch_.clear();
  int carrying = 0;
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    const Eigen::Vector3d center = latticeworld::PositionOf(body->wheel(i));
    wheel_touch_.push_back(TouchGround(ground(), center, spec.wheels[i].radius_m));
    if (wheel_touch_.back().count > 0) ++carrying;
  }
  for (std::size_t i = 0; i < spec.wheels.size(); ++i) {
    const GroundContacts& touch = wheel_touch_[i];
    if (touch.count == 0) continue;
    const WheelLoad load{body->mass_kg() / carrying, spec.wheels[i]};
    const Eigen::Vector3d axis = body->WheelAxis(i);
    const double rate_radps = ToEigen(dBodyGetAngularVel(body->wheel(i))).dot(axis);
    for (int k = 0; k < touch.count; ++k) {
      const GroundContact& one = touch.contact[static_cast<std::size_t>(k)];
      const SurfaceProperties& surface = SurfaceAt(one.position_m);
      const double friction = surface.friction * spec.grip;
      Traction traction;
      traction.along = axis.cross(one.normal);
      traction.friction_along = friction;
      traction.friction_across = friction * spec.wheels[i].side_grip;
      traction.slip_mps_per_n = SlipPerForce(load, surface, friction, rate_radps) * touch.count;
      AddGroundContact(body, body->wheel(i), one, traction);
      ResistRolling(body->wheel(i), load, surface, one.normal, traction.along, step_s,
                    1.0 / touch.count);
    }
  }
}

void OdeWorld::TouchGroundWithSamples(OdeBody* body) {
  const BodySpec& spec = body->spec();
  sample_touch_.clear();
  const auto touch = [&](const GroundSample& sample, const Eigen::Vector3d& at, dBodyID part,
                         bool walks) {
    const GroundContacts found = TouchGround(ground(), at, sample.radius_m);
    for (int k = 0; k < found.count; ++k) {
      sample_touch_.push_back({found.contact[static_cast<std::size_t>(k)], part, walks});
    }
  };
  const auto touch_all = [&](const std::vector<GroundSample>& samples, dBodyID part,
                             const Eigen::Vector3d& center_in_base_m, bool walks) {
    const dReal* r = dBodyGetRotation(part);
    Eigen::Matrix3d map_from_part;
    map_from_part << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
    const Eigen::Vector3d base_m =
        latticeworld::PositionOf(part) - map_from_part * center_in_base_m;
    for (const GroundSample& sample : samples) {
      touch(sample, base_m + map_from_part * sample.offset_m, part, walks);
    }
  };
  const Eigen::Vector3d trunk_m(0.0, 0.0, spec.center_height_m);
  touch_all(spec.ground_samples, body->trunk(), trunk_m, true);
  for (std::size_t i = 0; i < spec.links.size(); ++i) {
    touch_all(spec.links[i].ground_samples, body->link(i), spec.links[i].center_m, false);
  }
  // A trunk that lies along the ground: its deepest points hold it.
  if (sample_touch_.size() > kMaxSampleContacts) {
    std::stable_sort(sample_touch_.begin(), sample_touch_.end(),
                     [](const SampleTouch& a, const SampleTouch& b) {
                       return a.contact.depth_m > b.contact.depth_m;
                     });
    sample_touch_.resize(kMaxSampleContacts);
  }
  for (const SampleTouch& one : sample_touch_) {
    AddGroundContact(body, one.part, one.contact,
                     GroundTraction(*body, one.contact.position_m, one.contact.normal, one.walks));
  }
}

void OdeWorld::AddGroundContact(OdeBody* body, dBodyID part, const GroundContact& touch,
                                const Traction& traction) {
  contacts_.push_back(
      {body->id(), ContactKind::kGround, 0, touch.position_m, touch.normal, touch.depth_m, 0.0});
  joints_->Add({part, nullptr, touch.position_m, touch.normal, touch.depth_m, traction});
}

// Feet push the ground away: friction acts towards the wanted velocity along the surface.
Traction OdeWorld::GroundTraction(const OdeBody& body, const Eigen::Vector3d& at,
                                  const Eigen::Vector3d& normal, bool walks) const {
  Traction traction;
  traction.friction_along = SurfaceAt(at).friction * body.spec().grip;
  traction.friction_across = traction.friction_along;
  if (!walks) return traction;
  const Eigen::Vector3d& wanted = body.control().walk_velocity_mps;
  const Eigen::Vector3d along = wanted - wanted.dot(normal) * normal;
  if (along.squaredNorm() > 1e-12) {
    traction.along = along;
    traction.speed_mps = wanted.norm();
  }
  return traction;
}

// Whoever stands on something drives and walks on it; what is beside it only rubs.
Traction OdeWorld::SolidTraction(const Side& side, const Eigen::Vector3d& normal) const {
  Traction traction;
  traction.friction_along = traction.friction_across = kObstacleFriction;
  if (normal.z() < kOnTop) return traction;
  const OdeBody& body = *side.body;
  traction.friction_along = traction.friction_across = kDeckFriction * body.spec().grip;
  if (side.part > body.wheel_count()) return traction;  // a leg
  if (side.part > 0) {
    traction.along = body.WheelAxis(side.part - 1).cross(normal);
    traction.friction_across *= body.spec().wheels[side.part - 1].side_grip;
    return traction;
  }
  const Eigen::Vector3d& wanted = body.control().walk_velocity_mps;
  const Eigen::Vector3d along = wanted - wanted.dot(normal) * normal;
  if (along.squaredNorm() > 1e-12) {
    traction.along = along;
    traction.speed_mps = wanted.norm();
  }
  return traction;
}

bool OdeWorld::GivesWay(const Contact& contact) const {
  return judge_ != nullptr && contact.approach_mps > kJudgedApproach_mps &&
         judge_->GivesWay(contact);
}

void OdeWorld::PushBodies(Side a, Side b, const dContactGeom& geom) {
  Eigen::Vector3d normal = ToEigen(geom.normal);
  // The first one is what moves; of two that move, what is not anchored; of those, the upper one.
  const bool swap = a.body->stands() != b.body->stands() ? a.body->stands()
                    : a.body->control().anchored != b.body->control().anchored
                        ? a.body->control().anchored
                        : normal.z() < -kOnTop;
  if (swap) {
    std::swap(a, b);
    normal = -normal;
  }
  const Eigen::Vector3d at = PositionOf(geom);
  const dBodyID part_a = a.body->part(a.part);
  Eigen::Vector3d closing = VelocityAt(part_a, at);
  dBodyID part_b = nullptr;
  if (!b.body->stands()) {
    part_b = b.body->part(b.part);
    closing -= VelocityAt(part_b, at);
  }
  Contact contact{a.body->id(),
                  ContactKind::kBody,
                  b.body->id(),
                  at,
                  normal,
                  geom.depth,
                  std::max(0.0, -closing.dot(normal))};
  const bool yields = b.body->control().anchored && GivesWay(contact);
  contacts_.push_back(contact);
  if (yields) return;
  ContactJoint joint{part_a, part_b, at, normal, geom.depth, SolidTraction(a, normal)};
  joint.reported = static_cast<int>(contacts_.size()) - 1;
  joint.body_a = a.body->id();
  joint.body_b = part_b != nullptr ? b.body->id() : 0;
  joints_->Add(joint);
}

void OdeWorld::TouchAssetsOf(Entry* entry) {
  OdeBody* body = entry->body.get();
  const Eigen::Vector3d center = body->BallCenter();
  const double radius_m = body->ball_radius_m();
  entry->window.Cover(*scene_, center.head<2>(), radius_m);
  for (const NearAsset& asset : entry->window.near()) {
    const double dx = asset.x_m - center.x(), dy = asset.y_m - center.y();
    const double reach_m = radius_m + asset.radius_m;
    if (dx * dx + dy * dy > reach_m * reach_m) continue;
    if (gone_assets_.count(asset.index) != 0) continue;
    for (const OdeBody::BodySolid& one : body->PosedSolids()) {
      if (!one.solid.bounds().Meets(asset.solid.bounds())) continue;
      touch_.count = 0;
      Collide(one.solid, asset.solid, &touch_);
      for (int k = 0; k < touch_.count; ++k) {
        PushAsset({body, one.part}, asset, touch_.contact[static_cast<std::size_t>(k)]);
      }
    }
  }
}

void OdeWorld::PushAsset(Side side, const NearAsset& asset, const dContactGeom& geom) {
  const Eigen::Vector3d at = PositionOf(geom), normal = ToEigen(geom.normal);
  const dBodyID part = side.body->part(side.part);
  const Contact contact{side.body->id(),
                        ContactKind::kAsset,
                        asset.index,
                        at,
                        normal,
                        geom.depth,
                        std::max(0.0, -VelocityAt(part, at).dot(normal))};
  const bool yields = GivesWay(contact);
  contacts_.push_back(contact);
  if (yields) return;
  ContactJoint joint{part, nullptr, at, normal, geom.depth, SolidTraction(side, normal)};
  if (asset.base_stiffness_nmprad > 0.0) {
    // A stem that leans about its base, seen from where it is hit.
    const double lever_m = std::max(kLowestLever_m, at.z() - asset.z_m);
    const double stiffness = asset.base_stiffness_nmprad / (lever_m * lever_m);
    joint.compliance = {stiffness,
                        kTreeDamping * 2.0 * std::sqrt(stiffness * side.body->mass_kg())};
    // A body that was put or fell into a stem is pushed out of it no harder than a blow at its
    // speed or a push of its own could bend the stem.
    const double mass_kg = side.body->mass_kg();
    joint.depth_m =
        std::min(joint.depth_m, std::max(kHardestPush_mps2 * mass_kg / stiffness,
                                         contact.approach_mps * std::sqrt(mass_kg / stiffness)));
  }
  joint.reported = static_cast<int>(contacts_.size()) - 1;
  joint.body_a = side.body->id();
  joints_->Add(joint);
}

// The edge of the world is a soft wall. It acts at the height of the centre, so that it stops the
// body without tipping it. What is so fast that it would go far beyond the edge in this step is
// stopped before it.
void OdeWorld::TouchBoundaryOf(OdeBody* body, double step_s) {
  const double half_m = scene_->geometry().half_size_m();
  const Eigen::Vector3d center = body->BallCenter();
  const Eigen::Vector3d way_m = step_s * ToEigen(dBodyGetLinearVel(body->trunk()));
  const double extent_m = center.head<2>().cwiseAbs().maxCoeff() +
                          std::max(0.0, body->ball_radius_m()) +
                          way_m.head<2>().cwiseAbs().maxCoeff();
  if (extent_m <= half_m) return;
  Bounds bounds{center, center};
  for (const OdeBody::BodySolid& one : body->PosedSolids()) bounds.Include(one.solid.bounds());
  for (int axis = 0; axis < 2; ++axis) {
    const double above_m = bounds.high_m[axis] - half_m, below_m = -half_m - bounds.low_m[axis];
    const bool above = above_m > below_m;
    const double outside_m = std::max(above_m, below_m);
    const double next_m = outside_m + (above ? way_m[axis] : -way_m[axis]);
    if (outside_m <= 0.0 && next_m <= kMostOvershoot_m) continue;
    const double beyond_m = std::max(0.0, outside_m);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    normal[axis] = above ? -1.0 : 1.0;
    const Eigen::Vector3d at = latticeworld::PositionOf(body->trunk());
    const double approach_mps = std::max(0.0, -VelocityAt(body->trunk(), at).dot(normal));
    contacts_.push_back(
        {body->id(), ContactKind::kBoundary, 0, at, normal, beyond_m, approach_mps});
    Traction traction;
    traction.friction_along = traction.friction_across = kObstacleFriction;
    joints_->Add({body->trunk(), nullptr, at, normal, beyond_m, traction});
  }
}

}  // namespace latticeworld
