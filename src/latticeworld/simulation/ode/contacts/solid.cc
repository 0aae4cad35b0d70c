#include "latticeworld/simulation/ode/contacts/solid.h"

#include <algorithm>
#include <cmath>

namespace latticeworld {
namespace {

constexpr double kDepthInGround_m = 20.0;

dGeomID GeomOf(const BodyShape& shape) {
  switch (shape.form) {
    case ShapeForm::kBall:
      break;
    case ShapeForm::kCapsule:
      return dCreateCapsule(nullptr, shape.radius_m, std::max(2.0 * shape.half_length_m, 1e-6));
    case ShapeForm::kBox:
      return dCreateBox(nullptr, 2.0 * shape.half_extents_m.x(), 2.0 * shape.half_extents_m.y(),
                        2.0 * shape.half_extents_m.z());
  }
  return dCreateSphere(nullptr, shape.radius_m);
}

Eigen::Matrix3d RotationOf(dGeomID geom) {
  const dReal* r = dGeomGetRotation(geom);
  Eigen::Matrix3d rotation;
  rotation << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return rotation;
}

// Returns whether a ball touches a box, and where; a ball whose centre is inside leaves by the
// nearest face.
bool TouchBallAndBox(const Eigen::Vector3d& center_m, double radius_m, dGeomID box,
                     dContactGeom* contact) {
  const Eigen::Vector3d box_m(dGeomGetPosition(box)[0], dGeomGetPosition(box)[1],
                              dGeomGetPosition(box)[2]);
  const Eigen::Matrix3d map_from_box = RotationOf(box);
  dVector3 lengths;
  dGeomBoxGetLengths(box, lengths);
  const Eigen::Vector3d half = 0.5 * Eigen::Vector3d(lengths[0], lengths[1], lengths[2]);
  const Eigen::Vector3d at = map_from_box.transpose() * (center_m - box_m);
  const Eigen::Vector3d nearest = at.cwiseMax(-half).cwiseMin(half);
  Eigen::Vector3d normal = at - nearest;
  double distance_m = normal.norm();
  if (distance_m >= radius_m) return false;
  Eigen::Vector3d on_box = nearest;
  if (distance_m > 1e-9) {
    normal /= distance_m;
  } else {
    int face = 0;
    const Eigen::Vector3d inside = half - at.cwiseAbs();
    inside.minCoeff(&face);
    normal = Eigen::Vector3d::Zero();
    normal[face] = at[face] < 0.0 ? -1.0 : 1.0;
    on_box[face] = normal[face] * half[face];
    distance_m = -inside[face];
  }
  const Eigen::Vector3d position = box_m + map_from_box * on_box;
  const Eigen::Vector3d out = map_from_box * normal;
  for (int i = 0; i < 3; ++i) {
    contact->pos[i] = position[i];
    contact->normal[i] = out[i];
  }
  contact->depth = radius_m - distance_m;
  return true;
}

// The way out of a box for a capsule whose axis is in it: from the point of the axis that is
// nearest to the box' centre by the nearest face, though never along the axis: a car that has run
// into a trunk does not leave it by the trunk's top.
void LeaveBox(const Eigen::Vector3d& axis_point_m, const Eigen::Vector3d& axis, double radius_m,
              dGeomID box, dContactGeom* contact) {
  constexpr double kAlong = 0.5;
  const Eigen::Matrix3d map_from_box = RotationOf(box);
  const dReal* center = dGeomGetPosition(box);
  dVector3 lengths;
  dGeomBoxGetLengths(box, lengths);
  const Eigen::Vector3d at =
      map_from_box.transpose() * (axis_point_m - Eigen::Vector3d(center[0], center[1], center[2]));
  const Eigen::Vector3d along = map_from_box.transpose() * axis;
  int face = -1;
  double nearest_m = 0.0;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(along[i]) > kAlong) continue;
    const double inside_m = 0.5 * lengths[i] - std::abs(at[i]);
    if (face >= 0 && inside_m >= nearest_m) continue;
    face = i;
    nearest_m = inside_m;
  }
  if (face < 0) {  // it lies across all three: by what is least along it
    along.cwiseAbs().minCoeff(&face);
    nearest_m = 0.5 * lengths[face] - std::abs(at[face]);
  }
  const double sign = at[face] < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d normal = sign * map_from_box.col(face);
  for (int i = 0; i < 3; ++i) {
    contact->pos[i] = axis_point_m[i];
    contact->normal[i] = normal[i];
  }
  contact->depth = std::max(nearest_m, 0.0) + radius_m;
}

