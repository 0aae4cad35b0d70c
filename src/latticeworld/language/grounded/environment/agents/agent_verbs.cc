// Reading about agents: what agents do.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {
namespace {

bool IsGeneral(AgentState state) {
  return state == AgentState::kIdle || state == AgentState::kPatrolling;
}
bool IsAgainst(AgentState state) {
  return state == AgentState::kPursuing || state == AgentState::kAttacking;
}

}  // namespace

std::size_t AgentReader::ReadGrounded() {
  if (!IsSubjectWinged() || !noted_.IsWord(at_, "on") || !noted_.IsAnyWord(at_ + 2, {"ground"})) {
    return 0;
  }
  // "none of them on the ground"
  const AgentState state = noted_.notes[at_].negated ? AgentState::kFlying : AgentState::kIdle;
  for (const std::size_t index : subject_) {
    groups_[index].wish.state = state;
    Extend(index, tokens_[at_ + 2].end);
  }
  noted_.Mark(at_, at_ + 3, &TokenNote::agent);
  return 3;
}

std::size_t AgentReader::ReadState() {
  const auto match = words_.states.At(tokens_, at_);
  // "rolling hills" is land, a sky "swept clean of clouds" is clear.
  const std::size_t other = std::max(words_.coarse.LengthAt(tokens_, at_), RoleAt(Role::kNot, at_));
  if (match.tokens == 0 || other > match.tokens) return 0;
  const AgentState state =
      ChargesAtStation(match.tokens) ? AgentState::kIdle : match.rows.front()->state;
  const std::size_t end = at_ + match.tokens;
  const bool noun_next = NounFollows(end);
  const bool noun_ahead = noun_next || AgentsAhead(end);
  if (match.tokens == 1 && IsStateNoun(noun_next)) return 0;
  const bool fragment = subject_.empty() && !noun_ahead && IsParticiple(at_) && IsFragment();
  if (subject_.empty() && !noun_ahead && !fragment && !(corrected_ && !previous_.empty())) {
    return 0;
  }
  noted_.Mark(at_, end, &TokenNote::agent);
  if (noted_.notes[at_].negated) {
    DenyState(state);
    return match.tokens;
  }
  const bool by = noted_.IsWord(end, "by") && !IsDoing(at_) && AgentsAfterBy(end + 1) &&
                  (IsParticiple(at_) || Passive());
  const bool after_subject = !subject_.empty() && at_ == SubjectEnd();
  const bool adjective = noun_next && !(after_subject && Takes(state)) &&
                         (pending_.tokens > 0 || IsParticiple(at_) || subject_.empty()) &&
                         !IsFinite(at_);
  if (by || adjective || (subject_.empty() && noun_ahead)) {
    KeepStateForNext(state, by, end);
    return match.tokens;
  }
  const bool outright = match.tokens > 1 || noted_.IsWord(at_, "motionless");
  for (const std::size_t index : TakeOwnersOfState(fragment)) {
    SetState(index, state, outright);
    Extend(index, tokens_[end - 1].end);
  }
  acted_ = Takes(state);
  verb_end_ = end;
  acted_on_ = sentence_ + 1;
  joined_ = false;
  paused_ = false;
  split_state_ = false;
  return match.tokens;
}

bool AgentDiscourse::ChargesAtStation(std::size_t tokens) const {
  // Robots that charge stand at their charger.
  return noted_.IsWord(at_, "charging") && tokens == 1 && SubjectIsRobots() &&
         (noted_.IsPause(at_ + 1) || IsAtCharger(at_ + 1) ||
          noted_.IsAnyWord(at_ + 1, {"in", "by", "near", "beside", "outside", "on"}));
}

bool AgentDiscourse::IsStateNoun(bool noun_next) const {
  if (at_ == 0 || IsParticiple(at_)) return false;
  // "a storm", "the charge": after an article it is a noun, unless agents follow.
  if (noted_.IsAnyWord(at_ - 1, {"a", "an", "the", "this"}) && !noun_next) return true;
  // "until the storm is over"
  return noted_.IsAnyWord(at_ - 1, {"until", "till", "during"});
}

void AgentReader::DenyState(AgentState state) {
  // "none of them parked"
  for (const std::size_t index : subject_) {
    std::optional<AgentState>& said = groups_[index].wish.state;
    if (said.has_value()) continue;
    if (state == AgentState::kIdle) said = AgentState::kPatrolling;
    // "neither of the eagles is flying", "none of them grazes"
    if (state == AgentState::kPatrolling || state == AgentState::kFlying ||
        state == AgentState::kGrazing) {
      said = AgentState::kIdle;
    }
  }
}

