// Reading about agents: noun phrases: counts, names, absences, corrections.

#include <algorithm>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment/agent_discourse.h"

namespace latticeworld {
namespace internal {
namespace {

constexpr std::size_t kMaxGroups = 200;    // groups read; nobody means more
constexpr std::size_t kPurposeTokens = 8;  // that "to study" reaches
const Count kSomeSeen{2, 3, 12, 0};        // what a bare plural stands for

bool Contains(const std::vector<AgentCategory>& all, const std::vector<AgentCategory>& some) {
  return std::all_of(some.begin(), some.end(), [&](AgentCategory category) {
    return std::find(all.begin(), all.end(), category) != all.end();
  });
}

}  // namespace

std::size_t AgentReader::ReadNounPhrase() {
  const Count count = pending_.tokens > 0 ? Count{} : ReadCount(noted_, words_, at_);
  const bool species_here =
      words_.species.LengthAt(tokens_, at_) >= std::max<std::size_t>(1, count.tokens);
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

bool AgentReader::NounAhead(std::size_t at) const {
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

bool AgentReader::IsParticiple(std::size_t at) const {
  const std::string& word = tokens_[at].text;
  const auto ends = [&](std::string_view end) {
    return word.size() > end.size() && word.compare(word.size() - end.size(), end.size(), end) == 0;
  };
  return ends("ing") || ends("ed") ||
         noted_.IsAnyWord(at, {"idle", "asleep", "motionless", "hostile", "aggressive", "airborne",
                               "stationary", "still", "lazy", "watchful", "vigilant", "alert"});
}

bool AgentReader::IsDoing(std::size_t at) const {
  const std::string& word = tokens_[at].text;
  return word.size() > 3 && word.compare(word.size() - 3, 3, "ing") == 0;
}

std::size_t AgentReader::ReadLoneCount(const Count& count) {
  std::size_t next = at_ + count.tokens;
  if (last_ == kNone || next > tokens_.size()) return 0;
  const std::size_t of_them = next < tokens_.size() ? RoleAt(Role::kOfThem, next) : 0;
  std::size_t more = next < tokens_.size() && noted_.IsAnyWord(next, {"more", "others"}) ? 1 : 0;
  if (noted_.IsWord(next, "in") && noted_.IsAnyWord(next + 1, {"number", "all", "total"})) more = 2;
  // "sixty heads", "five to a corner"
  if (noted_.IsAnyWord(next, {"heads", "head", "members", "individuals", "strong"})) more = 1;
  const bool each =
      noted_.IsAnyWord(next, {"each", "apiece"}) ||
      (noted_.IsAnyWord(next, {"to", "per", "in", "at", "for"}) &&
       (noted_.IsAnyWord(next, {"per"}) || noted_.IsAnyWord(next + 1, {"a", "each", "every"})) &&
       groups_[last_].wish.places.size() > 1);
  if (of_them == 0 && !each && !EndsNounPhrase(next + more)) return 0;
  Group& whole = groups_[last_];
  if (each && whole.wish.places.size() > 1 && !whole.wish.counted) {
    SetCount(count, &whole);
    whole.wish.each = true;
    std::size_t end = next;
    while (!noted_.IsPause(end)) ++end;
    noted_.Mark(at_, end, &TokenNote::agent);
    return end - at_;
  }
  if (of_them == 0 && more == 0 && noted_.IsAnyWord(at_, {"flock", "flocks"}) &&
      LocomotionOf(whole.wish.categories.front()) == Locomotion::kLegs && last_ != kNone &&
      whole.wish.categories.front() != AgentCategory::kSheep) {
    // "a shepherd and his flock of sixty"
    AddLike(last_, count, count.tokens);
    AgentWish& flock = groups_[last_].wish;
    flock.categories = {AgentCategory::kSheep};
    flock.exact = true;
    flock.name = "flock";
    flock.state.reset();
    noted_.Mark(at_, at_ + count.tokens, &TokenNote::agent);
    return count.tokens;
  }
  const std::size_t tokens = count.tokens + std::max(of_them, more);
  noted_.Mark(at_, at_ + tokens, &TokenNote::agent);
  if (corrected_ && of_them == 0 && more == 0) {
    SetCount(count, &whole);
    Extend(last_, tokens_[at_ + count.tokens - 1].end);
    subject_ = {last_};
    return tokens;
  }
  // "goblins x4 in the north"
  const std::size_t noun_end = at_ > 0 && noted_.IsWord(at_ - 1, "x") ? at_ - 1 : at_;
  const bool follows =
      noun_end > 0 && noted_.notes[noun_end - 1].agent && tokens_[noun_end - 1].end == whole.end;
  if (follows && of_them == 0 && more == 0 && !whole.wish.counted) {
    SetCount(count, &whole);
    Extend(last_, tokens_[at_ + count.tokens - 1].end);
    return tokens;
  }
  const bool told = !whole.wish.places.empty() || whole.wish.feature.has_value();
  const bool bare = noted_.IsPause(at_ + tokens);
  // "a herd of horses, nine of them", "an ambush: six of them lie in wait", "sheep, five in number"
  const bool more_than_said = of_them > 0 && count.least > whole.wish.most;
  const bool heads = noted_.IsAnyWord(next, {"heads", "head", "members", "individuals", "strong"});
  if (!whole.wish.counted && ((bare && (of_them > 0 || more == 2 || heads)) || more_than_said)) {
    SetCount(count, &whole);
    subject_ = {last_};
    return tokens;
  }
  if (bare && of_them == 0 && more == 0 && whole.wish.counted && lead_set_ && at_ > 0 &&
      noted_.notes[at_ - 1].place) {
    // "in the north five goblins, in the south seven"
    AddLike(last_, count, tokens);
    return tokens;
  }
  if (bare && of_them == 0 && more == 0) {
    // "sheep: lower left, nine", "... There are four."
    const bool told_so = at_ > 0 && noted_.IsAnyWord(at_ - 1, {"are", "is", "were"});
    if (!whole.wish.counted && (whole.sentence == sentence_ || told_so)) SetCount(count, &whole);
    return tokens;
  }
  const int left = part_ != kNone ? groups_[last_].wish.quantity : whole.wish.quantity;
  const bool splits =
      of_them > 0 || (!told && more == 0 && count.value <= left && (left > 1 || part_ != kNone) &&
                      (whole.wish.counted || part_ != kNone));
  if (splits) {
    Split(count, std::min(count.value, std::max(1, left)), tokens);
    return tokens + RenamePart(at_ + tokens);
  }
  // "two goblins in the north and three in the south"
  AddLike(last_, count, tokens);
  return tokens;
}

bool AgentReader::EndsNounPhrase(std::size_t at) const {
  if (noted_.IsPause(at)) return true;
  if (RoleAt(Role::kIn, at) > 0 || RoleAt(Role::kNear, at) > 0 || RoleAt(Role::kBut, at) > 0) {
    return true;
  }
  if (MatchPlace(tokens_, at).tokens > 0) return true;
  if (words_.states.LengthAt(tokens_, at) > 0) return true;
  return noted_.IsAnyWord(
      at, {"is",     "are",    "and",  "or",   "instead", "please", "there", "here",
           "should", "will",   "were", "was",  "that",    "who",    "have",  "has",
           "not",    "rather", "more", "only", "each",    "then",   "may",   "can"});
}

void AgentReader::SetCount(const Count& count, Group* group) {
  group->wish.least = count.least;
  group->wish.quantity = count.value;
  group->wish.most = count.most;
  group->wish.counted = count.least == count.most;
}

bool AgentReader::IsVerbHere(std::size_t at, bool counted) const {
  const std::size_t noun = words_.species.LengthAt(tokens_, at);
  if (words_.states.LengthAt(tokens_, at) < noun) return false;
  if (counted) return false;
  if (at > 0 && (noted_.IsAnyWord(at - 1, {"a", "an", "the", "no", "by", "some", "these"}) ||
                 IsParticiple(at - 1))) {
    return false;
  }
  return true;
}

std::size_t AgentReader::ReadSpecies() {
  const auto match = words_.species.At(tokens_, at_);
  if (match.tokens == 0 || groups_.size() >= kMaxGroups) return 0;
  std::size_t end = at_ + match.tokens;
  SpeciesWord word = *match.rows.front();
  if (pending_.tokens == 0 && IsVerbHere(at_, false)) return 0;
  // "flying robots" are agents that fly, and a name of its own.
  if (words_.coarse.LengthAt(tokens_, at_) > match.tokens && pending_.tokens == 0) return 0;
  const bool dead = at_ > 0 && noted_.IsAnyWord(at_ - 1, {"dead", "carved", "painted", "stuffed"});
  if (dead || IsPossessive(end) ||
      (!match.rows.front()->plural && end < tokens_.size() && !noted_.IsPause(end) &&
       RoleAt(Role::kAfterSpecies, end) > 0) ||
      (match.rows.front()->plural && match.rows.front()->singular && end < tokens_.size() &&
       RoleAt(Role::kAfterSpecies, end) > 0)) {
    noted_.Mark(at_, end, &TokenNote::agent);
    pending_ = {};
    return match.tokens;
  }
  // "cart tracks" are a road.
  if (words_.variants.LengthAt(tokens_, at_) > match.tokens ||
      words_.assets.LengthAt(tokens_, at_) > match.tokens) {
    return 0;
  }
  // "Agents: ..." is a heading.
  const bool heads = end < tokens_.size() && tokens_[end].text == ":" && pending_.tokens == 0;
  if (heads && match.rows.front()->categories.size() > 1) {
    noted_.Mark(at_, end, &TokenNote::agent);
    return match.tokens;
  }
  // "robot sheep": the last noun says what they are, unless it is that of their kind ("dog robot").
  if (!word.plural && IsUnknownHere(end) && words_.species.LengthAt(tokens_, end + 1) > 0) {
    // "humanoid rescue robots"
    const SpeciesWord& kind = *words_.species.At(tokens_, end + 1).rows.front();
    if (kind.categories.size() > 1 && Contains(kind.categories, word.categories)) ++end;
  }
  if (end < tokens_.size() && !word.plural && words_.species.LengthAt(tokens_, end) > 0 &&
      !IsVerbHere(end, false)) {
    const auto last = words_.species.At(tokens_, end);
    const SpeciesWord& kind = *last.rows.front();
    if (kind.categories.size() < 2 || !Contains(kind.categories, word.categories)) {
      noted_.Mark(at_, end, &TokenNote::agent);
      return match.tokens;
    }
    end += last.tokens;
    word.plural = kind.plural;
    word.singular = kind.singular;
  }
  noted_.Mark(at_, end, &TokenNote::agent);
  // "a pack mule" is one.
  if (IsBarePack() && word.singular && !word.plural) pending_ = {1, 1, 1, pending_.tokens};
  if (pending_.tokens > 0) {
    noted_.Mark(count_at_, count_at_ + pending_.tokens, &TokenNote::agent);
  }
  if (!noted_.notes[at_].negated && IsApposition(word, end)) return end - at_;
  // "wolf pack", but "swans drift"
  const Count collective = word.plural && !word.singular ? Count{} : ReadPack(end);
  noted_.Mark(end, end + collective.tokens, &TokenNote::agent);
  if (noted_.notes[at_].negated) {
    ReadAbsence(word, end);
  } else {
    ReadPresence(word, collective, end);
    if (part_of_ > 0 && last_ != kNone && groups_[last_].wish.quantity > part_of_) {
      Split({part_of_, part_of_, part_of_, 1}, part_of_, end - at_);
      halved_ = rest_;
    }
  }
  part_of_ = 0;
  pending_ = {};
  phrase_begin_ = kNone;
  return end + collective.tokens - at_;
}

bool AgentReader::IsBarePack() const {
  const std::size_t end = count_at_ + pending_.tokens;
  return pending_.least < pending_.most && end == at_ && at_ > 0 &&
         ReadCollective(noted_, words_, at_ - 1).tokens > 0;
}

bool AgentReader::IsUnknownHere(std::size_t at) const {
  return !noted_.IsPause(at) && RoleAt(Role::kFunction, at) == 0 && RoleAt(Role::kIn, at) == 0 &&
         RoleAt(Role::kNear, at) == 0 && RoleAt(Role::kBut, at) == 0 &&
         words_.states.LengthAt(tokens_, at) == 0 && words_.species.LengthAt(tokens_, at) == 0 &&
         ReadCount(noted_, words_, at).tokens == 0;
}

bool AgentReader::IsInPurpose() const {
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
bool AgentReader::IsApposition(const SpeciesWord& word, std::size_t end) const {
  return word.categories.size() > 1 && pending_.tokens == 0 && at_ > 1 && last_ != kNone &&
         noted_.IsAnyWord(at_ - 1, {"a", "an"}) && noted_.IsPause(at_ - 2) && noted_.IsPause(end) &&
         tokens_[at_ - 2].kind == TokenKind::kComma && groups_[last_].wish.quantity == 1 &&
         groups_[last_].sentence == sentence_ && !groups_[last_].removed &&
         Contains(word.categories, groups_[last_].wish.categories);
}

Count AgentReader::ReadPack(std::size_t end) const {
  if (end >= tokens_.size() || words_.states.LengthAt(tokens_, end) > 0) return {};
  Count pack = ReadCollective(noted_, words_, end);
  if (pack.tokens == 0 || !noted_.IsWord(end + 1, "of")) return pack;
  Count counted = end + 2 < tokens_.size() ? ReadCount(noted_, words_, end + 2) : Count{};
  if (counted.tokens == 0 || !EndsNounPhrase(end + 2 + counted.tokens)) return pack;
  counted.tokens += 2;
  return counted;
}

bool AgentReader::IsPossessive(std::size_t end) const {
  const Token& noun = tokens_[end - 1];
  // "'s" is within the token.
  const std::string_view text = noted_.Text(end - 1, end);
  if (text.find('\'') != text.npos || text.find("\xE2\x80\x99") != text.npos) return true;
  const std::string_view after = noted_.instruction.substr(noun.end);
  return after.size() > 1 && after[0] == '\'' && after[1] == ' ';
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
  const bool placed = PlaceFollows(end);
  absent_here_ = placed;
  const bool other = at_ > 0 && noted_.IsWord(at_ - 1, "other");
  // A word of a species that we lack denies that species only, not the one that stands for it.
  if (!placed && !other) {
    for (Group& group : groups_) {
      const bool same = std::any_of(
          claim.categories.begin(), claim.categories.end(),
          [&](AgentCategory category) { return category == group.wish.categories.front(); });
      if (same && (word.exact || group.wish.name == NameHere(end))) group.removed = true;
    }
    if (word.exact || claim.categories.size() > 1) heard_.absences.push_back(std::move(claim));
  }
  state_before_.reset();
}

std::vector<AgentCategory> AgentReader::AbsentCategories(const SpeciesWord& word,
                                                         std::size_t tokens) const {
  const auto kind = words_.kinds.At(tokens_, at_);
  if (kind.tokens >= tokens && !kind.rows.empty()) return kind.rows.front()->categories;
  return word.categories;
}

bool AgentReader::PlaceFollows(std::size_t at) const {
  return !noted_.IsPause(at) && (RoleAt(Role::kIn, at) > 0 || RoleAt(Role::kNear, at) > 0);
}

Count AgentReader::DefaultCount(const SpeciesWord& word) const {
  const bool article =
      at_ > 0 && noted_.IsAnyWord(at_ - 1, {"a", "an", "one", "another", "each", "every"});
  if (word.plural && !(word.singular && (article || NearArticle()))) return kSomeSeen;
  return {1, 1, 1, 0};
}

bool AgentReader::NearArticle() const {
  for (std::size_t i = at_; i > 0 && i + 4 > at_; --i) {
    if (noted_.IsPause(i - 1)) return false;
    if (noted_.IsAnyWord(i - 1, {"a", "an", "another"})) return true;
    if (!noted_.notes[i - 1].known) return false;
  }
  return false;
}

bool AgentReader::IsDefinite() const {
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

void AgentReader::ReadPresence(const SpeciesWord& word, const Count& collective, std::size_t end) {
  Count count = pending_;
  if (collective.tokens > 0) count = collective;
  // "three wolf packs"
  if (collective.tokens == 1 && pending_.tokens > 0 && pending_.value <= 12) {
    count = {collective.least * pending_.value, collective.value * pending_.value,
             collective.most * pending_.value, 1};
  }
  const std::vector<std::size_t> same = GroupsOf(word, end);
  if (!same.empty() && (IsDefinite() || corrected_)) {
    ReferTo(same, count, end);
    return;
  }
  if (corrected_ && last_ != kNone && !groups_[last_].removed && !told_since_correction_) {
    Replace(word, count, end);
    return;
  }
  DropVagueKinds(word);
  if (const std::size_t vague = VagueBefore(same, count, end); vague != kNone) {
    ReferTo({vague}, {}, end);
    SetCount(count, &groups_[vague]);
    return;
  }
  Group group;
  group.wish.categories = word.categories;
  group.wish.exact = word.exact;
  group.wish.name = NameHere(end);
  const Count said = count.tokens > 0 ? count : DefaultCount(word);
  group.wish.least = said.least;
  group.wish.quantity = said.value;
  group.wish.most = said.most;
  group.wish.counted = count.tokens > 0 && count.least == count.most;
  group.wish.each = noted_.IsAnyWord(at_ > 0 ? at_ - 1 : at_, {"each", "every"});
  group.purpose = IsInPurpose();
  group.wish.state = state_before_;
  group.begin = std::min(phrase_begin_, tokens_[at_].begin);
  group.end = tokens_[end - 1].end;
  group.sentence = sentence_;
  ApplyLead(&group);
  // "goblins chase sheep": the chased are no subject.
  const bool object =
      acted_ && !subject_.empty() && !state_before_.has_value() && !joined_ && !paused_;
  groups_.push_back(std::move(group));
  const std::size_t index = groups_.size() - 1;
  last_ = index;
  part_ = rest_ = kNone;
  split_state_ = false;
  state_before_.reset();
  if (object) {
    object_ = index;
    object_end_ = end;
    return;
  }
  if (!(joined_ || paused_) || GroupIsTold() || new_clause_) subject_.clear();
  subject_.push_back(index);
  previous_ = subject_;
  joined_ = false;
  paused_ = false;
  acted_ = false;
  new_clause_ = false;
  object_ = kNone;
}

void AgentReader::DropVagueKinds(const SpeciesWord& word) {
  for (Group& group : groups_) {
    const AgentWish& wish = group.wish;
    const bool told =
        wish.counted || wish.state.has_value() || !wish.places.empty() || wish.feature.has_value();
    if (wish.categories.size() < 2 || word.categories.size() > 1 || told) continue;
    if (group.sentence != sentence_ && Contains(wish.categories, word.categories)) {
      group.removed = true;
    }
  }
}

std::size_t AgentReader::VagueBefore(const std::vector<std::size_t>& same, const Count& count,
                                     std::size_t end) const {
  const bool alone = noted_.IsPause(end) || noted_.IsWord(end, "and");
  if (same.size() != 1 || count.tokens == 0 || !alone || lead_set_ || state_before_.has_value()) {
    return kNone;
  }
  const Group& group = groups_[same.front()];
  const AgentWish& wish = group.wish;
  const bool bare = wish.least == kSomeSeen.least && wish.most == kSomeSeen.most;
  return bare && group.sentence != sentence_ ? same.front() : kNone;
}

std::vector<std::size_t> AgentReader::GroupsOf(const SpeciesWord& word, std::size_t end) const {
  std::vector<std::size_t> same;
  const std::string name = Singular(NameHere(end));
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const AgentWish& wish = groups_[i].wish;
    if (groups_[i].removed || wish.categories != word.categories) continue;
    // Wolves and bears are both read as goblins, and stay apart.
    if (!wish.exact && !word.exact && Singular(wish.name) != name) continue;
    if (wish.exact != word.exact) continue;
    same.push_back(i);
  }
  return same;
}

void AgentReader::ReferTo(const std::vector<std::size_t>& same, const Count& count,
                          std::size_t end) {
  std::vector<std::size_t> groups = same;
  if (corrected_) groups = {same.back()};
  if (count.tokens > 0) {
    std::vector<std::size_t> equal;
    for (const std::size_t i : same) {
      if (groups_[i].wish.quantity == count.value) equal.push_back(i);
    }
    if (!equal.empty()) groups = equal;
    if (equal.empty() && corrected_) SetCount(count, &groups_[groups.back()]);
  }
  const bool object = acted_ && !subject_.empty() && !state_before_.has_value() && !joined_ &&
                      !paused_ && !corrected_;
  if (object) return;
  subject_ = groups;
  previous_ = groups;
  last_ = groups.back();
  part_ = rest_ = kNone;
  if (state_before_.has_value()) {
    for (const std::size_t i : groups) groups_[i].wish.state = state_before_;
    state_before_.reset();
  }
  if (corrected_ || lead_set_) {
    for (const std::size_t i : groups) ApplyLead(&groups_[i]);
  }
  for (const std::size_t i : groups) {
    if (groups_[i].sentence == sentence_) Extend(i, tokens_[end - 1].end);
  }
  joined_ = paused_ = acted_ = false;
  told_since_correction_ = true;
}

void AgentReader::Replace(const SpeciesWord& word, const Count& count, std::size_t end) {
  Group& group = groups_[last_];
  heard_.warnings.push_back(Quote(WordsOf(group)) + " was taken back for " +
                            Quote(noted_.Text(at_, end)));
  group.wish.categories = word.categories;
  group.wish.exact = word.exact;
  group.wish.name = NameHere(end);
  if (count.tokens > 0) SetCount(count, &group);
  if (!group.wish.counted) {
    const Count said = DefaultCount(word);
    group.wish.least = said.least;
    group.wish.quantity = said.value;
    group.wish.most = said.most;
  }
  if (state_before_.has_value()) group.wish.state = state_before_;
  state_before_.reset();
  group.begin = std::min(phrase_begin_, tokens_[at_].begin);
  group.end = tokens_[end - 1].end;
  subject_ = {last_};
  previous_ = subject_;
  told_since_correction_ = true;
  joined_ = paused_ = false;
  ApplyLead(&group);
}

void AgentReader::ApplyLead(Group* group) const {
  if (!lead_places_.empty()) group->wish.places = lead_places_;
  if (lead_feature_.has_value()) group->wish.feature = lead_feature_;
  if (lead_each_) group->wish.each = true;
}

bool AgentReader::GroupIsTold() const {
  return std::any_of(subject_.begin(), subject_.end(), [&](std::size_t index) {
    const AgentWish& wish = groups_[index].wish;
    const bool placed = (!wish.places.empty() && lead_places_.empty()) ||
                        (wish.feature.has_value() && !lead_feature_.has_value());
    return placed || (wish.state.has_value() && acted_on_ == sentence_ + 1);
  });
}

}  // namespace internal

}  // namespace latticeworld
