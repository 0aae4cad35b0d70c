// Reading about agents: the walk over sentences and clauses, and what is left in the end.

#include "latticeworld/language/grounded/environment/agents/agent_reader.h"

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kMaxWords = 200;  // bytes kept of the words of one group

}  // namespace

void AgentReader::Run() {
  BeginSentence();
  while (at_ < tokens_.size()) {
    if (tokens_[at_].kind == TokenKind::kStop) {
      EndSentence();
      ++at_;
      BeginSentence();
    } else if (tokens_[at_].kind == TokenKind::kComma) {
      EndPhrase();
      ++at_;
    } else {
      at_ += Step();
    }
  }
  EndSentence();
  Finish();
}

std::size_t AgentReader::Step() {
  if (noted_.notes[at_].ignored || noted_.notes[at_].measure) return 1;
  if (const std::size_t nobody = RoleAt(Role::kNobody, at_); nobody > 0) return ReadNobody(nobody);
  if (const std::size_t likeness = RoleAt(Role::kBeforeSpecies, at_); likeness > 0 && !IsLiked()) {
    // "the statue of a knight" is no knight.
    const std::size_t noun =
        words_.species.LengthAt(tokens_, at_ + likeness < tokens_.size() ? at_ + likeness : at_);
    if (at_ + likeness < tokens_.size() && noun > 0) {
      noted_.Mark(at_, at_ + likeness + noun, &TokenNote::agent);
      return likeness + noun;
    }
  }
  if (const std::size_t said = RoleAt(Role::kCorrection, at_); said > 0) {
    if (!IsPlainBetter(said)) {
      corrected_ = corrected_ || Corrects(said);
      Known(said);
      return said;
    }
  }
  if (const std::size_t tokens = ReadOrder(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadCompany(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadEachHas(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadLikewise(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadExceptSome(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadCountsOfSides(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadReference(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadNounPhrase(); tokens > 0) {
    clause_open_ = false;
    return tokens;
  }
  if (const std::size_t tokens = ReadGrounded(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadPlace(); tokens > 0) return tokens;
  if (const std::size_t tokens = ReadState(); tokens > 0) {
    // "in the air above it four drones": nobody is named yet.
    clause_open_ = clause_open_ && subject_.empty() && state_before_.has_value();
    return tokens;
  }
  // "one robot in the north, south and east each"
  if (noted_.IsWord(at_, "each") && at_ > 0 && noted_.notes[at_ - 1].place) {
    for (const std::size_t index : subject_) {
      const AgentWish& wish = groups_[index].wish;
      if (wish.places.size() > 1 || !wish.more_land.empty()) groups_[index].wish.each = true;
    }
  }
  // "five sheep each in the north and in the south"
  if (noted_.IsWord(at_, "each") && subject_.size() == 1 && at_ > 0 &&
      noted_.notes[at_ - 1].agent && PlacePhraseAt(at_ + 1) > 0 && IsPlaceList(at_ + 1)) {
    groups_[subject_.front()].wish.each = true;
  }
  if (noted_.IsWord(at_, "and")) {
    joined_ = true;
    clause_open_ = true;
  }
  if (noted_.IsWord(at_, "where") && FollowsPlace()) {
    // "to the village, where knights wait"
    if (!noted_.notes[at_ - 1].place && !(at_ > 1 && noted_.notes[at_ - 2].place)) {
      there_.clear();
      there_feature_ = LandBefore(false, true);
    }
    EndClause();
    subject_.clear();
    lead_ = {true, there_, there_feature_, false, kNone, at_ + 1};
  }
  if (noted_.IsWord(at_, "with") && !subject_.empty()) joined_ = true;
  if (noted_.IsAnyWord(at_, {"vs", "vs.", "versus", "v"}) && !subject_.empty()) joined_ = true;
  if (RoleAt(Role::kBut, at_) > 0 && !noted_.IsAnyWord(at_, {"with", "by", "for"})) EndClause();
  return 1;
}

bool AgentDiscourse::IsLiked() const {
  return noted_.IsWord(at_, "like") && at_ > 0 &&
         noted_.IsAnyWord(at_ - 1, {"i", "we", "would", "d", "also", "really", "to"});
}

bool AgentDiscourse::FollowsPlace() const {
  std::size_t before = at_;
  if (before > 0 && tokens_[before - 1].kind == TokenKind::kComma) --before;
  if (before > 0 && noted_.notes[before - 1].place) {
    return !there_.empty() || there_feature_.has_value();
  }
  // "Their base is the village, where ..."
  for (; before > 0 && !noted_.IsEnd(before - 1) && !noted_.notes[before - 1].agent; --before) {
    if (words_.features.LengthAt(tokens_, before - 1) > 0) return true;
  }
  return false;
}

bool AgentDiscourse::Corrects(std::size_t said) const {
  if (groups_.empty()) return false;
  if (!noted_.IsAnyWord(at_, {"make"})) return true;
  // "make it night" takes nothing back that was said of agents.
  for (std::size_t i = at_ + said; i < at_ + said + 4 && !noted_.IsPause(i); ++i) {
    if (words_.species.LengthAt(tokens_, i) > 0 || words_.states.LengthAt(tokens_, i) > 0 ||
        ReadCount(noted_, words_, i).tokens > 0 || MatchPlace(tokens_, i).tokens > 0) {
      return true;
    }
    if (words_.coarse.LengthAt(tokens_, i) > 0) return false;
  }
  return false;
}

void AgentReader::Known(std::size_t tokens) {
  for (std::size_t i = at_; i < at_ + tokens && i < noted_.size(); ++i) {
    noted_.notes[i].known = true;
  }
}

void AgentReader::BeginSentence() {
  clause_open_ = true;
  // "... instead" at a sentence's end turns all of it into a correction.
  for (std::size_t i = at_; !noted_.IsEnd(i); ++i) {
    if (noted_.IsWord(i, "instead") && !noted_.IsWord(i + 1, "of") && !groups_.empty()) {
      corrected_ = true;
    }
  }
  // "No, six."
  if (at_ < tokens_.size() && noted_.IsAnyWord(at_, {"no", "nope", "wait"}) &&
      at_ + 1 < tokens_.size() && tokens_[at_ + 1].kind == TokenKind::kComma) {
    corrected_ = true;
  }
}

void AgentReader::EndPhrase() {
  absent_here_ = false;
  pending_ = {};
  joined_ = false;
  paused_ = true;
  acted_ = false;
  // "leaning on his spear, a knight"
  const bool fronted = state_before_.has_value() && subject_.empty() && IsDoing(state_at_) &&
                       (state_at_ == 0 || noted_.IsPause(state_at_ - 1));
  if (!fronted) state_before_.reset();
  phrase_begin_ = kNone;
  clause_open_ = true;
  object_ = kNone;
  // "three goblins - no, four"
  if (at_ + 2 < tokens_.size() && noted_.IsAnyWord(at_ + 1, {"no", "nope"}) &&
      (tokens_[at_ + 2].kind == TokenKind::kComma ||
       ReadCount(noted_, words_, at_ + 2).tokens > 0) &&
      !groups_.empty() && ReadCount(noted_, words_, at_ + 1).tokens == 0 &&
      RoleAt(Role::kNot, at_ + 1) < 2) {
    corrected_ = true;
  }
}

void AgentReader::EndClause() {
  absent_here_ = false;
  pending_ = {};
  joined_ = false;
  acted_ = false;
  state_before_.reset();
  phrase_begin_ = kNone;
  clause_open_ = true;
  new_clause_ = true;
  object_ = kNone;
}

void AgentReader::EndSentence() {
  EndPhrase();
  PutInOrder();
  state_before_.reset();
  DropAnnouncedTotal();
  paused_ = false;
  if (!subject_.empty()) previous_ = subject_;
  subject_.clear();
  lead_ = {};
  corrected_ = false;
  substituted_ = kNone;
  times_ = 1;
  model_ = kNone;
  everybody_ = false;
  told_since_correction_ = false;
  new_clause_ = false;
  split_state_ = false;
  ++sentence_;
}

bool AgentDiscourse::IsListed(std::size_t index) const {
  // "all robots (six drones, four rovers)", "every animal is asleep: ten sheep, ..."
  if (index + 1 >= groups_.size()) return false;
  const std::size_t first = groups_[index].begin, last = groups_[index + 1].begin;
  for (const Token& token : tokens_) {
    if (token.begin < first || token.begin >= last || token.kind != TokenKind::kComma) continue;
    if (token.text != ",") return true;
  }
  return false;
}

bool AgentDiscourse::IsBeside(std::size_t total, std::size_t part) const {
  // "8 robots and 3 drones", "8 robots on the road, 3 drones": no part of those before.
  const std::size_t first = groups_[total].begin, last = groups_[part].begin;
  const std::string share = WordsOf(groups_[part]);
  for (const std::string_view said :
       {"%", " of them", " of which", "percent", "half", "third", "quarter", "fifth", "tenth"})
    if (share.find(said) != share.npos) return false;
  std::size_t before = kNone;
  for (std::size_t i = 0; i < tokens_.size() && tokens_[i].begin < last; ++i) {
    if (tokens_[i].begin < first) continue;
    before = i;
    if (tokens_[i].kind == TokenKind::kComma && tokens_[i].text != ",") return false;
    if (noted_.IsAnyWord(i, {"including", "includes", "include", "incl", "among", "amongst",
                             "namely", "which", "whom", "them", "consisting", "comprising",
                             "composed", "such", "split", "divided", "made"})) {
      return false;
    }
  }
  while (before != kNone && before > 0 &&
         noted_.IsAnyWord(before, {"a", "the", "another", "also", "then"})) {
    --before;
  }
  const bool counted = groups_[part].wish.counted;
  return before != kNone && (noted_.IsAnyWord(before, {"and", "plus"}) ||
                             (counted && !noted_.IsAnyWord(before, {"of", "are", "is"})));
}

bool AgentReader::TakePartsOf(std::size_t index, const std::vector<std::size_t>& parts, int sum) {
  AgentWish& wish = groups_[index].wish;
  const bool counted = std::all_of(parts.begin(), parts.end(),
                                   [&](std::size_t part) { return groups_[part].wish.counted; });
  if (!counted || !wish.counted || sum >= wish.quantity) return false;
  std::vector<AgentCategory> others;
  for (const AgentCategory category : wish.categories) {
    const bool named = std::any_of(parts.begin(), parts.end(), [&](std::size_t part) {
      return groups_[part].wish.categories.front() == category;
    });
    if (!named) others.push_back(category);
  }
  if (others.empty()) return false;
  wish.categories = others;
  const int left = wish.quantity - sum;
  SetCount({left, left, left, 0}, &groups_[index]);
  return true;
}

void AgentReader::DropAnnouncedTotal() {
  const std::size_t kinds = EnumNames(AgentCategory{}).size();
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    Group& total = groups_[i];
    if (total.sentence != sentence_ || total.removed || total.wish.categories.size() < 2) continue;
    if (!total.wish.counted && !IsListed(i)) continue;
    int sum = 0;
    std::vector<std::size_t> parts;
    for (std::size_t j = i + 1; j < groups_.size(); ++j) {
      const AgentWish& part = groups_[j].wish;
      if (!groups_[j].removed && part.categories.size() == 1 &&
          Contains(total.wish.categories, part.categories)) {
        sum += part.quantity;
        parts.push_back(j);
      }
    }
    if (sum == 0 || (total.wish.counted && sum > total.wish.quantity)) continue;
    const bool all = total.wish.categories.size() == kinds;
    const bool some = total.wish.counted && (sum < total.wish.quantity || parts.size() == 1);
    if (some && !all && IsBeside(i, parts.front())) continue;
    // "Ten robots, including three drones": the other seven stay.
    const bool others = !all && TakePartsOf(i, parts, sum);
    total.removed = !others;
    // What was said of all is said of each.
    for (const std::size_t j : parts) {
      AgentWish& part = groups_[j].wish;
      if (!part.state.has_value()) part.state = total.wish.state;
      if (!part.places.empty() || part.feature.has_value() || groups_[j].with != kNone) continue;
      part.places = total.wish.places;
      part.feature = total.wish.feature;
      part.more_land = total.wish.more_land;
    }
    if (all && SaysNumber(total.wish)) heard_.absences.push_back(TotalClaim(total));
  }
}

EnvironmentClaim AgentDiscourse::TotalClaim(const Group& total) const {
  EnvironmentClaim claim;
  claim.kind = EnvironmentClaimKind::kTotalAgents;
  claim.least_quantity = std::min(total.wish.least + total.taken, kMaxAgents);
  claim.most_quantity =
      std::max(claim.least_quantity, std::min(total.wish.most + total.taken, kMaxAgents));
  claim.words = WordsOf(total);
  return claim;
}

void AgentReader::Extend(std::size_t index, std::size_t end) {
  groups_[index].end = std::max(groups_[index].end, end);
}

std::string AgentDiscourse::WordsOf(const Group& group) const {
  std::string_view words = noted_.instruction.substr(
      group.begin, std::min(group.end - std::min(group.end, group.begin), kMaxWords));
  // No half of a character at the cut.
  while (words.size() == kMaxWords && !words.empty() &&
         (static_cast<unsigned char>(words.back()) & 0x80u) != 0) {
    words.remove_suffix(1);
  }
  return std::string(words);
}

void AgentReader::JoinCompany() {
  for (Group& group : groups_) {
    AgentWish& wish = group.wish;
    std::size_t with = group.with;
    for (std::size_t steps = 0; with != kNone && steps < groups_.size(); ++steps) {
      const AgentWish& other = groups_[with].wish;
      if (other.IsPlaced()) {
        if (!wish.IsPlaced()) {
          wish.places = other.places;
          wish.feature = other.feature;
          wish.more_land = other.more_land;
        }
        break;
      }
      with = groups_[with].with;
    }
  }
}

void AgentReader::TellUnlike() {
  for (Group& group : groups_) {
    if (group.unlike == kNone || group.wish.state.has_value()) continue;
    const std::optional<AgentState>& others = groups_[group.unlike].wish.state;
    if (!others.has_value()) continue;
    group.wish.state = others == AgentState::kIdle ? AgentState::kPatrolling : AgentState::kIdle;
  }
}

// "The only living thing is an eagle", "agents: 10": beside groups that are named, agents of any
// kind are no group of their own but all of them together.
void AgentReader::SumUpAnyAgents() {
  const std::size_t kinds = EnumNames(AgentCategory{}).size();
  int sum = 0;
  for (const Group& group : groups_) {
    if (group.removed || group.purpose || group.wish.categories.size() == kinds) continue;
    sum += group.wish.quantity;
  }
  if (sum == 0) return;
  for (Group& group : groups_) {
    const AgentWish& wish = group.wish;
    if (group.removed || wish.categories.size() != kinds || wish.IsPlaced()) continue;
    if (wish.counted && wish.quantity > 1 && wish.quantity + group.taken < sum) continue;
    group.removed = true;
    if (SaysNumber(wish) && wish.quantity > 1) heard_.absences.push_back(TotalClaim(group));
  }
}

void AgentReader::Finish() {
  JoinCompany();
  TellUnlike();
  SumUpAnyAgents();
  const bool asked = std::any_of(groups_.begin(), groups_.end(), [](const Group& group) {
    return !group.purpose && !group.removed;
  });
  for (Group& group : groups_) group.removed = group.removed || (group.purpose && asked);
  for (Group& group : groups_) {
    if (group.removed || group.wish.quantity < 1) continue;
    group.wish.words = WordsOf(group);
    heard_.agents.push_back(std::move(group.wish));
  }
  NarrowDeniedKinds();
  // Who is named is not absent: "nobody but a shepherd".
  auto& absences = heard_.absences;
  absences.erase(std::remove_if(absences.begin(), absences.end(),
                                [&](const EnvironmentClaim& claim) { return IsDenied(claim); }),
                 absences.end());
}

}  // namespace internal

void ReadAgents(const EnvironmentWords& words, NotedTokens* noted, HeardEnvironment* heard) {
  internal::AgentReader(words, noted, heard).Run();
}

}  // namespace latticeworld
