// How OdeWorld is kept, brought back and hashed.

#include "latticeworld/common/check.h"
#include "latticeworld/common/digest.h"
#include "latticeworld/simulation/ode/ode_library.h"
#include "latticeworld/simulation/ode/ode_world_impl.h"

namespace latticeworld {
namespace {

class OdeSnapshot : public PhysicsSnapshot {
 public:
  struct Body {
    BodyId id;
    std::shared_ptr<const BodySpec> spec;
    BodyState state;
  };
  std::vector<Body> bodies;
  BodyId last_id = 0;
  GroundState ground;
  std::array<double, kSurfaceClassCount> woken_friction{};
  std::set<std::uint32_t> gone_assets;
  std::vector<Contact> contacts;
  std::vector<BodyId> strayed;
};

}  // namespace

std::shared_ptr<const PhysicsSnapshot> OdeWorld::Save() const {
  auto snapshot = std::make_shared<OdeSnapshot>();
  snapshot->bodies.reserve(bodies_.size());
  for (const Entry& entry : bodies_) {
    snapshot->bodies.push_back({entry.id, entry.body->shared_spec(), entry.body->Save()});
  }
  snapshot->last_id = last_id_;
  snapshot->ground = ground_;
  snapshot->woken_friction = woken_friction_;
  snapshot->gone_assets = gone_assets_;
  snapshot->contacts = contacts_;
  snapshot->strayed = strayed_;
  return snapshot;
}

void OdeWorld::Restore(const PhysicsSnapshot& snapshot) {
  ReadyOde();
  const auto* saved = dynamic_cast<const OdeSnapshot*>(&snapshot);
  LW_CHECK(saved != nullptr, "a snapshot of another back end");
  // Where other bodies are about, all are made anew. In which groups they were makes no difference.
  bool same = bodies_.size() == saved->bodies.size();
  for (std::size_t i = 0; same && i < bodies_.size(); ++i) {
    same = bodies_[i].id == saved->bodies[i].id &&
           bodies_[i].body->shared_spec() == saved->bodies[i].spec;
  }
  if (!same) {
    sweep_.Clear();
    bodies_.clear();
    for (const OdeSnapshot::Body& one : saved->bodies) {
      const std::size_t home = HomeOf(one.id);
      const dWorldID world = groups_[home]->world();
      bodies_.push_back({one.id, std::make_unique<OdeBody>(world, one.id, one.spec), home, {}});
      OdeBody* body = bodies_.back().body.get();
      if (body->ball_radius_m() >= 0.0) sweep_.Add(body);
    }
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].body->Restore(saved->bodies[i].state);
  sweep_.Unsettle();
  last_id_ = saved->last_id;
  ground_ = saved->ground;
  surfaces_ = SurfaceTable(*scene_, ground_);
  woken_friction_ = saved->woken_friction;
  gone_assets_ = saved->gone_assets;
  contacts_ = saved->contacts;
  strayed_ = saved->strayed;
  slowed_.clear();
}

void OdeWorld::AddTo(Digest* digest) const {
  digest->Add(last_id_);
  digest->Add(ground_.wetness);
  digest->Add(ground_.snow_depth_m);
  digest->Add(ground_.blown_sand);
  for (const double friction : woken_friction_) digest->Add(friction);
  digest->Add(static_cast<std::uint64_t>(gone_assets_.size()));
  for (const std::uint32_t asset : gone_assets_) digest->Add(asset);
  for (const Entry& entry : bodies_) {
    digest->Add(entry.id);
    entry.body->AddTo(digest);
  }
}

}  // namespace latticeworld
