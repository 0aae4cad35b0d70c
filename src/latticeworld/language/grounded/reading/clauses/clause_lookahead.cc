#include <algorithm>
#include <string>
#include <string_view>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

namespace latticeworld {
namespace {

constexpr std::size_t kMaxListLookAhead = 16;  // chunks

}  // namespace

bool ClauseReader::IsKind(std::size_t at, ChunkKind kind) const {
  return at < chunks_.size() && chunks_[at].kind == kind;
}

bool ClauseReader::IsSense(std::size_t at, Sense sense) const {
  return at < chunks_.size() && chunks_[at].Is(sense);
}

bool ClauseReader::IsPhrase(std::size_t at) const { return IsKind(at, ChunkKind::kNounPhrase); }

bool ClauseReader::IsThing(std::size_t at) const {
  return IsPhrase(at) && chunks_[at].phrase.noun != nullptr;
}

bool ClauseReader::EndsAt(std::size_t at) const {
  return at >= chunks_.size() || chunks_[at].kind == ChunkKind::kStop;
}

std::size_t ClauseReader::SkipVerbs(std::size_t at) const {
  for (; at < chunks_.size(); ++at) {
    const Chunk& chunk = chunks_[at];
    if (chunk.kind != ChunkKind::kSense) break;
    const Sense sense = chunk.lexeme.sense;
    const bool verb = sense == Sense::kBe || sense == Sense::kStands || sense == Sense::kExists ||
                      sense == Sense::kRuns || sense == Sense::kWinds || sense == Sense::kHas ||
                      sense == Sense::kCoveredBy || sense == Sense::kDominates ||
                      sense == Sense::kMostly || sense == Sense::kEntirely ||
                      sense == Sense::kNothingElse || sense == Sense::kDominatedBy ||
                      sense == Sense::kThen || sense == Sense::kNot;
    if (!verb) break;
  }
  return at;
}

// Whether the words from `at` name a thing before the phrase ends: it is what stands there.
bool ClauseReader::ThingFollows(std::size_t at, bool over_comma) const {
  at = SkipVerbs(at);
  if (over_comma && IsKind(at, ChunkKind::kComma)) {
    at = SkipVerbs(at + 1);
    // "behind the hotels, further to the east, runs a road"
    std::size_t place = at;
    if (IsSense(place, Sense::kTo) || IsSense(place, Sense::kIn)) ++place;
    if (IsKind(place, ChunkKind::kPlace) && IsKind(place + 1, ChunkKind::kComma)) {
      at = SkipVerbs(place + 2);
    }
  }
  if (IsKind(at, ChunkKind::kQualities) && IsThing(at + 1)) ++at;
  return IsThing(at) || (IsPhrase(at) && (chunks_[at].phrase.head == Head::kOther ||
                                          chunks_[at].phrase.head == Head::kAnother ||
                                          chunks_[at].phrase.head == Head::kOne));
}

// Whether the relation at `at` comes before its subject: "next to the lake lies a village".
bool ClauseReader::Fronts(std::size_t at) const {
  if (at >= chunks_.size()) return false;
  const Chunk& relation = chunks_[at];
  std::size_t next = at + 1;
  // "Where they meet, rocks."
  const bool between_them =
      relation.Is(Sense::kBetween) && !IsPhrase(next) && !IsKind(next, ChunkKind::kPlace);
  const bool of_it = relation.lexeme.of_it || relation.Is(Sense::kWithinIt) || between_them;
  if (!of_it) {
    if (!IsPhrase(next) && !IsKind(next, ChunkKind::kPlace)) return false;
    ++next;
    const bool two = relation.Is(Sense::kBetween) && IsSense(next, Sense::kAnd);
    if (two && (IsPhrase(next + 1) || IsKind(next + 1, ChunkKind::kPlace))) next += 2;
    while (IsKind(next, ChunkKind::kPlace)) ++next;
    if (IsSense(next, Sense::kBothSides)) ++next;  // "behind the houses on both sides fields"
  }
  if (IsPhrase(next) && chunks_[next].phrase.head == Head::kMap) next = next + 1;
  // "cornfields and, next to the motorway, a service station"
  const bool aside = at >= 2 && IsKind(at - 1, ChunkKind::kComma) && IsSense(at - 2, Sense::kAnd);
  const bool preposition = at > 0 && at - 1 == sentence_start_ &&
                           (IsSense(at - 1, Sense::kIn) || IsSense(at - 1, Sense::kTo));
  // "..., and behind the town, on the right, begin the fields"
  const bool placed = at > 0 && IsSense(at - 1, Sense::kAnd) && IsKind(next, ChunkKind::kComma) &&
                      (IsKind(next + 1, ChunkKind::kPlace) ||
                       (IsSense(next + 1, Sense::kIn) && IsKind(next + 2, ChunkKind::kPlace)));
  return ThingFollows(next, at == sentence_start_ || aside || preposition || placed);
}

// How many things stand in the list that begins at `at`; 1: no list.
std::size_t ClauseReader::ListLength(std::size_t at) const {
  std::size_t length = 0;
  const std::size_t limit = std::min(chunks_.size(), at + kMaxListLookAhead);
  while (at < limit && IsThing(at)) {
    ++length;
    ++at;
    const bool comma = IsKind(at, ChunkKind::kComma);
    if (comma) ++at;
    const bool joined = IsSense(at, Sense::kAnd) || IsSense(at, Sense::kOr);
    if (joined) ++at;
    if (!comma && !joined) break;
  }
  return length;
}

// Words that say how much there is of the thing: it is no more of what is denied.
bool ClauseReader::IsSaidAnew(std::size_t at) const {
  if (!IsThing(at)) return false;
  const NounPhrase& phrase = chunks_[at].phrase;
  const Qualities& said = phrase.qualities;
  if (phrase.indefinite || said.count.has_value() || said.share.has_value() || said.much ||
      said.few || said.little || said.group) {
    return true;
  }
  const std::string words = ToLowerAscii(d_.Words(chunks_[at].begin, chunks_[at].end));
  for (const std::string_view word : {"some ", "lots ", "plenty ", "enough ", "just "}) {
    if (words.substr(0, word.size()) == word) return true;
  }
  return false;
}

// A list of things with "and" in it, none with a place or a verb of its own.
bool ClauseReader::IsBareList(std::size_t at) const {
  const std::size_t limit = std::min(chunks_.size(), at + kMaxListLookAhead);
  while (at < limit && IsThing(at)) {
    ++at;
    if (EndsAt(at)) return true;
    if (IsKind(at, ChunkKind::kComma)) {
      ++at;
      if (IsSense(at, Sense::kAnd)) ++at;
      continue;
    }
    if (IsSense(at, Sense::kAnd) || IsSense(at, Sense::kOr)) {
      ++at;
      if (IsThing(at) && (EndsAt(at + 1) || IsKind(at + 1, ChunkKind::kComma))) return true;
      continue;
    }
    return false;
  }
  return false;
}

int ClauseReader::LineOf(const std::vector<int>& indices) const {
  for (std::size_t i = indices.size(); i-- > 0;) {
    if (IsLine(indices[i])) return indices[i];
  }
  return -1;
}

}  // namespace latticeworld
