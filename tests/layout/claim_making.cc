#include "layout/claim_making.h"

namespace latticeworld {

Claim About(ClaimKind kind, char subject, const std::string& zone) {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.zone = FindZone(zone).value();
  return claim;
}

Claim About(ClaimKind kind, char subject, char object, char second_object) {
  Claim claim;
  claim.kind = kind;
  claim.subject = subject;
  claim.object = object;
  claim.second_object = second_object;
  return claim;
}

Claim WithBounds(Claim claim, double least, double most) {
  claim.least = least;
  claim.most = most;
  return claim;
}

Claim Course(char subject, const std::string& from, const std::string& to) {
  Claim claim = About(ClaimKind::kCourse, subject);
  claim.from = FindZone(from).value();
  claim.to = FindZone(to).value();
  return claim;
}

Claim Directed(ClaimKind kind, char subject, char object, Claim::Heading heading) {
  Claim claim = About(kind, subject, object);
  claim.heading = heading;
  return claim;
}

Claim Shaped(char subject, ClaimShape shape) {
  Claim claim = About(ClaimKind::kShape, subject);
  claim.shape = shape;
  return claim;
}

}  // namespace latticeworld
