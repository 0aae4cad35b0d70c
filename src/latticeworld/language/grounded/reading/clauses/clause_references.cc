#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Which things noun phrases mean: what is known already, or something new.
namespace latticeworld {
namespace {

// "at least 10 percent", "at most a fifth"
bool IsBound(const ShareMatch& share) {
  constexpr double kSome = 0.01;
  return share.fraction && (share.least <= kSome) != (share.most >= 1.0);
}

// The same of what was said before.
bool IsBound(const PlannedFeature& feature) {
  ShareMatch share;
  share.fraction = feature.share_least.has_value() && feature.share_most.has_value();
  share.least = feature.share_least.value_or(0.0);
  share.most = feature.share_most.value_or(1.0);
  return IsBound(share);
}

// "one road", "a single lake"
bool IsOne(const NounPhrase& phrase) {
  return phrase.qualities.count.has_value() && phrase.qualities.count->least == 1 &&
         phrase.qualities.count->most == 1;
}

// "the lake", "forest": neither new nor told any closer, but for its place.
bool IsPlain(const NounPhrase& phrase) {
  return !phrase.indefinite && !phrase.qualities.count.has_value() && !phrase.qualities.any;
}

// "the town" of a market town
bool SharesName(const NounPhrase& phrase, const Thing& thing) {
  return thing.noun == phrase.noun || EndsWithWord(thing.noun->phrase, phrase.noun->phrase);
}

}  // namespace

std::vector<int> ClauseReader::Refer(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  std::vector<int> about = subjects_;
  if (frame_.has_value()) {
    about.insert(about.end(), frame_->subjects.begin(), frame_->subjects.end());
  }
  if (phrase.noun == nullptr) return ReferByPronoun(chunk, about);
  if (const std::vector<int> arm = Arm(chunk); !arm.empty()) return arm;
  if (const std::vector<int> island = IslandOf(phrase); !island.empty()) return island;
  if (const int island = ClothedIsland(phrase); island >= 0) return {island};
  if (const int measured = MeasuredAgain(phrase); measured >= 0) return {measured};
  const std::vector<int> known = d_.Find(phrase, about);
  if (const std::vector<int> member = OfCounted(chunk); !member.empty()) return member;
  if (!known.empty() && !phrase.another && !rest_next_) {
    if (const std::vector<int> meant = ReferToKnown(chunk, known); !meant.empty()) return meant;
  }
  return ReferToNew(chunk);
}

std::vector<int> ClauseReader::ReferToNew(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  const int created = d_.Create(phrase, chunk.begin, chunk.end);
  if (created < 0) return {};
  CountExactly(chunk, created);
  if (phrase.head == Head::kFirst) first_ = created;
  if (d_.thing(created).is_island) Island(created);
  const Sense beside =
      phrase.qualities.beside != Sense::kNone ? phrase.qualities.beside : BesideOf(*phrase.noun);
  if (beside != Sense::kNone && d_.feature(created).letter != 'W') Beside(created, beside);
  return {created};
}

// "two islands, both wooded": the islands, which are forest now; -1: not so.
int ClauseReader::ClothedIsland(const NounPhrase& phrase) {
  const int lately = d_.LastMentioned();
  const char clothed = phrase.noun->LetterIn(d_.plan().vocabulary);
  if ((phrase.head == Head::kBoth || phrase.each) && lately >= 0 && d_.thing(lately).is_island &&
      !d_.thing(lately).dropped && phrase.noun->shape == WordShape::kMass && clothed != '\0' &&
      clothed != 'W' && !phrase.qualities.count.has_value()) {
    d_.feature(lately).letter = clothed;
    return lately;
  }
  return -1;
}

// Whether this mark stands right before: "forest: ...", "a lawn (...".
bool ClauseReader::AfterMark(char mark) const {
  return at_ > 0 && IsKind(at_ - 1, ChunkKind::kComma) &&
         d_.instruction()[chunks_[at_ - 1].begin] == mark;
}

// "rocks: three separate fields", in the wild: fields of rock; -1: not so.
int ClauseReader::MeasuredAgain(const NounPhrase& phrase) {
  if (phrase.qualities.count.has_value() && !phrase.noun->IsExactIn(d_.plan().vocabulary) &&
      LastSubject() >= 0 && AfterMark(':') && !IsLine(LastSubject())) {
    const int measured = LastSubject();
    d_.Describe(phrase.qualities, measured);
    return measured;
  }
  return -1;
}

// Those of the known things that are meant; empty: something new is.
std::vector<int> ClauseReader::ReferToKnown(const Chunk& chunk, const std::vector<int>& known) {
  std::vector<int> meant = PartOfKnown(chunk.phrase, known);
  if (meant.empty()) meant = ExplainedAgain(chunk, known);
  if (meant.empty()) meant = NextOfKnown(chunk.phrase, known);
  if (meant.empty()) meant = CountedAgain(chunk, known);
  if (meant.empty()) meant = PointedBackTo(chunk.phrase, known);
  if (meant.empty()) meant = NamedAsObject(chunk.phrase, known);
  if (meant.empty()) meant = NamedBarely(chunk.phrase, known);
  if (meant.empty()) meant = NamedInOtherWords(chunk.phrase, known);
  if (meant.empty()) meant = ReplacedBy(known);
  return meant;
}

// One of several that the words tell apart from the others.
std::vector<int> ClauseReader::PartOfKnown(const NounPhrase& phrase,
                                           const std::vector<int>& known) {
  const int last = known.back();
  // "Two roads meet. One road runs ..., the other ..."
  if (IsOne(phrase) && d_.feature(last).pieces > 1 && !phrase.indefinite) {
    split_ = last;
    return {d_.SplitOff(last)};
  }
  // "two clearings. The larger clearing is in the north."
  const bool compared = phrase.definite && !phrase.plural && phrase.qualities.size != 1.0 &&
                        known.size() == 1 && d_.feature(last).pieces == 2 &&
                        d_.feature(last).pieces_least == 2;
  if (compared) {
    split_ = last;
    const int part = d_.SplitOff(last);
    d_.feature(part).cells =
        std::max(2, static_cast<int>(d_.feature(part).cells * phrase.qualities.size));
    return {part};
  }
  return {};
}

// What was named, told closer.
std::vector<int> ClauseReader::ExplainedAgain(const Chunk& chunk, const std::vector<int>& known) {
  const NounPhrase& phrase = chunk.phrase;
  const int last = known.back();
  // "that is the only road": the one there is.
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  const bool sole = words.find("only ") != std::string::npos ||
                    (phrase.definite && words.find("the one ") != std::string::npos);
  // "parallel tracks: three straight roads"
  const bool explained = phrase.qualities.count.has_value() && IsLine(last) &&
                         d_.feature(last).pieces_least == 0 && d_.thing(last).plural &&
                         AfterMark(':') && d_.thing(last).sentence == d_.sentence() &&
                         phrase.plural;
  const bool only_one = IsOne(phrase) && known.size() == 1 && sole && phrase.places.empty() &&
                        d_.feature(last).pieces_least == 0;
  // "six separate woods, total tree cover below 30 %": of all that there is of it.
  const bool total = words.substr(0, 6) == "total ";
  if (!explained && !only_one && !total) return {};
  d_.Describe(phrase.qualities, last);
  return {last};
}

// "the other hut", "the first hut"
std::vector<int> ClauseReader::NextOfKnown(const NounPhrase& phrase,
                                           const std::vector<int>& known) {
  if (phrase.head == Head::kOther && split_ >= 0) return {std::exchange(split_, -1)};
  // "Two huts. The first hut is in the north, the second one ..."
  const int last = known.back();
  if (phrase.head == Head::kFirst && known.size() == 1 && d_.feature(last).pieces > 1) {
    split_ = last;
    return {d_.SplitOff(last)};
  }
  return {};
}

// Counted, bounded or shaped in a sentence of its own.
std::vector<int> ClauseReader::CountedAgain(const Chunk& chunk, const std::vector<int>& known) {
  const int last = known.back();
  if (known.size() == 1 && CountsAgain(chunk, last)) {
    d_.Describe(chunk.phrase.qualities, last);
    CountExactly(chunk, last);
    d_.Mention(last);
    return {last};
  }
  if (CountsAll(chunk, known)) return known;
  if (known.size() == 1 && BoundsAgain(chunk, last)) {
    JoinBounds(chunk, last);
    return {last};
  }
  if (ShapedAgain(chunk, known) == last) {
    d_.Describe(chunk.phrase.qualities, last);
    d_.Mention(last);
    return {last};
  }
  return {};
}

// "the lake", "both villages": what the article points back to.
std::vector<int> ClauseReader::PointedBackTo(const NounPhrase& phrase,
                                             const std::vector<int>& known) {
  const int last = known.back();
  const bool points_back = phrase.definite || phrase.head == Head::kBoth ||
                           phrase.head == Head::kFirst || phrase.head == Head::kOther;
  // "a track branches off the main road": not the track itself.
  const bool itself = frame_.has_value() && frame_->expecting && known.size() == 1 &&
                      IsLine(last) && frame_->subjects == known &&
                      d_.thing(last).noun != phrase.noun;
  if (!points_back || IsOne(phrase) || IsElsewhere(phrase, last) || itself) return {};
  if (!phrase.qualities.count.has_value()) {
    for (const int index : known) d_.Describe(phrase.qualities, index);
  }
  for (const int index : known) d_.Mention(index);
  return known;
}

// What something is next to, around or by: known, where nothing tells it apart.
std::vector<int> ClauseReader::NamedAsObject(const NounPhrase& phrase,
                                             const std::vector<int>& known) {
  const int last = known.back();
  const bool as_object = frame_.has_value() && frame_->expecting;
  if (!as_object || !IsPlain(phrase)) return {};
  // "surrounded by grass" of what the map is made of anyway.
  const bool ground = d_.feature(last).dominant || d_.feature(last).fills_rest;
  const bool same_name = SharesName(phrase, d_.thing(last));
  const bool general = phrase.noun->phrase == "water" && !IsLine(last);
  if (phrase.places.empty() && (ground || same_name || general)) return {last};
  // "3 ponds top, road from village to top pond"
  if (!phrase.places.empty() && same_name) return {last};
  return {};
}

// "Forest in the west. ... Forest also ...", "1 pond, pond not at the edge": the same word without
// an article takes up what was said before.
std::vector<int> ClauseReader::NamedBarely(const NounPhrase& phrase,
                                           const std::vector<int>& known) {
  const int last = known.back();
  const PlannedFeature& feature = d_.feature(last);
  const bool settlement = at_ == sentence_start_ && phrase.noun->phrase == "building" &&
                          !phrase.plural && feature.letter == 'B';
  const bool bare_name =
      !phrase.indefinite && !phrase.qualities.count.has_value() && phrase.places.empty() &&
      (SharesName(phrase, d_.thing(last)) || settlement) && lead_.empty() && !ordering_;
  if (!bare_name) return {};
  const bool bounded_before = IsBound(feature) && d_.thing(last).sentence < d_.sentence();
  const bool bounds_share = phrase.qualities.share.has_value() && EndsAt(at_ + 1) &&
                            IsBound(*phrase.qualities.share) && bounded_before;
  const bool same_share =
      !phrase.qualities.share.has_value() || bounds_share ||
      (feature.share.has_value() && *feature.share == phrase.qualities.share->value);
  const bool bounds_map_share = map_share_.has_value() && IsBound(*map_share_) && bounded_before;
  const bool same_map_share = !map_share_.has_value() || bounds_map_share ||
                              (feature.share.has_value() && *feature.share == map_share_->value);
  const bool spread = phrase.noun->shape == WordShape::kMass;
  // "a stream under the road. Stream north to south, road east to west"
  const bool line_without_course = IsLine(last) && !feature.from.has_value() &&
                                   !feature.to.has_value() && feature.pieces <= 1 &&
                                   d_.thing(last).sentence != d_.sentence();
  if (!same_share || !same_map_share || !(spread || line_without_course || feature.zones.empty())) {
    return {};
  }
  if (!phrase.qualities.share.has_value() || bounds_share) d_.Describe(phrase.qualities, last);
  d_.Mention(last);
  return {last};
}

// The same thing in another word, or told closer.
std::vector<int> ClauseReader::NamedInOtherWords(const NounPhrase& phrase,
                                                 const std::vector<int>& known) {
  const int last = known.back();
  const bool counted = phrase.qualities.count.has_value();
  // "a green space (lawn)"
  if (AfterMark('(') && !counted && last == LastSubject()) {
    d_.Describe(phrase.qualities, last);
    return {last};
  }
  // "marina: eastern edge, water there"
  const bool general_water = phrase.noun->phrase == "water" && last == d_.LastMentioned() &&
                             !frame_.has_value() && lead_.empty() &&
                             d_.thing(last).sentence == d_.sentence() && !IsLine(last);
  if (general_water && IsPlain(phrase) && phrase.places.empty()) return {last};
  // "forest and lakes. Many lakes."
  if (counted && phrase.plural && !phrase.indefinite && phrase.places.empty() &&
      d_.thing(last).noun == phrase.noun && d_.thing(last).plural &&
      d_.feature(last).pieces_least == 0 && d_.feature(last).zones.empty() && lead_.empty()) {
    d_.Describe(phrase.qualities, last);
    d_.Mention(last);
    return {last};
  }
  return {};
}

// "water: winding brook": the brook stands for the water, which is dropped.
std::vector<int> ClauseReader::ReplacedBy(const std::vector<int>& known) {
  const int last = known.back();
  if (last == LastSubject() && IsKind(at_ - 1, ChunkKind::kComma) && at_ >= 2 && IsThing(at_ - 2) &&
      d_.feature(last).zones.empty()) {
    // "a runway (use road)": the same, said in another way
    if (AfterMark('(')) return {last};
    d_.Drop(last);
    subjects_.clear();
    open_list_ = joining_ = false;
  }
  return {};
}

}  // namespace latticeworld
