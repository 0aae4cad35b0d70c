#include "language/grounded/synthesis/plan_writer.h"

namespace latticeworld {

Zone ZoneNamed(const std::string& name) { return FindZone(name).value(); }

Claim Says(ClaimKind kind, char subject, const std::string& zone, double least, double most) {
  return WithBounds(About(kind, subject, zone), least, most);
}

Claim Gap(ClaimKind kind, char subject, char object, double least, double most) {
  return WithBounds(About(kind, subject, object), least, most);
}

Claim Toward(char subject, char object, int east, int south) {
  return Directed(ClaimKind::kDirection, subject, object, {east, south});
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

}  // namespace latticeworld
