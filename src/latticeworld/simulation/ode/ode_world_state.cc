// How OdeWorld is kept, brought back and hashed.

#include <set>

#include "latticeworld/common/check.h"
#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

class OdeSnapshot : public PhysicsSnapshot {
 public:
  struct Body {
    BodyId id = 0;
    std::shared_ptr<const BodySpec> spec;
    BodyState state;
  };
  std::vector<Body> bodies;
  BodyId last_id = 0;
  OdeGround::State ground;
  std::set<std::uint32_t> gone_assets;
  std::vector<Contact> contacts;
  std::vector<BodyId> strayed;
};

// Whether the same bodies are about as were then.
bool HasBodiesOf(const OdeSnapshot& saved, const OdeBodies& bodies) {
  if (bodies.all().size() != saved.bodies.size()) return false;
  for (std::size_t i = 0; i < saved.bodies.size(); ++i) {
    const OdeBodies::Entry& entry = bodies.all()[i];
    if (entry.id != saved.bodies[i].id) return false;
    if (entry.body->shared_spec() != saved.bodies[i].spec) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const PhysicsSnapshot> OdeWorld::Save() const {
  auto snapshot = std::make_shared<OdeSnapshot>();
  snapshot->bodies.reserve(bodies_.all().size());
  for (const OdeBodies::Entry& entry : bodies_.all()) {
    OdeSnapshot::Body& body = snapshot->bodies.emplace_back();
    body.id = entry.id;
    body.spec = entry.body->shared_spec();
    body.state = entry.body->Save();
  }
  snapshot->last_id = last_id_;
  snapshot->ground = ground_.state();
  snapshot->gone_assets = assets_.gone();
  snapshot->contacts = report_.contacts;
  snapshot->strayed = report_.strayed;
  return snapshot;
}

void OdeWorld::Restore(const PhysicsSnapshot& snapshot) {
  ReadyOde();
  const auto* saved = dynamic_cast<const OdeSnapshot*>(&snapshot);
  LW_CHECK(saved != nullptr, "a snapshot of another back end");
  // If other bodies are about, all are made anew. In which groups they were makes no difference.
  if (!HasBodiesOf(*saved, bodies_)) {
    bodies_.Clear();
    for (const OdeSnapshot::Body& one : saved->bodies) {
      bodies_.Add(one.id, one.spec, groups_.HomeOf(one.id));
    }
  }
  for (std::size_t i = 0; i < saved->bodies.size(); ++i) {
    bodies_.all()[i].body->Restore(saved->bodies[i].state);
  }
  bodies_.sweep()->Unsettle();
  last_id_ = saved->last_id;
  ground_.Restore(saved->ground);
  assets_.Restore(saved->gone_assets);
  report_.contacts = saved->contacts;
  report_.strayed = saved->strayed;
  report_.slowed.clear();
}

void OdeWorld::AddTo(Digest* digest) const {
  digest->Add(last_id_);
  ground_.AddTo(digest);
  assets_.AddTo(digest);
  for (const OdeBodies::Entry& entry : bodies_.all()) {
    digest->Add(entry.id);
    entry.body->AddTo(digest);
  }
}

}  // namespace latticeworld
