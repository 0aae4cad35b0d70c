#include "latticeworld/viewer/viewer_feed.h"

#include <utility>

namespace latticeworld {

StreamedState<AgentRow> Streamed(const std::vector<AgentSnapshot>& agents) {
  StreamedState<AgentRow> state;
  for (const AgentSnapshot& agent : agents) {
    state.rows.push_back({agent.name, agent.species, agent.policy, agent.team, agent.controllable});
    StreamedThing thing = StreamedPose(agent.position_m, agent.orientation);
    thing.behaviour = static_cast<std::uint8_t>(agent.behaviour);
    thing.health = HealthByte(agent.health);
    state.things.push_back(thing);
  }
  return state;
}

StreamedState<PropRow> Streamed(const std::vector<PropSnapshot>& props) {
  StreamedState<PropRow> state;
  for (const PropSnapshot& prop : props) {
    state.rows.push_back({prop.name, std::string(NameOf(prop.kind)), prop.size_m});
    StreamedThing thing = StreamedPose(prop.position_m, prop.orientation);
    thing.behaviour = prop.broken ? 1 : 0;
    thing.health = OpeningByte(prop.opening_rad);
    state.things.push_back(thing);
  }
  return state;
}

void ViewerFeed::Reset() {
  agents_.is_new = true;
  props_.is_new = true;
}

template <typename Row, typename Message>
void ViewerFeed::Show(double time_s, double wall_s, const StreamedState<Row>& state,
                      const char* slot, Message message, Stream<Row>* stream) {
  const bool table_changed = stream->is_new || state.rows != stream->told.rows;
  if (!table_changed && state.things == stream->told.things) return;
  if (table_changed) {
    ++stream->version;
    server_->Tell(slot, message(stream->version, state.rows));
  }
  const bool key = table_changed || wall_s - stream->key_wall_s >= kStreamKeyPeriod_s;
  if (key) stream->key_wall_s = wall_s;
  server_->Show(stream->kind, stream->encoder.Encode(time_s, stream->version, state.things, key));
  stream->told = state;
  stream->is_new = false;
}

void ViewerFeed::ShowAgents(double time_s, double wall_s, const StreamedState<AgentRow>& state) {
  Show(time_s, wall_s, state, "agents", AgentsMessage, &agents_);
}

void ViewerFeed::ShowProps(double time_s, double wall_s, const StreamedState<PropRow>& state) {
  Show(time_s, wall_s, state, "elements", PropsMessage, &props_);
}

}  // namespace latticeworld
