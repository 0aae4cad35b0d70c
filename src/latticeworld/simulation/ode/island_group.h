#ifndef LATTICEWORLD_SIMULATION_ODE_ISLAND_GROUP_H_
#define LATTICEWORLD_SIMULATION_ODE_ISLAND_GROUP_H_

#include <ode/ode.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "latticeworld/simulation/ode/body/ode_body.h"
#include "latticeworld/simulation/ode/contacts/contact_joints.h"
#include "latticeworld/simulation/ode/contacts/ground_contact.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// A world of ODE with some of the bodies of an OdeWorld: bodies that touch are in one group, so
// that groups are stepped side by side by several threads. What becomes of a body depends on what
// it touches alone, not on who else is in its group: members are made in the order of their ids,
// and StepOde knows no other islands.
class IslandGroup {
 public:
  IslandGroup();
  IslandGroup(const IslandGroup&) = delete;
  IslandGroup& operator=(const IslandGroup&) = delete;

  dWorldID world() const { return world_.get(); }
  // Forgets the members and the step before.
  void Clear();
  // Adds a member; members are added in the order of their ids.
  void Add(OdeBody* member) { members_.push_back(member); }
  const std::vector<OdeBody*>& members() const { return members_; }

  // Solves for what is joined and moves what is awake. of_two: contacts of two bodies, of which
  // those of its members take their forces.
  void Step(double step_s, std::uint64_t solver_seed, std::vector<Contact>* of_two);

  // What a step found, by whoever looks for contacts of its members.
  std::vector<Contact> contacts;  // with ground, assets and boundary; by member
  // A contact with an asset about which the judge is to be asked.
  struct Asked {
    BodyId body = 0;
    std::size_t contact = 0, joint = 0;  // places in contacts and among joints
  };
  std::vector<Asked> asked;
  std::chrono::nanoseconds search_time{};  // for contacts
  ContactJoints* joints() { return &joints_; }
  const std::vector<BodyId>& strayed() const { return strayed_; }
  const std::vector<BodyId>& slowed() const { return slowed_; }

  // Kept between bodies and steps.
  struct SampleTouch {
    GroundContact contact;
    std::size_t part = 0;
    bool walks = false;
  };
  std::vector<SampleTouch> sample_touch;    // of the body at hand
  std::vector<GroundContacts> wheel_touch;  // of the body at hand
  SolidContacts solid_touch;                // of the pair at hand

 private:
  // Bodies with links or brakes on, and what they touch, are solved with more iterations than
  // others.
  void Solve(double step_s, std::uint64_t solver_seed);
  // Finds the bodies to which a step gave more energy than anything that acted on them, and slows
  // them down to what can have been given.
  void WatchEnergy(double step_s);
  std::size_t PlaceOf(const OdeBody* member) const;
  void SetEnabled(char which, bool enabled);

  // Released from the last to the first.
  OdeThreading threading_;
  OdeWorldHandle world_;
  ContactJoints joints_;
  std::vector<OdeBody*> members_;  // by id
  std::vector<BodyId> strayed_, slowed_;

  std::vector<char> fine_;        // by place in members_: how it is solved
  std::vector<double> gained_j_;  // by place in members_, in the step at hand
  std::vector<char> overdrawn_;   // by place in members_, in the step at hand
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ISLAND_GROUP_H_
