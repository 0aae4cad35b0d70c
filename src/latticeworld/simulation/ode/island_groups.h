#ifndef LATTICEWORLD_SIMULATION_ODE_ISLAND_GROUPS_H_
#define LATTICEWORLD_SIMULATION_ODE_ISLAND_GROUPS_H_

#include <chrono>
#include <cstddef>
#include <memory>
#include <vector>

#include "latticeworld/common/work_crew.h"
#include "latticeworld/simulation/ode/contacts/contact_joints.h"
#include "latticeworld/simulation/ode/island_group.h"
#include "latticeworld/simulation/ode/ode_bodies.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/physics_world.h"

namespace latticeworld {

// What a step found and did.
struct StepReport {
  std::vector<Contact> contacts;
  std::vector<BodyId> strayed;
  std::vector<BodyId> slowed;
};

// Which bodies of an OdeWorld are stepped together, and the threads that step them.
class IslandGroups {
 public:
  // threads: 0: as many as cores.
  explicit IslandGroups(int threads);
  IslandGroups(const IslandGroups&) = delete;
  IslandGroups& operator=(const IslandGroups&) = delete;

  // Returns the place of a body that touches nobody.
  GroupPlace HomeOf(BodyId id) const { return PlaceOf(id % groups_.size()); }

  // The parts of a step, in their order. Bodies that joints hold together come into one group.
  void Regroup(const std::vector<ContactJoint>& joints, OdeBodies* bodies);
  // Lists the members of groups and the joints between them.
  void Gather(const std::vector<ContactJoint>& joints, const OdeBodies& bodies);
  // Has each group done, several at once where enough moves to be worth it. one(IslandGroup*).
  template <typename Do>
  void ForEach(const Do& one) {
    const auto run = [&](int i) {
      ReadyOde();
      one(groups_[static_cast<std::size_t>(i)].get());
    };
    const int count = static_cast<int>(groups_.size());
    if (in_threads_) return crew_->Run(count, run);
    for (int i = 0; i < count; ++i) run(i);
  }
  // Asks the judge about what was hit; false: nothing was of which it is to be asked.
  bool Ask(ContactJudge* judge);
  // Adds the contacts that the groups found to those of two bodies, in the order of the bodies, and
  // lists what became of these.
  void Collect(const OdeBodies& bodies, StepReport* report);
  // Returns how long the groups looked for contacts, all threads taken together.
  std::chrono::nanoseconds SearchTime() const;

 private:
  GroupPlace PlaceOf(std::size_t group) const;
  // Notes by index of a body the group that it is to be in. homing: those that parted go home.
  void FindWanted(const std::vector<ContactJoint>& joints, const OdeBodies& bodies, bool homing);

  std::vector<std::unique_ptr<IslandGroup>> groups_;
  const int threads_;
  std::unique_ptr<WorkCrew> crew_;  // null: not needed yet
  bool in_threads_ = false;         // this step
  int steps_since_homing_ = 0;
  std::vector<std::size_t> wanted_, first_;  // by index of a body: group, first that it touches
  std::vector<std::size_t> next_;            // by group: the contact to be listed next
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SIMULATION_ODE_ISLAND_GROUPS_H_
