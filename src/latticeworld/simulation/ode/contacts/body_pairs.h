#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_BODY_PAIRS_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_BODY_PAIRS_H_

#include <ode/ode.h>

#include <vector>

#include "latticeworld/simulation/ode/body/ode_body.h"
#include "latticeworld/simulation/ode/contacts/body_sweep.h"
#include "latticeworld/simulation/ode/contacts/contact_joints.h"
#include "latticeworld/simulation/ode/contacts/solid.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// Finds which bodies of an OdeWorld touch each other in a step.
class BodyPairs {
 public:
  // Adds their contacts, and keeps the joints between them until it is called again. judge: decides
  // whether anchored bodies give way; nullptr: none does.
  void Find(BodySweep<OdeBody>* sweep, ContactJudge* judge, std::vector<Contact>* contacts);
  const std::vector<ContactJoint>& joints() const { return joints_; }

 private:
  // What is the same for all pairs of a step.
  struct Search {
    ContactJudge* judge;
    std::vector<Contact>* contacts;
  };
  void TouchPair(const Search& search, OdeBody* a, OdeBody* b);
  void TouchDeck(const Search& search, OdeBody* body, OdeBody* deck);
  void Push(const Search& search, ContactSide a, ContactSide b, const dContactGeom& geom);

  SolidContacts touch_;               // of the pair at hand
  std::vector<ContactJoint> joints_;  // of two bodies, in the step at hand
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_BODY_PAIRS_H_
