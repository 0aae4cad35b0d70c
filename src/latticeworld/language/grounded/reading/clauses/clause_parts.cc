#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

// One of several: the third of these, the arm of a river, one island of two, one road more.
namespace latticeworld {

// "A lake, a village, a wood. A path starts at the first, passes the second and ends at the third":
// by the order of being introduced, in the sentences before; -1: there are no three.
int ClauseReader::NthOfThese(std::size_t n) const {
  const std::string said = ToLowerAscii(d_.instruction());
  if (said.find("the third") == std::string::npos) return -1;
  std::vector<int> these;
  for (int i = 0; i < d_.size(); ++i) {
    if (!d_.thing(i).dropped && d_.thing(i).sentence < d_.sentence()) these.push_back(i);
  }
  return these.size() == 3 ? these[n] : -1;
}

// "two of them", of three: fewer than there are.
bool ClauseReader::SomeOf(const NounPhrase& phrase, int index) const {
  const std::optional<CountMatch>& count = phrase.qualities.count;
  return phrase.head == Head::kThey && count.has_value() && count->least == count->most &&
         d_.feature(index).pieces > count->least && d_.feature(index).pieces_least > count->least;
}

// The last of the things that a thing is one of, but for those that the words are about.
std::vector<int> ClauseReader::Likes(int index, const std::vector<int>& about) const {
  for (int i = d_.size() - 1; i >= 0; --i) {
    const bool same = d_.thing(i).dropped ||
                      std::find(about.begin(), about.end(), i) != about.end() ||
                      (about.size() > 0 && d_.feature(i).letter == d_.feature(about[0]).letter);
    if (!same && (d_.thing(i).plural || d_.feature(i).pieces_least > 0 || IsLine(i))) return {i};
  }
  return {index};
}

// "The river forks: one arm leaves in the west, the other in the east": the first arm is the river
// itself, the second one branches off it.
std::vector<int> ClauseReader::Arm(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  const std::string_view noun = phrase.noun->phrase;
  if (noun != "arm" && noun != "branch" && noun != "distributary" && noun != "river branch") {
    return {};
  }
  const int river = d_.Latest('W', FeatureForm::kLine);
  // "a crossroads; each arm goes to the border"
  const int road = d_.Latest('R', FeatureForm::kLine);
  if (river < 0 && road >= 0 && noun == "arm") return {road};
  if (river < 0 || phrase.plural) return {};
  if (fork_ != river && !d_.feature(river).to.has_value()) {
    fork_ = first_ = river;
    return {river};
  }
  const int created = d_.Create(phrase, chunk.begin, chunk.end);
  if (created < 0) return {};
  BranchOff(created, river);
  first_ = -1;
  return {created};
}

void ClauseReader::BranchOff(int arm, int river) {
  Waypoint from;
  from.feature = river;
  d_.feature(arm).from = from;
  d_.feature(arm).pieces = d_.feature(arm).pieces_least = d_.feature(arm).pieces_most = 0;
}

// "two islands, one of them bare rock, the other wooded": of another class than islands are.
std::vector<int> ClauseReader::IslandOf(const NounPhrase& phrase) {
  if (phrase.head != Head::kOne && phrase.head != Head::kOther) return {};
  const char letter = phrase.noun->LetterIn(d_.plan().vocabulary);
  int island = -1;
  if (phrase.head == Head::kOther && split_ >= 0) island = std::exchange(split_, -1);
  for (int i = d_.size() - 1; i >= 0 && island < 0 && phrase.head == Head::kOne; --i) {
    if (d_.thing(i).dropped || !d_.thing(i).is_island || d_.feature(i).pieces < 2) continue;
    split_ = i;
    island = d_.SplitOff(i);
    for (const PlannedRelation& relation : std::vector<PlannedRelation>(d_.plan().relations)) {
      if (relation.kind != RelationKind::kWithin || relation.subject != i) continue;
      PlannedRelation within = relation;
      within.subject = island;
      d_.Relate(std::move(within));
    }
  }
  if (island < 0 || !d_.thing(island).is_island || letter == '\0') return {};
  d_.feature(island).letter = letter;
  d_.thing(island).noun = phrase.noun;
  return {island};
}

// The line that runs along an axis: the last one, where its course is not said, else one more.
std::vector<int> ClauseReader::OneLine(const Chunk& chunk) {
  for (int i = d_.size() - 1; i >= 0; --i) {
    if (d_.thing(i).dropped || !IsLine(i)) continue;
    if (d_.feature(i).pieces > 1) return {};
    if (!d_.feature(i).from.has_value()) return {i};
    NounPhrase like;
    like.noun = d_.thing(i).noun;
    const int created = d_.Create(like, chunk.begin, chunk.end);
    if (created < 0) return {};
    PlannedRelation crosses;
    crosses.kind = RelationKind::kCrosses;
    crosses.subject = i;
    crosses.object = created;
    if (ToLowerAscii(d_.instruction()).find("cross") != std::string::npos) d_.Relate(crosses);
    return {created};
  }
  return {};
}

// "a village in the north and another in the south"; "two lakes, one here, another there".
std::vector<int> ClauseReader::OneMore(const Chunk& chunk) {
  int model = LastSubject();
  if (model < 0) model = d_.LastMentioned();
  if (model < 0) return {};
  for (int i = d_.size() - 1; i >= 0; --i) {
    const bool alike = d_.thing(i).noun == d_.thing(model).noun && !d_.thing(i).dropped;
    if (alike && d_.feature(i).pieces > 1 && d_.feature(i).pieces_least > 0) {
      return {d_.SplitOff(i)};
    }
  }
  if (split_ >= 0) return {std::exchange(split_, -1)};
  NounPhrase like = chunk.phrase;
  like.head = Head::kThing;
  like.noun = d_.thing(model).noun;
  const int created = d_.Create(like, chunk.begin, chunk.end);
  return created < 0 ? std::vector<int>() : std::vector<int>{created};
}

// "in each corner", "to each of the edges"
bool ClauseReader::IsEach(std::size_t at) const {
  if (IsSense(at, Sense::kIn) || IsSense(at, Sense::kTo)) ++at;
  if (IsSense(at, Sense::kAll)) ++at;
  if (!IsKind(at, ChunkKind::kPlace) || chunks_[at].lexeme.places.size() < 2) return false;
  const std::string words = ToLowerAscii(d_.Words(chunks_[at - 1].begin, chunks_[at].end));
  return words.find("each") != std::string::npos || words.find("every") != std::string::npos ||
         words.find("per ") != std::string::npos;
}

// What "one" is one of: what there are several of, else what was named last.
int ClauseReader::OneOfSeveral() const {
  for (int i = d_.size() - 1; i >= 0 && i >= d_.size() - 8; --i) {
    if (d_.thing(i).dropped) continue;
    if (d_.feature(i).pieces > 1) return i;
    for (int j = 0; j < i; ++j) {
      if (!d_.thing(j).dropped && d_.thing(j).noun == d_.thing(i).noun) return i;
    }
  }
  return d_.LastMentioned();
}

// "One road runs north-south, one east-west": the first was one, and is placed.
bool ClauseReader::OneAgain() const {
  const int last = d_.LastMentioned();
  if (last < 0 || d_.thing(last).sentence != d_.sentence()) return false;
  const PlannedFeature& feature = d_.feature(last);
  return feature.pieces_least == 1 && feature.pieces_most == 1 &&
         (!feature.zones.empty() || feature.from.has_value() || feature.to.has_value());
}

// The last of the things like `model` that has no place yet, where there are several; -1: none.
int ClauseReader::Unplaced(int model) {
  std::vector<int> like;
  for (int i = 0; i < d_.size(); ++i) {
    if (!d_.thing(i).dropped && d_.thing(i).noun == d_.thing(model).noun) like.push_back(i);
  }
  if (like.size() == 1 && d_.feature(model).pieces > 1 && d_.feature(model).zones.empty()) {
    split_ = model;
    return d_.SplitOff(model);
  }
  for (std::size_t i = like.size(); i-- > 0 && like.size() > 1;) {
    if (d_.feature(like[i]).zones.empty()) return like[i];
  }
  return -1;
}

// "Three villages. The first is ..., the second ..., the third ...": one of them; -1: there are not
// several of anything.
int ClauseReader::NextPart() {
  for (int i = d_.size() - 1; i >= 0 && i >= d_.size() - 8; --i) {
    if (d_.thing(i).dropped || d_.feature(i).pieces < 2 || d_.feature(i).pieces_least < 2) continue;
    split_ = i;
    return d_.SplitOff(i);
  }
  return -1;
}

}  // namespace latticeworld
