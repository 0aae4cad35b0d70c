#include "language/grounded/synthesis/plan_writer.h"

namespace latticeworld {

Zone ZoneNamed(const std::string& name) { return FindZone(name).value(); }

Claim Says(ClaimKind kind, char subject, const std::string& zone, double least, double most) {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.zone = ZoneNamed(zone);
  claim.least = least;
  claim.most = most;
  return claim;
}

Claim Ties(ClaimKind kind, char subject, char object, char second) {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.object = object;
  claim.second_object = second;
  return claim;
}

Claim Gap(ClaimKind kind, char subject, char object, double least, double most) {
  Claim claim = Ties(kind, subject, object);
  claim.least = least;
  claim.most = most;
  return claim;
}

Claim Toward(char subject, char object, int east, int south) {
  Claim claim = Ties(ClaimKind::kDirection, subject, object);
  claim.heading = {east, south};
  return claim;
}

Claim Runs(char subject, const std::string& from, const std::string& to) {
  Claim claim;
  claim.kind = ClaimKind::kCourse;
  claim.subject = subject;
  claim.from = ZoneNamed(from);
  claim.to = ZoneNamed(to);
  return claim;
}

Claim Order(const std::string& sequence, int east, int south) {
  Claim claim;
  claim.kind = ClaimKind::kOrder;
  claim.sequence = sequence;
  claim.subject = sequence.front();
  claim.heading = {east, south};
  return claim;
}

Claim Rest(char subject, const std::string& others) {
  Claim claim;
  claim.kind = ClaimKind::kRest;
  claim.subject = subject;
  claim.sequence = others;
  return claim;
}

Claim Shaped(char subject, ClaimShape shape) {
  Claim claim;
  claim.kind = ClaimKind::kShape;
  claim.subject = subject;
  claim.shape = shape;
  return claim;
}

}  // namespace latticeworld