void AgentReader::KeepStateForNext(AgentState state, bool by, std::size_t end) {
  state_before_ = state;
  state_at_ = at_;
  phrase_begin_ = std::min(phrase_begin_, tokens_[at_].begin);
  if (!by) return;
  // "the village is guarded by four knights"
  if (subject_.empty() && !lead_.set) {
    if (const auto land = LandBefore(false, true); land.has_value()) {
      lead_ = {true, {}, land, false, kNone, end};
    }
  }
  if (!subject_.empty()) by_subject_ = subject_.front();
  subject_.clear();
}

std::vector<std::size_t> AgentReader::TakeOwnersOfState(bool fragment) {
  std::vector<std::size_t> owners = subject_;
  if (owners.empty() && (corrected_ || fragment)) owners = previous_;
  if (fragment) subject_ = previous_;
  // "goblins chase sheep grazing in the south"
  if (object_ != kNone && object_end_ == at_ && IsParticiple(at_)) {
    owners = {object_};
    subject_ = owners;
    object_ = kNone;
  }
  return owners;
}

bool AgentDiscourse::IsAtCharger(std::size_t at) const {
  if (!noted_.IsWord(at, "at")) return false;
  std::size_t noun = at + 1;
  while (noted_.IsAnyWord(noun, {"the", "a", "their", "its"})) ++noun;
  return noted_.IsPause(noun) || (words_.features.LengthAt(tokens_, noun) == 0 &&
                                  words_.species.LengthAt(tokens_, noun) == 0);
}

bool AgentDiscourse::SubjectIsRobots() const {
  return !subject_.empty() && std::all_of(subject_.begin(), subject_.end(), [&](std::size_t index) {
    switch (groups_[index].wish.categories.front()) {
      case AgentCategory::kWheeledRobot:
      case AgentCategory::kHumanoidRobot:
      case AgentCategory::kRoboticDog:
      case AgentCategory::kAerialRobot:
        return groups_[index].wish.exact;
      default:
        return false;
    }
  });
}

bool AgentDiscourse::IsSubjectWinged() const {
  return !subject_.empty() && std::all_of(subject_.begin(), subject_.end(), [&](std::size_t index) {
    return LocomotionOf(groups_[index].wish.categories.front()) == Locomotion::kWings;
  });
}

bool AgentDiscourse::AgentsAfterBy(std::size_t at) const {
  for (std::size_t i = at; i < at + kPhraseTokens && !noted_.IsPause(i); ++i) {
    if (words_.species.LengthAt(tokens_, i) > 0) return true;
    if (words_.features.LengthAt(tokens_, i) > 0) return false;
  }
  return false;
}

bool AgentDiscourse::Takes(AgentState state) {
  return IsAgainst(state) || state == AgentState::kPatrolling;
}

bool AgentDiscourse::Passive() const {
  return at_ > 0 && noted_.IsAnyWord(at_ - 1, {"is", "are", "being", "was", "were"});
}

bool AgentDiscourse::IsFinite(std::size_t at) const {
  return at > 0 && noted_.IsAnyWord(at - 1, {"is", "are", "they", "that", "who", "which"});
}

std::size_t AgentDiscourse::SubjectEnd() const {
  std::size_t at = at_;
  while (at > 0 && noted_.IsAnyWord(at - 1, {"is", "are", "who", "that", "which", "were"})) --at;
  return at > 0 && noted_.notes[at - 1].agent ? at_ : kNone;
}

void AgentReader::SetState(std::size_t index, AgentState state, bool outright) {
  std::optional<AgentState>& said = groups_[index].wish.state;
  const bool weaker = said.has_value() && !IsGeneral(*said) && !corrected_ && !split_state_;
  const bool same_kind = said.has_value() && *said == AgentState::kPatrolling &&
                         state == AgentState::kIdle && !corrected_ && !split_state_ && !outright;
  const bool later = acted_on_ != sentence_ + 1 && groups_[index].sentence != sentence_;
  if ((weaker || same_kind) && !later) return;
  said = state;
}

bool AgentDiscourse::NounFollows(std::size_t at) const {
  for (std::size_t i = at; i < at + 2 && !noted_.IsPause(i); ++i) {
    if (noted_.notes[i].negated) return false;
    if (words_.species.LengthAt(tokens_, i) > 0 && !IsVerbHere(i, false)) return true;
    if (RoleAt(Role::kIn, i) > 0 || RoleAt(Role::kNear, i) > 0 ||
        noted_.IsAnyWord(i, {"the", "a", "an", "and", "or"}) ||
        ReadCount(noted_, words_, i).tokens > 0) {
      return false;
    }
  }
  return false;
}

bool AgentDiscourse::AgentsAhead(std::size_t at) const {
  for (std::size_t i = at; i < at + 12 && !noted_.IsEnd(i); ++i) {
    if (!noted_.notes[i].negated && words_.species.LengthAt(tokens_, i) > 0 &&
        !IsVerbHere(i, i > 0 && ReadCount(noted_, words_, i - 1).tokens > 0)) {
      return true;
    }
  }
  return false;
}

}  // namespace internal

}  // namespace latticeworld
