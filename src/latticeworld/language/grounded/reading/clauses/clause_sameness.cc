#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Whether words speak of what is known or of something else, and what comes along with a thing.
namespace latticeworld {

// "one in the north", "the other", "the southern one": one of several, or one more of a kind.
std::vector<int> ClauseReader::ReferToOne(const Chunk& chunk, const std::vector<int>& about) {
  const NounPhrase& phrase = chunk.phrase;
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  if (EndsWithWord(words, "second") && split_ >= 0 && d_.feature(split_).pieces > 1) {
    return {d_.SplitOff(split_)};
  }
  if (EndsWithWord(words, "second")) {
    if (const int nth = NthOfThese(1); nth >= 0) return {nth};
  }
  // "highways cross in the middle (one N-S, one E-W)"
  if (phrase.head == Head::kOne &&
      (phrase.qualities.axis.has_value() || IsKind(at_ + 1, ChunkKind::kAxis))) {
    if (const std::vector<int> line = OneLine(chunk); !line.empty()) return line;
  }
  // "On the left is the old town, on the right the new one": another.
  const int model_one = d_.LastMentioned();
  const bool elsewhere =
      phrase.head == Head::kOne && phrase.definite && phrase.places.empty() && !lead_.empty() &&
      !lead_.used && model_one >= 0 && !frame_.has_value() && d_.feature(model_one).pieces <= 1 &&
      d_.feature(model_one).zones.size() == 1 && d_.thing(model_one).sentence == d_.sentence() &&
      RegionOf(d_.feature(model_one).zones.front()) != RegionOf(lead_.zones.front());
  if (elsewhere) return OneMore(chunk);
  // "a copse in the west and a bigger one in the east"
  if (phrase.head == Head::kOne && phrase.indefinite) return OneMore(chunk);
  const int model = OneOfSeveral();
  if (!phrase.places.empty() && model >= 0) {
    // "the northern lake and the southern one"
    NounPhrase like = phrase;
    like.head = Head::kThing;
    like.noun = d_.thing(model).noun;
    const std::vector<int> known = d_.Find(like, about);
    if (!known.empty()) return known;
    if (const int sibling = Unplaced(model); sibling >= 0) {
      if (!IsLine(sibling)) d_.AddZones(sibling, ZonesOf(phrase.places));
      return {sibling};
    }
    const int created = d_.Create(like, chunk.begin, chunk.end);
    return created < 0 ? std::vector<int>() : std::vector<int>{created};
  }
  // "a road from one to the other"
  const bool to_other = phrase.head == Head::kOne && frame_.has_value() &&
                        frame_->sense == Sense::kFrom && IsSense(at_ + 1, Sense::kTo);
  if (to_other) {
    const std::vector<int> ends = d_.LastTwo(about);
    if (ends.size() == 2) {
      split_ = ends[1];
      return {ends[0]};
    }
  }
  // "Ten houses. Two ponds, one north and one south": the second is no house.
  const int part = d_.size() - 1;
  if (phrase.head == Head::kOne && split_ >= 0 && d_.feature(split_).pieces == 1 &&
      !d_.thing(split_).dropped && part != split_ && d_.thing(part).noun == d_.thing(split_).noun &&
      d_.thing(part).sentence == d_.sentence()) {
    return {std::exchange(split_, -1)};
  }
  for (int i = d_.size() - 1; i >= 0 && i >= d_.size() - 8; --i) {
    if (d_.thing(i).dropped) continue;
    const bool several = d_.feature(i).pieces > 1;
    if (phrase.head == Head::kOne && several) {
      // "four huts, one in each corner", "one on each side of the road"
      if (IsEach(at_ + 1) || IsSense(at_ + 1, Sense::kBothSides)) return {i};
      split_ = i;
      return {d_.SplitOff(i)};
    }
  }
  if (split_ >= 0) return {std::exchange(split_, -1)};
  if ((phrase.head == Head::kOne || first_ < 0) && OneAgain()) return OneMore(chunk);
  // "close to one of them": whichever.
  if (EndsWithWord(words, "them") || EndsWithWord(words, "these")) {
    const std::vector<int> many = d_.Antecedent(about, /*many=*/true);
    if (many.size() >= 2) return {many.back()};
    const int line = d_.LastMentioned();
    if (line >= 0 && frame_.has_value()) return Likes(line, about);
  }
  // "The first lake is round, the second is long": there are two of them.
  if (phrase.head == Head::kOther && first_ >= 0 && first_ < d_.size()) {
    NounPhrase like;
    like.noun = d_.thing(first_).noun;
    const int model_of_it = std::exchange(first_, -1);
    const int created = d_.Create(like, chunk.begin, chunk.end);
    if (created >= 0 && model_of_it == fork_) BranchOff(created, fork_);
    return created < 0 ? std::vector<int>() : std::vector<int>{created};
  }
  // The one that no clause since has told of.
  std::vector<int> two = d_.LastTwo({});
  for (const int index : two) {
    if (std::find(about.begin(), about.end(), index) == about.end() &&
        d_.feature(index).zones.empty()) {
      return {index};
    }
  }
  const std::vector<int> before = d_.Antecedent(about, false);
  return before;
}

// "A river. North of it lies a forest. South of it lie fields.": of the river both times; -1: not
// so.
int ClauseReader::SameObject() const {
  if (!frame_.has_value() || !frame_->fronted || d_.plan().relations.empty()) return -1;
  const PlannedRelation& last = d_.plan().relations.back();
  Heading heading = frame_->heading;
  if (frame_->sense == Sense::kAbove || frame_->sense == Sense::kBehind) heading = {0, -1};
  if (frame_->sense == Sense::kBelow || frame_->sense == Sense::kInFront) heading = {0, 1};
  const bool opposite = last.kind == RelationKind::kDirection &&
                        (heading.east != 0 || heading.south != 0) &&
                        last.heading.east == -heading.east && last.heading.south == -heading.south;
  return opposite ? last.object : -1;
}

// "... a village by a lake. Just one village, please.": no other one.
bool ClauseReader::CountsAgain(const Chunk& chunk, int known) const {
  const NounPhrase& phrase = chunk.phrase;
  if (!phrase.qualities.count.has_value() || phrase.another || !phrase.places.empty() ||
      d_.feature(known).pieces_least > 0 || d_.thing(known).sentence == d_.sentence() ||
      !(d_.thing(known).noun == phrase.noun ||
        EndsWithWord(d_.thing(known).noun->phrase, phrase.noun->phrase))) {
    return false;
  }
  const bool alone = at_ == sentence_start_ || (at_ == sentence_start_ + 1 && subjects_.empty());
  return alone && (EndsAt(at_ + 1) || (IsKind(at_ + 1, ChunkKind::kComma) && EndsAt(at_ + 2)));
}

// "On the left are the fields of corn, on the right the fields of wheat": not the same fields.
bool ClauseReader::IsElsewhere(const NounPhrase& phrase, int known) const {
  const PlannedFeature& feature = d_.feature(known);
  if (phrase.head != Head::kThing || IsLine(known) || lead_.empty() || lead_.used ||
      (frame_.has_value() && frame_->expecting) || feature.zones.empty() ||
      d_.thing(known).sentence != d_.sentence()) {
    return false;
  }
  return std::none_of(feature.zones.begin(), feature.zones.end(), [&](const Zone& zone) {
    return RegionOf(zone) == RegionOf(lead_.zones.front());
  });
}

// "two lakes at least five cells apart", "the villages are far from each other"
void ClauseReader::KeepApart() {
  constexpr double kApartSteps = 3.0;
  const double steps = gap_ > 0 ? gap_ : kApartSteps;
  gap_ = 0;
  // "the houses do not touch each other": they may stand close.
  const bool touch = at_ < chunks_.size() &&
                     ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[at_].end)).find("touch") !=
                         std::string::npos;
  const std::vector<int> about = subjects_.empty() ? d_.Antecedent({}, /*many=*/true) : subjects_;
  for (const int index : about) {
    // "two woods"
    const bool several = d_.thing(index).plural || d_.feature(index).pieces > 1;
    if (!several) continue;
    d_.feature(index).gap = steps;
    // "houses, well apart": here and there.
    const bool counted = d_.feature(index).pieces > 0 || d_.feature(index).pieces_least > 0;
    if (!counted && !IsLine(index) && !touch) d_.feature(index).texture = Texture::kScattered;
  }
}

