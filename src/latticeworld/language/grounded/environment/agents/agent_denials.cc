// Reading about agents: who is not there.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kNobodyTokens = 12;      // what else a "nobody" denies
constexpr std::size_t kSubstituteTokens = 10;  // from who is lacking to who takes their place

}  // namespace

std::size_t AgentReader::ReadNobody(std::size_t tokens) {
  const std::size_t verb = at_ + tokens < tokens_.size() && tokens == 1 && !groups_.empty()
                               ? words_.states.LengthAt(tokens_, at_ + tokens)
                               : 0;
  if (verb > 0) {
    // "two horses stand in the village, nobody moves"
    noted_.Mark(at_, at_ + tokens + verb, &TokenNote::agent);
    return tokens + verb;
  }
  // "no life" denies all; "no one but a shepherd" is denied by the shepherd later on.
  EnvironmentClaim claim;
  claim.kind = EnvironmentClaimKind::kNoAgents;
  claim.words = std::string(noted_.Text(at_, at_ + tokens));
  heard_.absences.push_back(std::move(claim));
  noted_.Mark(at_, at_ + tokens, &TokenNote::agent);
  absent_here_ = true;
  // "not a soul, man or beast"
  const std::size_t first = at_ + tokens;
  for (std::size_t i = first; i < first + kNobodyTokens && !noted_.IsEnd(i); ++i) {
    if (RoleAt(Role::kBut, i) > 0 || ReadCount(noted_, words_, i).tokens > 0 ||
        noted_.IsAnyWord(i, {"except", "save", "apart", "besides", "only", "just", "merely"})) {
      break;
    }
    if (words_.species.LengthAt(tokens_, i) > 0) noted_.notes[i].negated = true;
  }
  return tokens;
}

void AgentReader::ReadAbsence(const SpeciesWord& word, std::size_t end) {
  EnvironmentClaim claim;
  claim.kind = EnvironmentClaimKind::kNoAgents;
  claim.categories = AbsentCategories(word, end - at_);
  claim.words = std::string(noted_.Text(at_, end));
  if (at_ > 0 && !noted_.IsPause(at_ - 1)) {
    std::size_t first = at_;
    while (first > 0 && noted_.notes[first - 1].known && !noted_.IsPause(first - 1) &&
           at_ - first < 3) {
      --first;
    }
    claim.words = std::string(noted_.Text(first, end));
  }
  if (IsSubstituted(claim.categories)) {
    // "You lack wolves, so take dogs": named next.
    substituted_ = last_;
    return;
  }
  const bool placed = PlaceFollows(end);
  absent_here_ = placed;
  const bool other = at_ > 0 && noted_.IsWord(at_ - 1, "other");
  // "forget the dogs": whatever they were called before.
  const bool definite = at_ > 0 && noted_.IsAnyWord(at_ - 1, {"the", "those", "these"});
  // A word of a species that we lack denies that species only, not the one that stands for it.
  if (!placed && !other) {
    for (Group& group : groups_) {
      // In "ten robots, but no drones", the robots remain.
      const bool same = Contains(claim.categories, group.wish.categories);
      // "goats rather than sheep": the goats stay, although sheep stand for them.
      const bool meant = group.wish.name == NameHere(end) || (definite && group.wish.exact) ||
                         (word.exact && (group.wish.exact || claim.categories.size() > 1));
      if (same && meant) group.removed = true;
    }
    if (word.exact || claim.categories.size() > 1) heard_.absences.push_back(std::move(claim));
  }
  state_before_.reset();
}

std::vector<AgentCategory> AgentDiscourse::AbsentCategories(const SpeciesWord& word,
                                                            std::size_t tokens) const {
  const auto kind = words_.kinds.At(tokens_, at_);
  if (kind.tokens >= tokens && !kind.rows.empty()) return kind.rows.front()->categories;
  return word.categories;
}

