#include "latticeworld/simulation/agents/bodies/footing.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/simulation/agents/ways/steering.h"

namespace latticeworld {

Footing::Footing(const Surroundings& world, const Agent& agent, double reach_m)
    : ground_(world.scene->terrain->ground), props_(PropsIn(*world.scene, *world.changes)) {
  constexpr double kStepUp_m = 0.25;  // a deck that is higher above its base is over its head
  for (const PropDeck& deck : props_->decks) {
    if (deck.top_m > agent.motion.position_m.z() + kStepUp_m) continue;
    const double near_m = deck.footprint.radius_m() + reach_m;
    if (DistanceBetween(deck.footprint.centre, agent.place()) <= near_m) decks_.push_back(&deck);
  }
}

double Footing::HeightAt(WorldPoint place) const {
  double height_m = ground_.HeightAt(place);
  for (const PropDeck* const deck : decks_) {
    if (GapTo(deck->footprint, place) <= 0.0) height_m = std::max(height_m, deck->top_m);
  }
  return height_m;
}

bool StandsOnDeck(const Surroundings& world, const Agent& agent) {
  constexpr double kOn_m = 0.1;
  const double base_m = agent.motion.position_m.z();
  const auto props = PropsIn(*world.scene, *world.changes);
  return std::any_of(props->decks.begin(), props->decks.end(), [&](const PropDeck& deck) {
    return std::abs(deck.top_m - base_m) <= kOn_m && GapTo(deck.footprint, agent.place()) <= 0.0;
  });
}

bool IsCarried(const StandingProps& props, WorldPoint place, double margin_m, double mass_kg) {
  for (const PropDeck& deck : props.decks) {
    if (mass_kg <= deck.carries_kg && GapTo(deck.footprint, place) <= -margin_m) return true;
  }
  return false;
}

}  // namespace latticeworld
