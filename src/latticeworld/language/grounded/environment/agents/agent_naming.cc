// Reading about agents: what a noun phrase does to the groups: names new ones, refers to
// those of before, corrects or denies them.

#include <algorithm>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/environment/agents/agent_steps.h"
#include "latticeworld/language/numbers.h"

namespace latticeworld {
namespace internal {

void AgentReader::ReadPresence(const SpeciesWord& word, const Count& collective, std::size_t end) {
  const Count count = CountWith(collective);
  if (ReadKnown(word, count, end)) return;
  // "goblins chase sheep": the chased are no subject.
  const bool object =
      acted_ && !subject_.empty() && !state_before_.has_value() && !joined_ && !paused_;
  groups_.push_back(NewGroup(word, count, end));
  const std::size_t index = groups_.size() - 1;
  JoinSubjectTo(index);
  // "Half of them chase a horse, the other half sleep": the other half of those who chase it.
  if (!object || part_ == kNone) {
    last_ = index;
    part_ = rest_ = kNone;
  }
  unit_ = PackSize();
  packs_ = PackCount();
  everybody_ = false;
  split_state_ = false;
  state_before_.reset();
  if (object) {
    MakeObject(index, end);
  } else {
    MakeSubject(index);
  }
}

Count AgentDiscourse::CountWith(const Count& collective) const {
  // "three wolf packs"
  if (collective.tokens == 1 && pending_.tokens > 0 && pending_.value <= 12) {
    return {CappedProduct(collective.least, pending_.value),
            CappedProduct(collective.value, pending_.value),
            CappedProduct(collective.most, pending_.value), 1};
  }
  return collective.tokens > 0 ? collective : pending_;
}

bool AgentReader::ReadKnown(const SpeciesWord& word, const Count& count, std::size_t end) {
  if (substituted_ != kNone) {
    last_ = substituted_;
    substituted_ = kNone;
    Replace(word, count, end);
    return true;
  }
  std::vector<std::size_t> same = GroupsOf(word, at_, end);
  if (same.empty() && IsDefinite()) same = GroupsCalled(end);
  // "each knight has a dog"
  const bool every = at_ > 0 && noted_.IsAnyWord(at_ - 1, {"each", "every"});
  if (every && !same.empty() && count.tokens == 0) {
    ReferTo(same, {}, end);
    if (noted_.IsAnyWord(end, {"has", "leads", "carries", "rides", "with", "walks", "keeps"})) {
      times_ = TotalOf(same);
    }
    return true;
  }
  if (!same.empty() && (IsDefinite() || corrected_) && !IsAnotherOne(word, same, end)) {
    ReferTo(same, count, end);
    return true;
  }
  if (corrected_ && last_ != kNone && !groups_[last_].removed && !told_since_correction_) {
    Replace(word, count, end);
    return true;
  }
  if (IsSum(word, count, end)) return true;
  DropVagueKinds(word);
  if (const std::size_t vague = VagueBefore(same, count, end); vague != kNone) {
    ReferTo({vague}, {}, end);
    SetCount(count, &groups_[vague]);
    return true;
  }
  return false;
}

Group AgentReader::NewGroup(const SpeciesWord& word, const Count& count, std::size_t end) {
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
  if (IsBygone()) {
    group.wish.least = kSomeSeen.least;
    group.wish.quantity = kSomeSeen.value;
    group.wish.most = kSomeSeen.most;
    group.wish.counted = false;
  }
  CountForEachOwner(end, &group);
  PutInCompany(&group);
  group.purpose = IsInPurpose();
  group.wish.state = state_before_;
  group.begin = std::min(phrase_begin_, tokens_[at_].begin);
  group.end = tokens_[end - 1].end;
  group.sentence = sentence_;
  ApplyLead(&group);
  if (model_ != kNone) {
    const AgentWish& model = groups_[model_].wish;
    if (!group.wish.state.has_value()) group.wish.state = model.state;
    group.with = model_;
    model_ = kNone;
  }
  return group;
}

void AgentReader::CountForEachOwner(std::size_t end, Group* group) {
  // "four knights with a dog each"
  if (times_ == 1 && noted_.IsAnyWord(end, {"each", "apiece"}) && IsHad()) {
    times_ = TotalOf(subject_);
    if (group->with == kNone) group->with = subject_.front();
  }
  if (times_ > 1) {
    AgentWish& wish = group->wish;
    wish.least = CappedProduct(wish.least, times_);
    wish.quantity = CappedProduct(wish.quantity, times_);
    wish.most = CappedProduct(wish.most, times_);
    wish.counted = wish.least == wish.most;
    if (group->with == kNone && !subject_.empty()) group->with = subject_.front();
  }
  times_ = 1;
}

void AgentReader::PutInCompany(Group* group) {
  // "a shepherd by the lake with his thirty sheep and two dogs"
  const std::size_t first = pending_.tokens > 0 ? count_at_ : at_;
  const bool listed = noted_.IsWord(first > 0 ? first - 1 : 0, "and") && with_ != kNone &&
                      last_ == groups_.size() - 1;
  if (group->with == kNone && by_subject_ != kNone) group->with = by_subject_;
  by_subject_ = kNone;
  if (group->with == kNone && IsHad()) group->with = subject_.front();
  if (group->with == kNone && listed) group->with = with_;
  with_ = group->with;
}

void AgentReader::MakeObject(std::size_t index, std::size_t end) {
  // Who chases somebody is where those are.
  for (const std::size_t owner : subject_) {
    if (groups_[owner].with == kNone && owner != index) groups_[owner].with = index;
  }
  object_ = index;
  object_end_ = end;
}

void AgentReader::MakeSubject(std::size_t index) {
  // "ten agents: six sheep in the west ...": the ten are not in the west.
  const bool listed_here =
      index > 0 && groups_[index - 1].wish.categories.size() > 1 && IsListed(index - 1) &&
      Contains(groups_[index - 1].wish.categories, groups_[index].wish.categories);
  if (!(joined_ || paused_) || GroupIsTold() || new_clause_ || listed_here) subject_.clear();
  subject_.push_back(index);
  previous_ = subject_;
  joined_ = false;
  paused_ = false;
  acted_ = false;
  new_clause_ = false;
  object_ = kNone;
}

bool AgentDiscourse::IsAnotherOne(const SpeciesWord& word, const std::vector<std::size_t>& same,
                                  std::size_t end) const {
  if (corrected_ || pending_.tokens > 0 || word.plural || !word.singular) return false;
  const std::string name = Singular(NameHere(end));
  return std::all_of(same.begin(), same.end(), [&](std::size_t index) {
    const AgentWish& wish = groups_[index].wish;
    return wish.counted && wish.quantity > 1 && Singular(wish.name) != name;
  });
}

int AgentDiscourse::PackCount() const {
  // "two packs of wolves"
  if (pending_.tokens < 3 || pending_.least == pending_.most) return 0;
  const NumberMatch packs = MatchNumber(tokens_, count_at_);
  const std::size_t pack = count_at_ + packs.tokens;
  return packs.tokens > 0 && ReadCollective(noted_, words_, pack).tokens > 0 ? packs.value : 0;
}

int AgentDiscourse::PackSize() const {
  // "two teams of four humanoids"
  for (std::size_t i = count_at_; pending_.tokens > 2 && i + 1 < count_at_ + pending_.tokens; ++i) {
    if (ReadCollective(noted_, words_, i).tokens == 0 || !noted_.IsWord(i + 1, "of")) continue;
    const Count inner = ReadCount(noted_, words_, i + 2);
    if (i > count_at_ && inner.tokens > 0 && inner.least == inner.most) return inner.value;
  }
  return 1;
}

bool AgentDiscourse::IsBygone() const {
  constexpr std::size_t kReach = 8;
  for (std::size_t i = at_; i > 1 && i + kReach > at_ && !noted_.IsEnd(i - 1); --i) {
    if (noted_.IsWord(i - 1, "to") && noted_.IsWord(i - 2, "used")) return true;
    if (noted_.IsAnyWord(i - 1, {"formerly", "previously"})) return true;
  }
  return false;
}

bool AgentDiscourse::IsSum(const SpeciesWord& word, const Count& count, std::size_t end) const {
  if (count.tokens == 0 || count.least != count.most) return false;
  const bool summed = noted_.IsAnyWord(end, {"altogether", "total", "overall"}) ||
                      (noted_.IsAnyWord(end, {"in", "all"}) &&
                       noted_.IsAnyWord(end + 1, {"all", "total", "told", "sum"}));
  int sum = 0;
  for (const Group& group : groups_) {
    if (!group.removed && Contains(word.categories, group.wish.categories)) {
      sum += group.wish.quantity;
    }
  }
  return summed && sum == count.value;
}

bool AgentDiscourse::IsHad() const {
  if (subject_.empty()) return false;
  std::size_t first = pending_.tokens > 0 ? count_at_ : at_;
  while (first > 0 &&
         noted_.IsAnyWord(first - 1, {"a", "an", "the", "their", "own", "his", "her", "its"})) {
    --first;
  }
  if (first == 0) return false;
  // "led by a drone"
  if (first > 1 && noted_.IsWord(first - 1, "by")) {
    return noted_.IsAnyWord(first - 2, {"led", "followed", "escorted", "accompanied", "joined",
                                        "watched", "supervised", "flanked", "herded", "driven"});
  }
  return noted_.IsAnyWord(first - 1, {"with", "have", "has", "lead", "leading", "leads", "having",
                                      "bring", "bringing", "carrying", "herding", "walking"});
}

int AgentDiscourse::TotalOf(const std::vector<std::size_t>& groups) const {
  int total = 0;
  for (const std::size_t index : groups) {
    total += std::min(groups_[index].wish.quantity, kMaxAgents);
  }
  return std::clamp(total, 1, kMaxAgents);
}

void AgentReader::DropVagueKinds(const SpeciesWord& word) {
  for (Group& group : groups_) {
    const AgentWish& wish = group.wish;
    const bool bound = SaysNumber(wish) && wish.quantity > 1;
    const bool told = wish.counted || bound || wish.state.has_value() || wish.IsPlaced();
    if (wish.categories.size() < 2 || word.categories.size() > 1 || told) continue;
    if (group.sentence != sentence_ && Contains(wish.categories, word.categories)) {
      group.removed = true;
    }
  }
}

bool AgentDiscourse::IsBareSentence(const Group& group) const {
  if (group.wish.state.has_value() || group.wish.IsPlaced()) return false;
  const bool alone = std::none_of(groups_.begin(), groups_.end(), [&](const Group& other) {
    return &other != &group && other.sentence == group.sentence;
  });
  if (!alone) return false;
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    if (tokens_[i].begin != group.begin) continue;
    if (i > 0 && !noted_.IsPause(i - 1)) return false;
    while (i < tokens_.size() && tokens_[i].end < group.end) ++i;
    return noted_.IsEnd(i + 1);
  }
  return false;
}

std::size_t AgentDiscourse::VagueBefore(const std::vector<std::size_t>& same, const Count& count,
                                        std::size_t end) const {
  const bool alone = noted_.IsPause(end) || noted_.IsWord(end, "and") ||
                     (same.size() == 1 && IsBareSentence(groups_[same.front()]));
  if (same.size() != 1 || count.tokens == 0 || !alone || lead_.set || state_before_.has_value()) {
    return kNone;
  }
  const Group& group = groups_[same.front()];
  const AgentWish& wish = group.wish;
  const bool bare = wish.least == kSomeSeen.least && wish.most == kSomeSeen.most;
  return bare && group.sentence != sentence_ ? same.front() : kNone;
}

std::vector<std::size_t> AgentDiscourse::GroupsOf(const SpeciesWord& word, std::size_t first,
                                                  std::size_t end) const {
  std::vector<std::size_t> same;
  const std::string name = Singular(JoinWords(tokens_, first, end));
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

std::vector<std::size_t> AgentDiscourse::GroupsCalled(std::size_t end) const {
  const std::string last = " " + Singular(NameHere(end));
  std::vector<std::size_t> called;
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const std::string name = Singular(groups_[i].wish.name);
    const bool ends = name.size() > last.size() &&
                      name.compare(name.size() - last.size(), last.size(), last) == 0;
    if (!groups_[i].removed && ends) called.push_back(i);
  }
  return called;
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
  if (object) {
    for (const std::size_t owner : subject_) {
      if (groups_[owner].with == kNone && owner != groups.front()) {
        groups_[owner].with = groups.front();
      }
    }
    return;
  }
  subject_ = groups;
  previous_ = groups;
  last_ = groups.back();
  part_ = rest_ = kNone;
  if (state_before_.has_value()) {
    for (const std::size_t i : groups) groups_[i].wish.state = state_before_;
    state_before_.reset();
  }
  if (corrected_ || lead_.set) {
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

void AgentDiscourse::ApplyLead(Group* group) const {
  if (!lead_.places.empty()) group->wish.places = lead_.places;
  if (lead_.feature.has_value()) group->wish.feature = lead_.feature;
  if (lead_.each) group->wish.each = true;
  if (lead_.with != kNone) group->with = lead_.with;
}

bool AgentDiscourse::GroupIsTold() const {
  return std::any_of(subject_.begin(), subject_.end(), [&](std::size_t index) {
    const AgentWish& wish = groups_[index].wish;
    const bool placed = (!wish.places.empty() && lead_.places.empty()) ||
                        (wish.feature.has_value() && !lead_.feature.has_value());
    return placed || (wish.state.has_value() && acted_on_ == sentence_ + 1);
  });
}

}  // namespace internal

}  // namespace latticeworld
