// Reading about agents: noun phrases: which words make one.

#include <algorithm>

#include "latticeworld/language/grounded/environment/agents/agent_steps.h"
#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kMaxGroups = 200;    // groups read; nobody means more
constexpr std::size_t kPurposeTokens = 8;  // that "to study" reaches

}  // namespace

std::size_t AgentReader::ReadNounPhrase() {
  Count count;
  if (pending_.tokens == 0) {
    count = ReadComparedCount();
    if (count.tokens == 0) count = ReadCount(noted_, words_, at_);
  }
  if (noted_.IsWord(at_, "both") && !NounAhead(at_ + count.tokens)) count = {};
  const bool species_here = !CountsWheeled(at_) && words_.species.LengthAt(tokens_, at_) >=
                                                       std::max<std::size_t>(1, count.tokens);
  if (count.tokens > 0 && !species_here) {
    const std::size_t next = at_ + count.tokens;
    // "four wheels each" counts no agents.
    if (noted_.IsAnyWord(next, {"wheels", "legs", "rotors", "propellers", "arms", "eyes", "feet",
                                "wings", "tracks"})) {
      const std::size_t parts = count.tokens + (noted_.IsWord(next + 1, "each") ? 2 : 1);
      noted_.Mark(at_, at_ + parts, &TokenNote::agent);
      return parts;
    }
    if (NounAhead(next)) {
      pending_ = count;
      phrase_begin_ = std::min(phrase_begin_, tokens_[at_].begin);
      count_at_ = at_;
      return count.tokens;
    }
    return ReadLoneCount(count);
  }
  return ReadSpecies();
}

bool AgentDiscourse::CountsWheeled(std::size_t at) const {
  if (!noted_.IsWord(at + 1, "wheeled") || MatchNumber(tokens_, at).tokens != 1) return false;
  const auto wheeled = words_.species.At(tokens_, at + 1);
  return wheeled.tokens > 0 && wheeled.rows.front()->plural &&
         noted_.Text(at, at + 2).find('-') == std::string_view::npos;
}

bool AgentDiscourse::NounAhead(std::size_t at) const {
  for (std::size_t i = at; i < at + kPhraseTokens && !noted_.IsPause(i); ++i) {
    if (words_.species.LengthAt(tokens_, i) > 0 && !IsVerbHere(i, true)) return true;
    if (words_.assets.LengthAt(tokens_, i) > 0) return false;
    const bool adverb = noted_.IsAnyWord(i, {"very", "more", "other", "of", "the"});
    if (RoleAt(Role::kIn, i) > 0 || RoleAt(Role::kNear, i) > 0 || noted_.IsWord(i, "and")) {
      return false;
    }
    const std::size_t state = words_.states.LengthAt(tokens_, i);
    if (state > 0 && !adverb && !IsParticiple(i)) return false;
    if (noted_.IsAnyWord(i, {"is", "are", "should", "will", "that", "who", "them"})) return false;
  }
  return false;
}

bool AgentDiscourse::IsParticiple(std::size_t at) const {
  const std::string& word = tokens_[at].text;
  const auto ends = [&](std::string_view end) {
    return word.size() > end.size() && word.compare(word.size() - end.size(), end.size(), end) == 0;
  };
  return ends("ing") || ends("ed") ||
         noted_.IsAnyWord(at, {"idle", "asleep", "motionless", "hostile", "aggressive", "airborne",
                               "stationary", "still", "lazy", "watchful", "vigilant", "alert"});
}

bool AgentDiscourse::IsDoing(std::size_t at) const {
  const std::string& word = tokens_[at].text;
  return word.size() > 3 && word.compare(word.size() - 3, 3, "ing") == 0;
}

bool AgentDiscourse::EndsNounPhrase(std::size_t at) const {
  if (noted_.IsPause(at)) return true;
  if (RoleAt(Role::kIn, at) > 0 || RoleAt(Role::kNear, at) > 0 || RoleAt(Role::kBut, at) > 0) {
    return true;
  }
  if (MatchPlace(tokens_, at).tokens > 0) return true;
  if (words_.states.LengthAt(tokens_, at) > 0) return true;
  return noted_.IsAnyWord(
      at, {"is",     "are",    "and",   "or",    "instead", "please", "there", "here",
           "should", "will",   "were",  "was",   "that",    "who",    "have",  "has",
           "not",    "rather", "more",  "only",  "each",    "then",   "just",  "simply",
           "may",    "can",    "where", "which", "with",    "whose",  "live",  "lives",
           "dwell",  "go",     "goes",  "come",  "comes"});
}

