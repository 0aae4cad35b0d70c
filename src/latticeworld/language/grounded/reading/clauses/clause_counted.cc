#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"
#include "latticeworld/language/place_words.h"
#include "latticeworld/language/tokens.h"

// Lists of short sentences: things that were counted or spoken of before, named again.
namespace latticeworld {
namespace {

// "Exactly one lake in the north. A lake in the south.": not the same place. Of several, those in
// the west and in the east may both lie in the middle third.
bool IsOtherPlace(const Zone& known, const Zone& said, bool several) {
  if (known.is_anywhere() || said.is_anywhere()) return false;
  const Heading a = HeadingOf(RegionOf(known));
  const Heading b = HeadingOf(RegionOf(said));
  const bool opposite = a.east * b.east < 0 || a.south * b.south < 0;
  const bool center_a = a.east == 0 && a.south == 0;
  const bool center_b = b.east == 0 && b.south == 0;
  if (opposite || center_a != center_b) return opposite || !several || center_b;
  if (several) return false;
  const auto refines = [](Heading one, Heading other) {
    return (other.east == 0 || one.east == other.east) &&
           (other.south == 0 || one.south == other.south);
  };
  return !refines(a, b) && !refines(b, a);
}

// The last word of a noun in the singular; "house" for all that people live in.
std::string LastWord(std::string_view phrase) {
  const std::string word = Singular(phrase.substr(phrase.rfind(' ') + 1));
  return IsOneOf(word, {"building", "home", "dwelling"}) ? "house" : word;
}

// "group of buildings": several, counted as one.
bool IsGroup(const ClassWord& noun) {
  for (const std::string_view group : {"group of ", "cluster of ", "clump of ", "block of "})
    if (noun.phrase.substr(0, group.size()) == group) return true;
  return false;
}

// "Lake" and "small lake", "market town" and "town", "canal" and "river"; no road is a path.
bool IsSameName(const ClassWord& known, const ClassWord& said) {
  const auto flows = [](const ClassWord& word) {
    return IsOneOf(word.phrase, {"river", "stream", "canal", "brook", "creek", "watercourse",
                                 "waterway", "rivulet"});
  };
  return known.phrase == said.phrase || EndsWithWord(known.phrase, said.phrase) ||
         EndsWithWord(said.phrase, known.phrase) ||
         Singular(known.phrase) == Singular(said.phrase) || (flows(known) && flows(said)) ||
         (IsGroup(known) && LastWord(known.phrase) == LastWord(said.phrase));
}

// "Body of water" and "lake".
bool IsGeneral(const ClassWord& known, const ClassWord& said) {
  return said.shape == WordShape::kThing && said.phrase != "water" &&
         IsOneOf(known.phrase, {"body of water", "water body", "settlement"});
}

// "a small lake": the article may be part of other words.
bool IsIndefinite(const NounPhrase& phrase, std::string_view words) {
  return phrase.indefinite || words.substr(0, 2) == "a " || words.substr(0, 3) == "an ";
}

}  // namespace

// "Exactly two lakes", "only one lake", "two lakes in all": there are no others.
bool ClauseReader::SaysExactly(const Chunk& chunk) const {
  const std::optional<CountMatch>& count = chunk.phrase.qualities.count;
  if (!count.has_value() || count->least != count->most || chunk.phrase.another) return false;
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end)) + " ";
  for (const std::string_view sole : {"exactly ", "precisely ", "only ", "just ", "single "})
    if (words.find(sole) != std::string::npos) return true;
  const std::string after = ToLowerAscii(d_.Words(chunk.end, d_.instruction().size()));
  for (const std::string_view all : {" in all", " in total", " altogether"})
    if (after.substr(0, all.size()) == all) return true;
  return false;
}

// Notes that there are so many of it and no others, if the words say so.
void ClauseReader::CountExactly(const Chunk& chunk, int index) {
  if (!SaysExactly(chunk)) return;
  // "Only one house stands by the lake", "a single road leads west": there may be others elsewhere.
  std::size_t next = at_ + 1;
  if (IsSense(next, Sense::kIn)) ++next;
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  const auto begins = [&](std::string_view with) { return words.substr(0, with.size()) == with; };
  const bool placed = EndsAt(next) || IsKind(next, ChunkKind::kPlace);
  const bool loose = !placed && !IsLine(index) && (begins("only ") || begins("just "));
  if (loose || (!EndsAt(at_ + 1) && (begins("a single ") || begins("single ")))) return;
  const int count = chunk.phrase.qualities.count->least;
  d_.thing(index).counted = d_.thing(index).left = count;
  // "exactly one forest": a piece of it.
  if (count == 1 && d_.feature(index).form == FeatureForm::kSpread)
    d_.feature(index).form = FeatureForm::kPatch;
}

