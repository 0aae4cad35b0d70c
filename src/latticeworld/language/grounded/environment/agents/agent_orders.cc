// Reading about agents: groups that stand in a row, told in their order along it.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {

std::size_t AgentReader::ReadOrder() {
  if (!subject_.empty() || order_.has_value()) return 0;
  const std::size_t from = noted_.IsWord(at_, "from") ? 1 : 0;
  const AxisMatch axis = at_ + from < tokens_.size() ? MatchAxis(tokens_, at_ + from) : AxisMatch{};
  const std::size_t end = at_ + from + axis.tokens;
  if (axis.tokens == 0 || !(noted_.IsPause(end) || AgentsAhead(end))) return 0;
  order_ = axis;
  order_first_ = groups_.size();
  noted_.Mark(at_, end, &TokenNote::place);
  return end - at_;
}

void AgentReader::PutInOrder() {
  if (!order_.has_value()) return;
  std::vector<std::size_t> row;
  for (std::size_t i = order_first_; i < groups_.size(); ++i) {
    const AgentWish& wish = groups_[i].wish;
    const bool led =
        lead_.places.size() == wish.places.size() &&
        (lead_.places.empty() || lead_.places.front().main == wish.places.front().main);
    if (!groups_[i].removed && led) row.push_back(i);
  }
  const Heading from = order_->from;
  order_.reset();
  if (row.size() < 2) return;
  // The ninths of the row that the sentence began with, or of one through the middle.
  std::vector<Region> ninths;
  for (const Place& place : lead_.places) {
    ninths.insert(ninths.end(), place.regions.begin(), place.regions.end());
  }
  if (ninths.size() < 2) {
    for (const int step : {1, 0, -1})
      ninths.push_back(RegionOf({from.east * step, from.south * step}));
  }
  const auto along = [&](Region region) {
    const Heading heading = HeadingOf(region);
    return heading.east * from.east + heading.south * from.south;
  };
  std::stable_sort(ninths.begin(), ninths.end(),
                   [&](Region a, Region b) { return along(a) > along(b); });
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::size_t place =
        (2 * i * (ninths.size() - 1) + row.size() - 1) / (2 * (row.size() - 1));
    AgentWish& wish = groups_[row[i]].wish;
    wish.places = {PlaceOf(ninths[place])};
    wish.feature.reset();
  }
}

}  // namespace internal

}  // namespace latticeworld