bool AgentDiscourse::IsVerbHere(std::size_t at, bool counted) const {
  const std::size_t noun = words_.species.LengthAt(tokens_, at);
  if (words_.states.LengthAt(tokens_, at) < noun) return false;
  // "three guard the village": of three there is no singular.
  if (counted) {
    const NumberMatch number = at > 0 ? MatchNumber({tokens_[at - 1]}, 0) : NumberMatch{};
    const SpeciesWord& word = *words_.species.At(tokens_, at).rows.front();
    // "one flies, five drive": of one there is no plural.
    if (number.value == 1 && noun == 1 && word.plural && !word.singular) return true;
    return number.value > 1 && noun == 1 && !noted_.IsPause(at + 1) && !word.plural;
  }
  if (at > 0 && noted_.IsWord(at - 1, "one") && noun == 1) {
    const SpeciesWord& word = *words_.species.At(tokens_, at).rows.front();
    if (word.plural && !word.singular) return true;
  }
  if (at > 0 &&
      (noted_.IsAnyWord(at - 1, {"a",     "an",      "the", "no",   "by",    "some", "these",
                                 "their", "his",     "her", "its",  "my",    "our",  "your",
                                 "those", "another", "one", "each", "every", "any"}) ||
       IsParticiple(at - 1))) {
    return false;
  }
  return true;
}

std::size_t AgentReader::ReadSpecies() {
  const auto match = words_.species.At(tokens_, at_);
  if (match.tokens == 0 || groups_.size() >= kMaxGroups) return 0;
  const std::size_t first_end = at_ + match.tokens;
  SpeciesWord word = *match.rows.front();
  if (pending_.tokens == 0 && IsVerbHere(at_, false)) return 0;
  // "flying robots" are agents that fly, and a name of its own.
  if (words_.coarse.LengthAt(tokens_, at_) > match.tokens && pending_.tokens == 0) return 0;
  if (IsOtherThing(word, first_end)) {
    noted_.Mark(at_, first_end, &TokenNote::agent);
    pending_ = {};
    return match.tokens;
  }
  if (IsAudience(word)) {
    noted_.Mark(at_, first_end, &TokenNote::agent);
    return match.tokens;
  }
  // "cart tracks" are a road.
  if (words_.variants.LengthAt(tokens_, at_) > match.tokens ||
      words_.assets.LengthAt(tokens_, at_) > match.tokens) {
    return 0;
  }
  if (IsHeadingOfAgents(word, first_end)) {
    noted_.Mark(at_, first_end, &TokenNote::agent);
    return match.tokens;
  }
  const std::optional<std::size_t> end = EndOfName(first_end, &word);
  noted_.Mark(at_, end.value_or(first_end), &TokenNote::agent);
  return end.has_value() ? ReadNamed(word, *end) : match.tokens;
}

bool AgentDiscourse::IsOtherThing(const SpeciesWord& word, std::size_t end) const {
  if (at_ > 0 && noted_.IsAnyWord(at_ - 1, {"dead", "carved", "painted", "stuffed"})) return true;
  if (IsPossessive(end)) return true;
  if (end >= tokens_.size() || RoleAt(Role::kAfterSpecies, end) == 0) return false;
  return word.plural ? word.singular : !noted_.IsPause(end);
}

bool AgentDiscourse::IsHeadingOfAgents(const SpeciesWord& word, std::size_t end) const {
  if (end >= tokens_.size() || tokens_[end].text != ":" || pending_.tokens > 0 ||
      UnwantedAfter(end) > 0) {
    return false;
  }
  if (word.categories.size() > 1) return true;
  // "People: 1 shepherd" names those who are meant.
  const Count labelled = ReadCount(noted_, words_, end + 1);
  return labelled.tokens > 0 && words_.species.LengthAt(tokens_, end + 1 + labelled.tokens) > 0;
}