// The places that the words from here to the end of the sentence name.
std::vector<Zone> ClauseReader::PlacesAhead(const Chunk& chunk) const {
  std::vector<Zone> zones = ZonesOf(chunk.phrase.places);
  zones.insert(zones.end(), lead_.zones.begin(), lead_.zones.end());
  for (std::size_t at = at_ + 1; !EndsAt(at); ++at) {
    if (!IsKind(at, ChunkKind::kPlace)) continue;
    const std::vector<Zone> more = ZonesOf(chunks_[at].lexeme.places);
    zones.insert(zones.end(), more.begin(), more.end());
  }
  return zones;
}

// "Exactly one lake in the forest. A lake in the farmland.": not the same.
bool ClauseReader::IsInAnother(int index) const {
  for (std::size_t at = at_ + 1; !EndsAt(at); ++at) {
    if (!(IsSense(at, Sense::kIn) || IsSense(at, Sense::kWithin)) || !IsThing(at + 1)) continue;
    const char there = chunks_[at + 1].phrase.noun->LetterIn(d_.plan().vocabulary);
    for (const PlannedRelation& relation : d_.plan().relations) {
      if (relation.kind == RelationKind::kWithin && relation.subject == index &&
          d_.feature(relation.object).letter != there) {
        return true;
      }
    }
  }
  return false;
}

// "Exactly one road from west to east. A road branches off it to the village.": another way.
bool ClauseReader::RunsElsewhere(int line) const {
  std::size_t last = at_;
  bool ends = false;
  for (; !EndsAt(last + 1); ++last) {
    ends = ends || IsSense(last + 1, Sense::kFrom) || IsSense(last + 1, Sense::kTo) ||
           IsKind(last + 1, ChunkKind::kAxis);
  }
  const std::string words = ToLowerAscii(d_.Words(chunks_[at_].begin, chunks_[last].end));
  for (const std::string_view off : {" branch", " off ", " fork", " splits"})
    if (words.find(off) != std::string::npos) return true;
  return ends && d_.thing(line).counted == 1 && d_.feature(line).from.has_value() &&
         d_.feature(line).to.has_value();
}

// "Exactly one lake. A lake inside the forest.": that one. "Exactly two lakes. A lake in the west.
// A lake in the east.": one of them each time. Empty: none of those that were counted.
std::vector<int> ClauseReader::OfCounted(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  if (phrase.definite || phrase.another || phrase.negated || rest_next_ || correcting_ ||
      phrase.head != Head::kThing || phrase.qualities.share.has_value()) {
    return {};
  }
  const std::optional<CountMatch>& count = phrase.qualities.count;
  if (count.has_value() && count->least != count->most) return {};
  const int pieces = count.has_value() ? count->least : 1;
  int whole = -1;
  for (int i = d_.size() - 1; i >= 0 && whole < 0; --i) {
    if (d_.thing(i).counted == 0 || d_.thing(i).dropped) continue;
    if (d_.thing(i).sentence >= d_.sentence()) continue;
    if (d_.feature(i).letter != phrase.noun->LetterIn(d_.plan().vocabulary)) continue;
    if (IsSameName(*d_.thing(i).noun, *phrase.noun) || IsGeneral(*d_.thing(i).noun, *phrase.noun)) {
      whole = i;
    }
  }
  if (whole < 0) return {};
  const bool several = d_.thing(whole).counted > 1;
  // "Exactly one group of buildings. Buildings in the west."
  const bool group = IsGroup(*d_.thing(whole).noun);
  if (group && phrase.noun != d_.thing(whole).noun &&
      (!phrase.plural || (several && !phrase.qualities.group))) {
    return {};
  }
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  if (!count.has_value() && !IsIndefinite(phrase, words) && !group) return {};
  if (!IsLine(whole) && IsInAnother(whole)) return {};
  if (IsLine(whole) && RunsElsewhere(whole)) return {};
  const std::vector<Zone> ahead = PlacesAhead(chunk);
  for (const Zone& there : ahead) {
    // What runs leads to many places.
    if (IsLine(whole)) break;
    for (const Zone& known : d_.feature(whole).zones)
      if (IsOtherPlace(known, there, several)) return {};
  }
  // "A pond in each corner"
  const bool each = several && pieces == 1 && !IsLine(whole) &&
                    static_cast<int>(ahead.size()) == d_.thing(whole).counted;
  Qualities said = phrase.qualities;
  said.count.reset();
  int found = whole;
  const bool as_object = frame_.has_value() && frame_->expecting;
  if (several && pieces < d_.thing(whole).counted && !as_object && !each) {
    if (IsEach(at_ + 1) || pieces > d_.thing(whole).left) return {};
    d_.thing(whole).left -= pieces;
    // The last of them is what is left.
    if (d_.feature(whole).pieces > pieces) {
      found = d_.SplitOff(whole, pieces);
      d_.thing(found).counted = 0;
      d_.thing(found).begin = chunk.begin;
      d_.thing(found).end = chunk.end;
      split_ = whole;
    } else {
      split_ = -1;
    }
  } else if (pieces > d_.thing(whole).counted) {
    return {};
  }
  // "Exactly one body of water. A lake ... The lake ..."
  if (IsGeneral(*d_.thing(found).noun, *phrase.noun)) d_.thing(found).noun = phrase.noun;
  d_.Describe(said, found);
  d_.Mention(found);
  return {found};
}

