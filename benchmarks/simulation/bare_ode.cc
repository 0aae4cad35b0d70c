#include "simulation/bare_ode.h"

#include <cmath>

namespace latticeworld {

BareOde::BareOde(const Scene& scene, AssetSpace assets) : scene_(scene) {
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  world_ = dWorldCreate();
  space_ = dHashSpaceCreate(nullptr);
  group_ = dJointGroupCreate(0);
  dWorldSetGravity(world_, 0, 0, -kGravity_mps2);
  dWorldSetQuickStepNumIterations(world_, 20);
  dWorldSetAutoDisableFlag(world_, 1);
  AddGround(scene);
  if (assets != AssetSpace::kNone) AddTrees(scene, assets);
}

BareOde::~BareOde() {
  dJointGroupDestroy(group_);
  dSpaceDestroy(space_);
  dGeomHeightfieldDataDestroy(heights_);
  dWorldDestroy(world_);
  dCloseODE();
}

void BareOde::Step(double step_s) {
  dSpaceCollide(space_, this, &Near);
  dWorldQuickStep(world_, step_s);
  dJointGroupEmpty(group_);
}

void BareOde::Near(void* self, dGeomID a, dGeomID b) {
  auto* ode = static_cast<BareOde*>(self);
  if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
    dSpaceCollide2(a, b, self, &Near);
    return;
  }
  const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
  const bool a_moves = body_a != nullptr && dBodyIsEnabled(body_a) != 0;
  const bool b_moves = body_b != nullptr && dBodyIsEnabled(body_b) != 0;
  if (!a_moves && !b_moves) return;
  dContact contacts[8] = {};
  const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
  for (int i = 0; i < count; ++i) {
    contacts[i].surface.mode = dContactApprox1;
    contacts[i].surface.mu = 0.6;
    dJointAttach(dJointCreateContact(ode->world_, ode->group_, &contacts[i]), body_a, body_b);
  }
}

void BareOde::AddGround(const Scene& scene) {
  const Grid<float>& height_m = scene.terrain->ground.height_m();
  heights_ = dGeomHeightfieldDataCreate();
  const double width_m = scene.geometry().resolution_m() * (height_m.cols() - 1);
  dGeomHeightfieldDataBuildSingle(heights_, height_m.data(), 0, width_m, width_m, height_m.cols(),
                                  height_m.rows(), 1, 0, 1, 0);
  dGeomHeightfieldDataSetBounds(heights_, scene.terrain->ground.min_m(),
                                scene.terrain->ground.max_m());
  const dGeomID ground = dCreateHeightfield(space_, heights_, 1);
  dMatrix3 y_up_to_z_up;
  dRFromAxisAndAngle(y_up_to_z_up, 1, 0, 0, M_PI / 2);
  dGeomSetRotation(ground, y_up_to_z_up);
}

void BareOde::AddTrees(const Scene& scene, AssetSpace assets) {
  dSpaceID trees = space_;
  if (assets == AssetSpace::kQuadtree) {
    const dVector3 center = {0, 0, 0, 0};
    const double half_m = scene.geometry().half_size_m();
    const dVector3 extents = {half_m, half_m, 500, 0};
    trees = dQuadTreeSpaceCreate(space_, center, extents, 8);
  }
  for (const Asset& asset : scene.assets) {
    // A place before the space: the other order costs a quadtree a search a geom.
    const dGeomID trunk = dCreateCylinder(nullptr, asset.trunk_radius_m, asset.height_m);
    dGeomSetPosition(trunk, asset.x_m, asset.y_m, asset.z_m + 0.5 * asset.height_m);
    dSpaceAdd(trees, trunk);
  }
}

