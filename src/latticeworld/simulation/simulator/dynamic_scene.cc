#include "latticeworld/simulation/simulator/dynamic_scene.h"

#include <utility>

#include "latticeworld/simulation/bridge_bodies.h"
#include "latticeworld/simulation/ode/ode_world.h"

namespace latticeworld {

DynamicScene::DynamicScene(std::shared_ptr<const Scene> scene, int physics_threads)
    : scene_(std::move(scene)), physics_threads_(physics_threads) {}

void DynamicScene::Begin() {
  props_.reset();
  felling_.reset();
  physics_ = MakeOdeWorld(scene_, physics_threads_);
  physics_->SetJudge(this);
  felling_.emplace(*scene_, physics_.get());
  props_.emplace(*scene_, physics_.get());
  AddBridgeBodies(*scene_->terrain, physics_.get());
}

std::string DynamicScene::NameOf(BodyId body) const {
  if (const auto tree = felling_->AssetOf(body)) return Felling::NameOf(*tree);
  return props_->NameOf(body);
}

void DynamicScene::Act(const Atmosphere& atmosphere, double step_s) {
  felling_->Act(atmosphere);
  props_->Act(atmosphere, step_s);
}

DynamicScene::Outcome DynamicScene::Step(const SimulationClock& clock,
                                         const std::function<std::string(BodyId)>& name_of,
                                         EventLog* events) {
  // Props first: trees that leave the world take the bodies of their contacts with them.
  bool props = props_->Step(clock.step_s(), clock.step(), events->list());
  const Felling::Outcome trees =
      felling_->Step(clock.step_s(), clock.step(), name_of, events->list());
  if (clock.HasTurn(0)) props |= props_->Follow();
  Outcome outcome;
  outcome.changes = props || trees.changes;
  outcome.maps = props || trees.maps;
  return outcome;
}

DynamicScene::State DynamicScene::Save() const {
  State state;
  state.physics = physics_->Save();
  state.trees = felling_->state();
  state.props = props_->state();
  return state;
}

void DynamicScene::Restore(const State& state) {
  physics_->Restore(*state.physics);
  felling_->Restore(state.trees);
  props_->Restore(state.props);
}

void DynamicScene::AddTo(Digest* digest) const {
  felling_->AddTo(digest);
  props_->AddTo(digest);
  physics_->AddTo(digest);
}

bool DynamicScene::GivesWay(const Contact& contact) {
  switch (contact.kind) {
    case ContactKind::kAsset:
      return felling_->GivesWay(contact);
    case ContactKind::kBody:
      return props_->GivesWay(contact);
    default:
      return false;
  }
}

}  // namespace latticeworld