// Land that lies in water; in the lake that was spoken of.
void ClauseReader::Island(int index) {
  for (int i = index - 1; i >= 0; --i) {
    if (d_.feature(i).letter != 'W' || d_.thing(i).dropped || IsLine(i)) continue;
    PlannedRelation relation;
    relation.kind = RelationKind::kWithin;
    relation.subject = index;
    relation.object = i;
    d_.Relate(std::move(relation));
    return;
  }
}

// "a riverside village": by the river that was spoken of, or one of its own.
void ClauseReader::Beside(int index, Sense beside) {
  const char letter = beside == Sense::kRoadside ? 'R' : 'W';
  if (beside == Sense::kRoadside && d_.plan().vocabulary == Vocabulary::kWild) return;
  const FeatureForm form = beside == Sense::kLakeside ? FeatureForm::kPatch : FeatureForm::kLine;
  int other = d_.Latest(letter, form);
  if (other < 0 && letter == 'W') other = d_.Latest(letter, FeatureForm::kSpread);
  if (other < 0) {
    const std::vector<Token> words = Tokenize(beside == Sense::kLakeside    ? "lake"
                                              : beside == Sense::kRiverside ? "river"
                                                                            : "road");
    NounPhrase phrase;
    phrase.noun = MatchClassWord(words, 0).word;
    if (phrase.noun == nullptr) return;
    other = d_.Create(phrase, d_.thing(index).begin, d_.thing(index).end);
  }
  if (other < 0) return;
  PlannedRelation relation;
  relation.kind = RelationKind::kAdjacent;
  relation.subject = index;
  relation.object = other;
  relation.steps = 2.0;
  d_.Relate(std::move(relation));
}

}  // namespace latticeworld
