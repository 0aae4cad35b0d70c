#ifndef LATTICEWORLD_SIMULATION_ODE_CONTACTS_CONTACT_JOINTS_H_
#define LATTICEWORLD_SIMULATION_ODE_CONTACTS_CONTACT_JOINTS_H_

#include <ode/ode.h>

#include <Eigen/Core>
#include <vector>

#include "latticeworld/simulation/ode/body/ode_body.h"
#include "latticeworld/simulation/ode/contacts/traction.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// How a contact pushes apart: a spring and damper under an implicit step.
struct Compliance {
  double stiffness_npm = 0.0;  // 0: as stiff as the solver likes it
  double damping_nspm = 0.0;
};

// One side of a contact.
struct ContactSide {
  OdeBody* body = nullptr;
  std::size_t part = 0;

  dBodyID id() const { return body != nullptr ? body->parts().part(part) : nullptr; }
};

// A contact to be solved.
struct ContactJoint {
  ContactSide a;  // never nobody
  ContactSide b;  // nobody: what stands fast
  Eigen::Vector3d position_m;
  Eigen::Vector3d normal;  // into a
  double depth_m;
  Traction traction;
  Compliance compliance{};
  int reported = -1;       // index of the Contact that takes its force
  bool of_two = false;     // bodies, of which the second one may stand fast
  bool counts = false;     // towards the limit of contacts a body
  bool gives_way = false;  // what is hit holds nothing up
};

// The contacts of the bodies of one world of ODE in one step, from when they are found until their
// forces are known.
class ContactJoints {
 public:
  explicit ContactJoints(dWorldID world);
  ~ContactJoints();
  ContactJoints(const ContactJoints&) = delete;
  ContactJoints& operator=(const ContactJoints&) = delete;

  void Add(const ContactJoint& joint) { found_.push_back(joint); }
  const std::vector<ContactJoint>& found() const { return found_; }
  void LetGiveWay(std::size_t i) { found_[i].gives_way = true; }
  // Makes joints of them in the order in which they were added, but for what gives way; of a body's
  // contacts that are counted only the deepest.
  void Join(double step_s);
  // Writes, after the world's step, what the contacts exerted to those that are reported, two
  // bodies' and others in a list each, and forgets them.
  void Finish(std::vector<Contact>* of_two, std::vector<Contact>* of_one);

 private:
  void DropBeyondLimit();
  void JoinOne(const ContactJoint& joint, double step_s, dJointFeedback* feedback);

  const dWorldID world_;
  const dJointGroupID group_;
  std::vector<ContactJoint> found_;
  std::vector<dJointFeedback> feedback_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_CONTACTS_CONTACT_JOINTS_H_