// "A village in the north. A village in the south. Exactly two villages.": these two.
bool ClauseReader::CountsAll(const Chunk& chunk, const std::vector<int>& known) {
  if (!SaysExactly(chunk) || !chunk.phrase.places.empty() || !EndsAt(at_ + 1) ||
      at_ > sentence_start_ + 1 || known.size() < 2 ||
      chunk.phrase.qualities.count->least != static_cast<int>(known.size())) {
    return false;
  }
  for (const int index : known) {
    const bool one = d_.feature(index).pieces <= 1 && d_.feature(index).pieces_most <= 1 &&
                     !d_.thing(index).plural && !d_.feature(index).dominant &&
                     !d_.feature(index).fills_rest && d_.thing(index).sentence < d_.sentence();
    if (!one) return false;
  }
  for (const int index : known) {
    PlannedFeature& feature = d_.feature(index);
    feature.pieces = feature.pieces_least = feature.pieces_most = 1;
    if (feature.form == FeatureForm::kSpread) feature.form = FeatureForm::kPatch;
    d_.Mention(index);
  }
  return true;
}

// "A road runs from the western edge to the eastern edge. A straight road.": that road. -1: a new
// one.
int ClauseReader::ShapedAgain(const Chunk& chunk, const std::vector<int>& known) const {
  const NounPhrase& phrase = chunk.phrase;
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  const bool alone = IsIndefinite(phrase, words) && !phrase.plural && !phrase.another &&
                     !phrase.qualities.count.has_value() && phrase.places.empty() &&
                     at_ == sentence_start_ && EndsAt(at_ + 1);
  const bool shape = phrase.qualities.shape.has_value() || phrase.qualities.axis.has_value();
  if (!alone || !shape || known.size() != 1) return -1;
  const int last = known[0];
  const PlannedFeature& feature = d_.feature(last);
  const bool just_named =
      d_.LastMentioned() == last || d_.thing(last).sentence + 1 == d_.sentence();
  // "Heath. A straight strip of grassland."
  const bool land = feature.form == FeatureForm::kSpread && feature.zones.empty();
  // "A strip of forest ... A straight strip of forest."
  const bool known_shape = feature.shape.has_value() && feature.shape != ClaimShape::kElongated;
  const bool same = just_named && !land && !known_shape && feature.pieces <= 1 &&
                    !d_.thing(last).plural && IsSameName(*d_.thing(last).noun, *phrase.noun);
  return same ? last : -1;
}

// "At least four groves. At most five groves.": both bounds hold.
bool ClauseReader::BoundsAgain(const Chunk& chunk, int known) const {
  const NounPhrase& phrase = chunk.phrase;
  const std::optional<CountMatch>& count = phrase.qualities.count;
  const PlannedFeature& feature = d_.feature(known);
  if (!count.has_value() || phrase.another || !phrase.places.empty() || !EndsAt(at_ + 1) ||
      at_ > sentence_start_ + 1 || feature.pieces_least == 0 ||
      d_.thing(known).sentence == d_.sentence()) {
    return false;
  }
  const bool bounded = count->most != CountMatch::kUnbounded;
  const bool upper = bounded && count->least <= 1 && count->most > 1;
  const bool lower = !bounded && count->least > 1;
  const bool above = feature.pieces_least > 1 && feature.pieces_most == 0;
  const bool below = feature.pieces_least <= 1 && feature.pieces_most > 1;
  return (upper && above && feature.pieces_least <= count->most) ||
         (lower && below && count->least <= feature.pieces_most);
}

// The bounds that were said before, where the words now leave them open.
void ClauseReader::JoinBounds(const Chunk& chunk, int known) {
  PlannedFeature& feature = d_.feature(known);
  CountMatch both = *chunk.phrase.qualities.count;
  if (both.most == CountMatch::kUnbounded) {
    both.most = feature.pieces_most;
  } else {
    both.least = feature.pieces_least;
  }
  Qualities said = chunk.phrase.qualities;
  said.count = both;
  d_.Describe(said, known);
  d_.Mention(known);
}

}  // namespace latticeworld
