#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Whether words speak of what is known or of something else, and what comes along with a thing.
namespace latticeworld {

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
