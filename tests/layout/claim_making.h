#ifndef LATTICEWORLD_TESTS_LAYOUT_CLAIM_MAKING_H_
#define LATTICEWORLD_TESTS_LAYOUT_CLAIM_MAKING_H_

#include <string>

#include "latticeworld/layout/claims/claims.h"

namespace latticeworld {

// A claim about one class, in a zone with a name.
Claim About(ClaimKind kind, char subject, const std::string& zone = "anywhere");
// A claim about two classes, or three.
Claim About(ClaimKind kind, char subject, char object, char second_object = '\0');
Claim WithBounds(Claim claim, double least, double most = Claim::kUnsaid);
Claim Course(char subject, const std::string& from, const std::string& to);
Claim Directed(ClaimKind kind, char subject, char object, Claim::Heading heading);
Claim Shaped(char subject, ClaimShape shape);

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_LAYOUT_CLAIM_MAKING_H_