std::optional<std::size_t> AgentDiscourse::EndOfName(std::size_t end, SpeciesWord* word) const {
  if (!word->plural && IsUnknownHere(end) && words_.species.LengthAt(tokens_, end + 1) > 0) {
    // "humanoid rescue robots"
    const SpeciesWord& kind = *words_.species.At(tokens_, end + 1).rows.front();
    if (kind.categories.size() > 1 && Contains(kind.categories, word->categories)) ++end;
  }
  if (end >= tokens_.size() || word->plural || words_.species.LengthAt(tokens_, end) == 0 ||
      IsVerbHere(end, false)) {
    return end;
  }
  const auto last = words_.species.At(tokens_, end);
  const SpeciesWord& kind = *last.rows.front();
  if (kind.categories.size() < 2 || !Contains(kind.categories, word->categories)) {
    return std::nullopt;
  }
  word->plural = kind.plural;
  word->singular = kind.singular;
  return end + last.tokens;
}

std::size_t AgentReader::ReadNamed(const SpeciesWord& word, std::size_t end) {
  // "a pack mule" is one.
  if (IsBarePack() && word.singular && !word.plural) pending_ = {1, 1, 1, pending_.tokens};
  if (pending_.tokens > 0) {
    noted_.Mark(count_at_, count_at_ + pending_.tokens, &TokenNote::agent);
  }
  if (!noted_.notes[at_].negated && IsApposition(word, end)) return end - at_;
  // "wolf pack", but "swans drift"
  const Count collective = word.plural && !word.singular ? Count{} : ReadPack(end);
  noted_.Mark(end, end + collective.tokens, &TokenNote::agent);
  std::size_t unwanted = pending_.tokens == 0 ? UnwantedAfter(end) : 0;
  if (noted_.notes[at_].negated && IsNoneOf()) noted_.notes[at_].negated = false;
  if (noted_.notes[at_].negated && ReadExcepted(word, end)) {
    // Told by what follows.
  } else if (noted_.notes[at_].negated || unwanted > 0) {
    ReadAbsence(word, end);
    noted_.Mark(end, end + unwanted, &TokenNote::agent);
  } else {
    unwanted = 0;
    ReadPresence(word, collective, end);
    if (part_of_.tokens > 0 && last_ != kNone && groups_[last_].wish.quantity > part_of_.value) {
      Split(part_of_, part_of_.value, end - at_);
      if (all_but_) groups_[rest_].unlike = part_;
    }
  }
  part_of_ = {};
  all_but_ = false;
  pending_ = {};
  phrase_begin_ = kNone;
  return end + collective.tokens + unwanted - at_;
}

bool AgentDiscourse::IsNoneOf() const {
  // "none of the two robots moves": there they are.
  const std::size_t noun = pending_.tokens > 0 ? count_at_ : at_;
  std::size_t first = noun;
  while (first > 0 && noted_.IsAnyWord(first - 1, {"the", "my", "our", "these", "those"})) --first;
  return first < noun && first > 1 && noted_.IsWord(first - 1, "of") &&
         noted_.IsAnyWord(first - 2, {"neither", "none"});
}

bool AgentDiscourse::IsBarePack() const {
  const std::size_t end = count_at_ + pending_.tokens;
  return pending_.least < pending_.most && end == at_ && at_ > 0 &&
         ReadCollective(noted_, words_, at_ - 1).tokens > 0;
}

bool AgentDiscourse::IsUnknownHere(std::size_t at) const {
  return !noted_.IsPause(at) && RoleAt(Role::kFunction, at) == 0 && RoleAt(Role::kIn, at) == 0 &&
         RoleAt(Role::kNear, at) == 0 && RoleAt(Role::kBut, at) == 0 &&
         words_.states.LengthAt(tokens_, at) == 0 && words_.species.LengthAt(tokens_, at) == 0 &&
         ReadCount(noted_, words_, at).tokens == 0;
}

bool AgentDiscourse::IsAudience(const SpeciesWord& word) const {
  // "a film for kids", "for my students"
  if (pending_.tokens > 0 || word.exact ||
      word.categories.front() != AgentCategory::kHumanoidRobot) {
    return false;
  }
  std::size_t first = at_;
  while (first > 0 && noted_.IsAnyWord(first - 1, {"my", "our", "the", "small", "little", "young",
                                                   "a", "an", "of", "year", "his", "her"})) {
    --first;
  }
  return first > 0 && noted_.IsWord(first - 1, "for");
}