// ODE gives one contact for a capsule and a box, and no useful one where the capsule's axis is in
// the box. Balls at its ends make up for the first, so that a log lies still on a deck.
void CollideCapsuleAndBox(dGeomID capsule, dGeomID box, SolidContacts* contacts) {
  dReal radius_m = 0.0, length_m = 0.0;
  dGeomCapsuleGetParams(capsule, &radius_m, &length_m);
  const dReal* center = dGeomGetPosition(capsule);
  const Eigen::Vector3d center_m(center[0], center[1], center[2]);
  const Eigen::Vector3d axis = RotationOf(capsule).col(2);
  double deepest_m = 0.0;
  for (const double end : {-0.5, 0.5}) {
    dContactGeom* contact = &contacts->contact[static_cast<std::size_t>(contacts->count)];
    const Eigen::Vector3d end_m = center_m + end * length_m * axis;
    if (!TouchBallAndBox(end_m, radius_m, box, contact)) continue;
    deepest_m = std::max(deepest_m, contact->depth);
    ++contacts->count;
  }
  dContactGeom* contact = &contacts->contact[static_cast<std::size_t>(contacts->count)];
  if (dCollide(capsule, box, 1, contact, sizeof(dContactGeom)) != 1) return;
  if (contact->depth < radius_m * (1.0 - 1e-6)) {
    if (contact->depth > deepest_m + 1e-4) ++contacts->count;
    return;
  }
  if (deepest_m > 0.0) return;
  const dReal* box_center = dGeomGetPosition(box);
  const Eigen::Vector3d to_box =
      Eigen::Vector3d(box_center[0], box_center[1], box_center[2]) - center_m;
  const double on_axis_m = std::clamp(to_box.dot(axis), -0.5 * length_m, 0.5 * length_m);
  LeaveBox(center_m + on_axis_m * axis, axis, radius_m, box, contact);
  ++contacts->count;
}

}  // namespace

Solid::Solid(const BodyShape& shape)
    : shape_(shape),
      part_from_shape_(shape.orientation.normalized().toRotationMatrix()),
      geom_(GeomOf(shape)) {}

Solid::~Solid() {
  if (geom_ != nullptr) dGeomDestroy(geom_);
}

Solid::Solid(Solid&& other) noexcept
    : shape_(other.shape_),
      part_from_shape_(other.part_from_shape_),
      geom_(other.geom_),
      bounds_(other.bounds_) {
  other.geom_ = nullptr;
}

void Solid::SetPose(const Eigen::Vector3d& position_m, const dReal* r) {
  Eigen::Matrix3d map_from_part;
  map_from_part << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  const Eigen::Vector3d center = position_m + map_from_part * shape_.center_m;
  dGeomSetPosition(geom_, center.x(), center.y(), center.z());
  Eigen::Vector3d extent = Eigen::Vector3d::Constant(shape_.radius_m);
  if (shape_.form != ShapeForm::kBall) {
    const Eigen::Matrix3d map_from_shape = map_from_part * part_from_shape_;
    dMatrix3 rotation = {};
    for (int row = 0; row < 3; ++row) {
      for (int col = 0; col < 3; ++col) rotation[4 * row + col] = map_from_shape(row, col);
    }
    dGeomSetRotation(geom_, rotation);
    if (shape_.form == ShapeForm::kBox) {
      extent = map_from_shape.cwiseAbs() * shape_.half_extents_m;
    } else {
      extent += shape_.half_length_m * map_from_shape.col(2).cwiseAbs();
    }
  }
  bounds_ = {center - extent, center + extent};
}