void BareOde::Add(const BodySpec& spec, WorldPoint at, double height_m) {
  const Eigen::Vector3d base_m(at.x_m, at.y_m, scene_.terrain->ground.HeightAt(at) + height_m);
  const dBodyID trunk = dBodyCreate(world_);
  dMass mass;
  dMassSetParameters(&mass, spec.mass_kg, 0, 0, 0, spec.inertia_kgm2.x(), spec.inertia_kgm2.y(),
                     spec.inertia_kgm2.z(), 0, 0, 0);
  dBodySetMass(trunk, &mass);
  dBodySetPosition(trunk, base_m.x(), base_m.y(), base_m.z() + spec.center_height_m);
  bodies_.push_back(trunk);
  trunks_.push_back(trunk);
  starts_.push_back(at);
  const bool single = spec.shapes.size() + spec.wheels.size() == 1;
  const dSpaceID space = single ? space_ : dSimpleSpaceCreate(space_);
  for (const BodyShape& shape : spec.shapes) AddShape(shape, spec.center_height_m, trunk, space);
  for (const WheelSpec& wheel : spec.wheels) AddWheel(wheel, trunk, base_m, space);
}

void BareOde::AddShape(const BodyShape& shape, double center_height_m, dBodyID trunk,
                       dSpaceID space) {
  dGeomID geom = nullptr;
  switch (shape.form) {
    case ShapeForm::kBall:
      geom = dCreateSphere(space, shape.radius_m);
      break;
    case ShapeForm::kCapsule:
      geom = dCreateCapsule(space, shape.radius_m, 2.0 * shape.half_length_m);
      break;
    case ShapeForm::kBox:
      geom = dCreateBox(space, 2.0 * shape.half_extents_m.x(), 2.0 * shape.half_extents_m.y(),
                        2.0 * shape.half_extents_m.z());
      break;
  }
  dGeomSetBody(geom, trunk);
  dGeomSetOffsetPosition(geom, shape.center_m.x(), shape.center_m.y(),
                         shape.center_m.z() - center_height_m);
  const Eigen::Quaterniond& turn = shape.orientation;
  const dQuaternion offset = {turn.w(), turn.x(), turn.y(), turn.z()};
  dGeomSetOffsetQuaternion(geom, offset);
}

void BareOde::AddWheel(const WheelSpec& wheel, dBodyID trunk, const Eigen::Vector3d& base_m,
                       dSpaceID space) {
  const Eigen::Vector3d center_m = base_m + wheel.center_m;
  const dBodyID body = dBodyCreate(world_);
  dMass mass;
  dMassSetSphereTotal(&mass, wheel.mass_kg, wheel.radius_m);
  dBodySetMass(body, &mass);
  dBodySetPosition(body, center_m.x(), center_m.y(), center_m.z());
  dGeomSetBody(dCreateSphere(space, wheel.radius_m), body);
  const dJointID axle = dJointCreateHinge(world_, nullptr);
  dJointAttach(axle, body, trunk);
  dJointSetHingeAnchor(axle, center_m.x(), center_m.y(), center_m.z());
  dJointSetHingeAxis(axle, 0, 1, 0);
  dJointSetHingeParam(axle, dParamFMax, wheel.max_torque_nm);
  bodies_.push_back(body);
  axles_.push_back(axle);
}

void BareOde::SetWheelRate(double rate_radps) {
  for (const dJointID axle : axles_) {
    dJointSetHingeParam(axle, dParamVel, rate_radps);
    dBodyEnable(dJointGetBody(axle, 0));
  }
}

int BareOde::awake() const {
  int count = 0;
  for (const dBodyID body : bodies_) count += dBodyIsEnabled(body);
  return count;
}

double BareOde::MeanWay() const {
  double sum_m = 0.0;
  for (std::size_t i = 0; i < trunks_.size(); ++i) {
    const dReal* at = dBodyGetPosition(trunks_[i]);
    sum_m += std::hypot(at[0] - starts_[i].x_m, at[1] - starts_[i].y_m);
  }
  return trunks_.empty() ? 0.0 : sum_m / static_cast<double>(trunks_.size());
}

}  // namespace latticeworld