bool AgentDiscourse::IsInPurpose() const {
  if (pending_.tokens > 0) return false;
  for (std::size_t i = at_; i > 0 && i + kPurposeTokens > at_; --i) {
    if (tokens_[i - 1].kind == TokenKind::kStop || noted_.IsAnyWord(i - 1, {"so", "with", "put"})) {
      return false;
    }
    if (!noted_.IsAnyWord(i - 1, {"study", "studying", "test", "testing", "check", "checking",
                                  "verify", "verifying", "compare", "comparing", "investigate",
                                  "research", "researching", "understand", "learn", "evaluate"})) {
      continue;
    }
    return i > 1 && noted_.IsAnyWord(i - 2, {"to", "we", "i", "am", "m", "are", "re", "for"});
  }
  return false;
}

// "Their dog - a robot - runs": the kind of those just named.
bool AgentDiscourse::IsApposition(const SpeciesWord& word, std::size_t end) const {
  return word.categories.size() > 1 && pending_.tokens == 0 && at_ > 1 && last_ != kNone &&
         noted_.IsAnyWord(at_ - 1, {"a", "an"}) && noted_.IsPause(at_ - 2) && noted_.IsPause(end) &&
         tokens_[at_ - 2].kind == TokenKind::kComma && groups_[last_].wish.quantity == 1 &&
         groups_[last_].sentence == sentence_ && !groups_[last_].removed &&
         Contains(word.categories, groups_[last_].wish.categories);
}

Count AgentDiscourse::ReadPack(std::size_t end) const {
  if (end >= tokens_.size() || words_.states.LengthAt(tokens_, end) > 0) return {};
  Count pack = ReadCollective(noted_, words_, end);
  if (pack.tokens == 0 || !noted_.IsWord(end + 1, "of")) return pack;
  Count counted = end + 2 < tokens_.size() ? ReadCount(noted_, words_, end + 2) : Count{};
  if (counted.tokens == 0 || !EndsNounPhrase(end + 2 + counted.tokens)) return pack;
  counted.tokens += 2;
  return counted;
}

bool AgentDiscourse::IsPossessive(std::size_t end) const {
  const Token& noun = tokens_[end - 1];
  // "'s" is within the token.
  const std::string_view text = noted_.Text(end - 1, end);
  if (text.find('\'') != text.npos || text.find("\xE2\x80\x99") != text.npos) return true;
  const std::string_view after = noted_.instruction.substr(noun.end);
  return after.size() > 1 && after[0] == '\'' && after[1] == ' ';
}

bool AgentDiscourse::PlaceFollows(std::size_t at) const {
  return !noted_.IsPause(at) && (RoleAt(Role::kIn, at) > 0 || RoleAt(Role::kNear, at) > 0);
}

Count AgentDiscourse::DefaultCount(const SpeciesWord& word) const {
  const bool article =
      at_ > 0 && noted_.IsAnyWord(at_ - 1, {"a", "an", "one", "another", "each", "every"});
  if (word.plural && !(word.singular && (article || NearArticle()))) return kSomeSeen;
  return {1, 1, 1, 0};
}

bool AgentDiscourse::NearArticle() const {
  for (std::size_t i = at_; i > 0 && i + 4 > at_; --i) {
    if (noted_.IsPause(i - 1)) return false;
    if (noted_.IsAnyWord(i - 1, {"a", "an", "another"})) return true;
    if (!noted_.notes[i - 1].known) return false;
  }
  return false;
}

bool AgentDiscourse::IsDefinite() const {
  const std::size_t first = pending_.tokens > 0 ? count_at_ : at_;
  for (std::size_t i = first; i > 0 && i + 4 > first; --i) {
    if (noted_.IsPause(i - 1)) return false;
    if (noted_.IsAnyWord(i - 1, {"the", "these", "those", "both", "their", "said"})) {
      return !(i < tokens_.size() && noted_.IsAnyWord(i, {"other", "second", "next", "last"}));
    }
    if (noted_.IsAnyWord(i - 1, {"a", "an", "other", "another", "more", "and", "of"})) return false;
    if (RoleAt(Role::kIn, i - 1) > 0 || RoleAt(Role::kNear, i - 1) > 0) return false;
  }
  return false;
}

}  // namespace internal

}  // namespace latticeworld