std::size_t AgentDiscourse::UnwantedAfter(std::size_t end) const {
  // "Whales: none", "sheep = 0"
  if (end < tokens_.size() && tokens_[end].kind == TokenKind::kComma && tokens_[end].text != ",") {
    const bool none = noted_.IsAnyWord(end + 1, {"none", "zero", "nil", "no", "0"});
    return none && noted_.IsPause(end + 2) ? 2 : 0;
  }
  // "whales do not really belong in a lake"
  std::size_t next = end;
  while (noted_.IsAnyWord(next, {"really", "just", "simply", "certainly", "of", "course"})) ++next;
  const std::size_t said = noted_.IsPause(next) ? 0 : RoleAt(Role::kUnwanted, next);
  return said == 0 ? 0 : next + said - end;
}

bool AgentReader::ReadExcepted(const SpeciesWord& word, std::size_t end) {
  std::size_t first = pending_.tokens > 0 ? count_at_ : at_;
  while (first > 0 && noted_.IsAnyWord(first - 1, {"for", "the", "those", "our", "my"})) --first;
  if (first == 0 || noted_.IsPause(first - 1)) return false;
  if (!noted_.IsAnyWord(first - 1, {"except", "but", "excepting", "save", "excluding", "from"})) {
    return false;
  }
  std::vector<std::size_t> same;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    if (!groups_[i].removed && Contains(word.categories, groups_[i].wish.categories)) {
      same.push_back(i);
    }
  }
  if (same.empty()) {
    // "Everybody sleeps except two horses": there they are.
    for (std::size_t i = first; i > 0 && !noted_.IsEnd(i - 1); --i) {
      if (!noted_.IsAnyWord(i - 1, {"everybody", "everyone", "all", "everything"})) continue;
      noted_.notes[at_].negated = false;
      break;
    }
    return false;
  }
  // What was just said is not said of them: "all are idle except the horses, which graze".
  for (const std::size_t index : same) {
    if (IsSubject(index) && acted_on_ == sentence_ + 1) groups_[index].wish.state.reset();
    Extend(index, tokens_[end - 1].end);
  }
  for (std::size_t i = at_; i < tokens_.size() && !noted_.IsPause(i); ++i) {
    noted_.notes[i].negated = false;
  }
  subject_ = same;
  previous_ = same;
  everybody_ = joined_ = paused_ = acted_ = false;
  split_state_ = true;
  return true;
}

bool AgentDiscourse::IsSubstituted(const std::vector<AgentCategory>& categories) const {
  if (last_ == kNone || groups_[last_].removed || groups_[last_].wish.exact) return false;
  const AgentCategory lacking = groups_[last_].wish.categories.front();
  if (std::find(categories.begin(), categories.end(), lacking) == categories.end()) return false;
  bool taken = false;
  for (std::size_t i = at_ + 1; i < at_ + kSubstituteTokens && !noted_.IsEnd(i); ++i) {
    taken = taken || noted_.IsAnyWord(i, {"take", "use", "put", "make", "choose", "pick", "give",
                                          "place", "have", "let", "go", "then"});
    if (taken && !noted_.notes[i].negated && words_.species.LengthAt(tokens_, i) > 0) return true;
  }
  return false;
}

void AgentReader::NarrowDeniedKinds() {
  for (AgentWish& wish : heard_.agents) {
    std::vector<AgentCategory> left;
    for (const AgentCategory category : wish.categories) {
      const bool denied = std::any_of(
          heard_.absences.begin(), heard_.absences.end(), [&](const EnvironmentClaim& claim) {
            return claim.kind == EnvironmentClaimKind::kNoAgents &&
                   std::find(claim.categories.begin(), claim.categories.end(), category) !=
                       claim.categories.end();
          });
      if (!denied) left.push_back(category);
    }
    if (wish.categories.size() > 1 && !left.empty()) wish.categories = left;
  }
}

bool AgentDiscourse::IsDenied(const EnvironmentClaim& claim) const {
  if (claim.kind != EnvironmentClaimKind::kNoAgents) return false;
  return std::any_of(heard_.agents.begin(), heard_.agents.end(), [&](const AgentWish& wish) {
    return claim.categories.empty() || std::find(claim.categories.begin(), claim.categories.end(),
                                                 wish.categories.front()) != claim.categories.end();
  });
}

}  // namespace internal

}  // namespace latticeworld