BodyShape SolidShapeOf(const Asset& asset) {
  BodyShape shape;
  const double base_m = asset.z_m, top_m = base_m + asset.height_m;
  const double low_m = base_m - kDepthInGround_m;
  if (asset.kind == AssetKind::kBuilding) {
    shape.form = ShapeForm::kBox;
    shape.center_m = {asset.x_m, asset.y_m, 0.5 * (low_m + top_m)};
    shape.orientation = Eigen::AngleAxisd(asset.yaw_rad, Eigen::Vector3d::UnitZ());
    shape.half_extents_m = {asset.half_length_m, asset.half_width_m, 0.5 * (top_m - low_m)};
    return shape;
  }
  shape.form = ShapeForm::kCapsule;
  shape.radius_m = std::max(SolidRadius(asset), 1e-3);
  const double straight_m = std::max(top_m - shape.radius_m, base_m + 0.5 * asset.height_m);
  shape.half_length_m = 0.5 * (straight_m - low_m);
  shape.center_m = {asset.x_m, asset.y_m, 0.5 * (low_m + straight_m)};
  return shape;
}

void Collide(const Solid& a, const Solid& b, SolidContacts* contacts) {
  constexpr int kRoom = 3 * kMaxPairContacts;
  if (contacts->count + kMaxPairContacts > kRoom) return;
  const ShapeForm of_a = a.shape().form, of_b = b.shape().form;
  if (of_a == ShapeForm::kCapsule && of_b == ShapeForm::kBox) {
    CollideCapsuleAndBox(a.geom(), b.geom(), contacts);
    return;
  }
  const int first = contacts->count;
  if (of_a == ShapeForm::kBox && of_b == ShapeForm::kCapsule) {
    CollideCapsuleAndBox(b.geom(), a.geom(), contacts);
    for (int i = first; i < contacts->count; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        dReal& n = contacts->contact[static_cast<std::size_t>(i)].normal[axis];
        n = -n;
      }
    }
    return;
  }
  contacts->count +=
      dCollide(a.geom(), b.geom(), kMaxPairContacts,
               &contacts->contact[static_cast<std::size_t>(first)], sizeof(dContactGeom));
}

bool StandsOn(const Solid& box, const Eigen::Vector3d& center_m, double radius_m,
              dContactGeom* contact) {
  constexpr double kHighestStep_m = 0.3;
  constexpr double kLevel = 0.7;  // cosine of the steepest top that carries
  if (box.shape().form != ShapeForm::kBox) return false;
  const dReal* r = dGeomGetRotation(box.geom());
  const dReal* at = dGeomGetPosition(box.geom());
  int upright = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(r[8 + axis]) > std::abs(r[8 + upright])) upright = axis;
  }
  if (std::abs(r[8 + upright]) < kLevel) return false;
  const Eigen::Vector3d from_box = center_m - Eigen::Vector3d(at[0], at[1], at[2]);
  const Eigen::Vector3d& half = box.shape().half_extents_m;
  double depth_m = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d along(r[axis], r[4 + axis], r[8 + axis]);
    const double offset_m = from_box.dot(along);
    if (axis == upright) {
      normal = along.z() > 0.0 ? along : Eigen::Vector3d(-along);
      depth_m = half[axis] - from_box.dot(normal) + radius_m;
      if (depth_m <= 0.0 || depth_m > std::min(kHighestStep_m, 2.0 * half[axis])) return false;
    } else if (std::abs(offset_m) > half[axis]) {
      return false;
    }
  }
  const Eigen::Vector3d foot = center_m - radius_m * normal;
  for (int i = 0; i < 3; ++i) {
    contact->pos[i] = foot[i];
    contact->normal[i] = normal[i];
  }
  contact->depth = depth_m;
  return true;
}

}  // namespace latticeworld
