#include <map>
#include <utility>

#include "latticeworld/simulation/agents/minds/behaviour_tree.h"
#include "latticeworld/simulation/agents/minds/fights.h"
#include "latticeworld/simulation/agents/minds/pieces_cunning.h"
#include "latticeworld/simulation/agents/minds/pieces_fear.h"
#include "latticeworld/simulation/agents/minds/pieces_hunt.h"
#include "latticeworld/simulation/agents/minds/pieces_peaceful.h"
#include "latticeworld/simulation/agents/minds/policy.h"
#include "latticeworld/simulation/agents/ways/places.h"
#include "latticeworld/simulation/simulator.h"

namespace latticeworld {
namespace {

class TreePolicy : public Policy {
 public:
  explicit TreePolicy(Piece root) : root_(std::move(root)) {}

  Steering Decide(Agent* agent, Surroundings* world) const override {
    const auto steering = root_->Try(agent, world);
    return steering.has_value() ? *steering : StandHere(*agent);
  }
  const BehaviourPiece* tree() const override { return root_.get(); }

 private:
  const Piece root_;
};

// Does what Simulator::Command says, and stands without (WantedVelocity).
class ExternalPolicy : public Policy {
 public:
  Steering Decide(Agent* agent, Surroundings*) const override {
    TakeUp(agent, Behaviour::kControlled);
    agent->mind.target = 0;  // what it is after, nobody knows: packs do without it
    return StandHere(*agent);
  }
};

bool Strikes(const Agent& agent, const Surroundings&) { return CanStrike(agent); }
bool StrikesNot(const Agent& agent, const Surroundings&) { return !CanStrike(agent); }

// Pieces in the order in which they are asked.
template <typename... Pieces>
Piece First(Pieces... pieces) {
  std::vector<Piece> list;
  (list.push_back(std::move(pieces)), ...);
  return FirstOf(std::move(list));
}

Piece RetreatWhenHurt() { return When("when hurt", IsHurt, Do("retreat", Retreat)); }

Piece AttackOrPursue() { return First(Do("attack", Attack), Do("pursue", Pursue)); }

// Lives by its piece as long as nobody harms it.
Piece Peaceful(Piece calm) {
  Piece fight = WithTarget("with an enemy upon it", ChooseAssailant, AttackOrPursue());
  return First(When("when it can strike", Strikes, First(RetreatWhenHurt(), std::move(fight))),
               When("when it cannot strike", StrikesNot, Do("flee", Flee)), std::move(calm));
}

// Hunts as its pieces say while it has prey, and looks for some without.
template <typename... Pieces>
Piece Hunter(Pieces... hunt) {
  return First(RetreatWhenHurt(), WithTarget("with prey", ChoosePrey, First(std::move(hunt)...)),
               Do("look into a noise", LookIntoNoise), Do("patrol", Patrol));
}

Piece Pursuer() { return Hunter(Do("attack", Attack), Do("pursue", Pursue), Do("search", Search)); }

Piece Interceptor() {
  return Hunter(Do("attack", Attack), Do("intercept", Intercept), Do("search", Search));
}

Piece Raider() {
  return Hunter(Do("withdraw after a blow", Withdraw), Do("attack", Attack), Do("pursue", Pursue),
                Do("search", Search));
}

Piece Encircler() {
  return First(
      RetreatWhenHurt(),
      WithTarget("with prey of its own or a mate's", ChooseSharedPrey,
                 First(Do("attack", Attack),
                       When("when it hunts in a pack", HuntsInPack, Do("encircle", Encircle)),
                       Do("pursue", Pursue), Do("search", Search))),
      Do("patrol", Patrol));
}

Piece Ambusher() {
  return First(RetreatWhenHurt(),
               WithTarget("with somebody close by", ChooseVictim, AttackOrPursue()),
               Do("ambush", Ambush));
}

Piece Guardian() {
  return First(WithTarget("with an intruder", ChooseIntruder, AttackOrPursue()),
               Do("guard", Guard));
}

using Registry = std::map<std::string, std::unique_ptr<const Policy>, std::less<>>;

Registry BuiltInPolicies() {
  Registry policies;
  const auto add = [&](const char* name, Piece root) {
    policies.emplace(name, std::make_unique<TreePolicy>(std::move(root)));
  };
  add("idler", Peaceful(Do("idle", Idle)));
  add("wanderer", Peaceful(Do("wander", Wander)));
  add("patroller", Peaceful(Do("patrol", Patrol)));
  add("grazer", Peaceful(First(Do("graze", Graze), Do("idle", Idle))));
  add("swimmer", Peaceful(First(Do("swim", Swim), Do("idle", Idle))));
  add("soarer", Peaceful(First(Do("soar", Soar), Do("idle", Idle))));
  add("pursuer", Pursuer());
  add("interceptor", Interceptor());
  add("raider", Raider());
  add("encircler", Encircler());
  add("ambusher", Ambusher());
  add("guard", Guardian());
  policies.emplace("external", std::make_unique<ExternalPolicy>());
  return policies;
}

Registry& Policies() {
  static Registry* const policies = new Registry(BuiltInPolicies());
  return *policies;
}

}  // namespace

const Policy* FindPolicy(std::string_view name) {
  const auto found = Policies().find(name);
  return found == Policies().end() ? nullptr : found->second.get();
}

std::vector<std::string> PolicyNames() {
  std::vector<std::string> names;
  for (const auto& [name, policy] : Policies()) names.push_back(name);
  return names;
}

std::string UsualPolicy(AgentCategory category, AgentState state) {
  const bool adversary =
      category == AgentCategory::kGoblin || category == AgentCategory::kAncientWarrior;
  switch (state) {
    case AgentState::kIdle:
      return adversary ? "guard" : "idler";
    case AgentState::kPatrolling:
      return adversary ? "pursuer" : "patroller";
    case AgentState::kGrazing:
      return "grazer";
    case AgentState::kSwimming:
      return "swimmer";
    case AgentState::kFlying:
      return "soarer";
    case AgentState::kPursuing:
    case AgentState::kAttacking:
      return "pursuer";
  }
  return "idler";
}

bool RegisterPolicy(std::string name, std::unique_ptr<const Policy> policy) {
  if (name.empty() || policy == nullptr) return false;
  return Policies().emplace(std::move(name), std::move(policy)).second;
}

}  // namespace latticeworld
