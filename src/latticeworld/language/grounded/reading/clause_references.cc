#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

namespace latticeworld {
std::vector<int> ClauseReader::Refer(const Chunk& chunk) {
  const NounPhrase& phrase = chunk.phrase;
  std::vector<int> about = subjects_;
  if (frame_.has_value()) {
    about.insert(about.end(), frame_->subjects.begin(), frame_->subjects.end());
  }
  if (phrase.noun == nullptr) {
    switch (phrase.head) {
      case Head::kIt: {
        if (const int same = SameObject(); same >= 0) return {same};
        const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
        // "Three ponds, all but one in the north; that one is in the south"
        if (words == "that one" && split_ >= 0) return {std::exchange(split_, -1)};
        // "Trees along it, and no house near it": the same both times.
        const bool again = it_ >= 0 && it_sentence_ == d_.sentence() && !d_.thing(it_).dropped &&
                           frame_.has_value() && frame_->expecting &&
                           std::find(about.begin(), about.end(), it_) == about.end() && IsLine(it_);
        if (again) return {it_};
        const std::vector<int> found = d_.Antecedent(about, /*many=*/false);
        if (found.size() == 1) {
          it_ = found[0];
          it_sentence_ = d_.sentence();
        }
        // "a bridge crosses it": a line.
        if (frame_.has_value() && frame_->sense == Sense::kCrosses && LineOf(about) >= 0 &&
            LineOf(found) < 0) {
          for (int i = d_.size() - 1; i >= 0; --i) {
            const bool other = IsLine(i) && !d_.thing(i).dropped &&
                               d_.feature(i).letter != d_.feature(LineOf(about)).letter;
            if (other) return {i};
          }
        }
        return frame_.has_value() ? InContrast(*frame_, found) : found;
      }
      case Head::kThey: {
        const std::vector<int> many = d_.Antecedent(about, /*many=*/true);
        // "Fields in the east, woods in the west; a brook separates them."
        const bool two = frame_.has_value() && frame_->expecting && WantsTwo(frame_->sense);
        const bool single = many.size() == 1 && d_.feature(many[0]).pieces_most <= 1;
        if (two && single) {
          const std::vector<int> last = d_.LastTwo(about);
          if (last.size() == 2 && last[1] != many[0]) return last;
        }
        return many;
      }
      case Head::kBoth: {
        const std::vector<int> many = d_.Antecedent(about, /*many=*/true);
        return many.size() >= 2 ? many : d_.LastTwo(about);
      }
      case Head::kFormer:
      case Head::kLatter: {
        std::vector<int> two = d_.LastTwo({});
        if (two.size() < 2) return two;
        // "The former is in the east, the latter in the west": the order of being introduced.
        std::sort(two.begin(), two.end());
        return {phrase.head == Head::kFormer ? two[0] : two[1]};
      }
      case Head::kFirst: {
        if (const int part = NextPart(); part >= 0) return {part};
        if (const int nth = NthOfThese(0); nth >= 0) return {nth};
        const std::vector<int> two = d_.LastTwo({});
        return two.empty() ? two : std::vector<int>{two[0]};
      }
      case Head::kThird: {
        if (split_ >= 0) return {std::exchange(split_, -1)};
        const int nth = NthOfThese(2);
        return nth < 0 ? std::vector<int>() : std::vector<int>{nth};
      }
      case Head::kAnother:
        return OneMore(chunk);
      case Head::kOne:
      case Head::kOther: {
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
            phrase.head == Head::kOne && phrase.definite && phrase.places.empty() &&
            !lead_.empty() && !lead_.used && model_one >= 0 && !frame_.has_value() &&
            d_.feature(model_one).pieces <= 1 && d_.feature(model_one).zones.size() == 1 &&
            d_.thing(model_one).sentence == d_.sentence() &&
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
      case Head::kShore: {
        for (int i = d_.size() - 1; i >= 0; --i) {
          if (d_.feature(i).letter == 'W' && !d_.thing(i).dropped) return {i};
        }
        return {};
      }
      default:
        return {};
    }
  }
  if (const std::vector<int> arm = Arm(chunk); !arm.empty()) return arm;
  if (const std::vector<int> island = IslandOf(phrase); !island.empty()) return island;
  // "two islands, both wooded"
  const int lately = d_.LastMentioned();
  const char clothed = phrase.noun->LetterIn(d_.plan().vocabulary);
  if ((phrase.head == Head::kBoth || phrase.each) && lately >= 0 && d_.thing(lately).is_island &&
      !d_.thing(lately).dropped && phrase.noun->shape == WordShape::kMass && clothed != '\0' &&
      clothed != 'W' && !phrase.qualities.count.has_value()) {
    d_.feature(lately).letter = clothed;
    return {lately};
  }
  const bool counted = phrase.qualities.count.has_value();
  // "rocks: three separate fields", in the wild: fields of rock.
  if (counted && !phrase.noun->IsExactIn(d_.plan().vocabulary) && LastSubject() >= 0 && at_ > 0 &&
      IsKind(at_ - 1, ChunkKind::kComma) && d_.instruction()[chunks_[at_ - 1].begin] == ':' &&
      !IsLine(LastSubject())) {
    const int measured = LastSubject();
    d_.Describe(phrase.qualities, measured);
    return {measured};
  }
  const bool single =
      counted && phrase.qualities.count->least == 1 && phrase.qualities.count->most == 1;
  const std::vector<int> known = d_.Find(phrase, about);
  const bool points_back = phrase.definite || phrase.head == Head::kBoth ||
                           phrase.head == Head::kFirst || phrase.head == Head::kOther;
  if (!known.empty() && !phrase.another && !rest_next_) {
    const int last = known.back();
    // "Two roads meet. One road runs ..., the other ..."
    if (single && d_.feature(last).pieces > 1 && !phrase.indefinite) {
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
    // "that is the only road": the one there is.
    const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
    const bool sole = words.find("only ") != std::string::npos ||
                      (phrase.definite && words.find("the one ") != std::string::npos);
    // "parallel tracks: three straight roads"
    const bool explained = counted && IsLine(last) && d_.feature(last).pieces_least == 0 &&
                           d_.thing(last).plural && at_ > 0 && IsKind(at_ - 1, ChunkKind::kComma) &&
                           d_.instruction()[chunks_[at_ - 1].begin] == ':' &&
                           d_.thing(last).sentence == d_.sentence() && phrase.plural;
    if (explained) {
      d_.Describe(phrase.qualities, last);
      return {last};
    }
    if (single && known.size() == 1 && sole && phrase.places.empty() &&
        d_.feature(last).pieces_least == 0) {
      d_.Describe(phrase.qualities, last);
      return {last};
    }
    // "six separate woods, total tree cover below 30 %": of all that there is of it.
    if (words.substr(0, 6) == "total ") {
      d_.Describe(phrase.qualities, last);
      return {last};
    }
    if (phrase.head == Head::kOther && split_ >= 0) return {std::exchange(split_, -1)};
    // "Two huts. The first hut is in the north, the second one ..."
    if (phrase.head == Head::kFirst && known.size() == 1 && d_.feature(last).pieces > 1) {
      split_ = last;
      return {d_.SplitOff(last)};
    }
    if (known.size() == 1 && CountsAgain(chunk, last)) {
      d_.Describe(phrase.qualities, last);
      d_.Mention(last);
      return {last};
    }
    // "a track branches off the main road": not the track itself.
    const bool itself = frame_.has_value() && frame_->expecting && known.size() == 1 &&
                        IsLine(last) && frame_->subjects == known &&
                        d_.thing(last).noun != phrase.noun;
    if (points_back && !(counted && single) && !IsElsewhere(phrase, last) && !itself) {
      if (!chunk.phrase.qualities.count.has_value()) {
        for (const int index : known) d_.Describe(phrase.qualities, index);
      }
      for (const int index : known) d_.Mention(index);
      return known;
    }
    // "surrounded by grass" of what the map is made of anyway.
    const bool bare =
        !phrase.indefinite && !counted && !phrase.qualities.any && phrase.places.empty();
    const bool ground = d_.feature(last).dominant || d_.feature(last).fills_rest;
    const bool as_object = frame_.has_value() && frame_->expecting;
    const bool same_name = d_.thing(last).noun == phrase.noun ||
                           EndsWithWord(d_.thing(last).noun->phrase, phrase.noun->phrase);
    const bool general = phrase.noun->phrase == "water" && !IsLine(last);
    if (bare && as_object && (ground || same_name || general)) return {last};
    // "3 ponds top, road from village to top pond"
    const bool told = !phrase.indefinite && !counted && !phrase.qualities.any;
    if (told && as_object && same_name && !phrase.places.empty()) return {last};
    // "Forest in the west. ... Forest also ...", "1 pond, pond not at the edge": the same word
    // without an article takes up what was said before.
    const bool settlement = at_ == sentence_start_ && phrase.noun->phrase == "building" &&
                            !phrase.plural && d_.feature(last).letter == 'B';
    const bool bare_name = !phrase.indefinite && !counted && phrase.places.empty() &&
                           (same_name || settlement) && lead_.empty() && !ordering_;
    const bool same_share = !phrase.qualities.share.has_value() ||
                            (d_.feature(last).share.has_value() &&
                             *d_.feature(last).share == phrase.qualities.share->value);
    const bool spread = phrase.noun->shape == WordShape::kMass;
    const bool same_map_share =
        !map_share_.has_value() ||
        (d_.feature(last).share.has_value() && *d_.feature(last).share == map_share_->value);
    // "a stream under the road. Stream north to south, road east to west"
    const bool line_without_course =
        IsLine(last) && !d_.feature(last).from.has_value() && !d_.feature(last).to.has_value() &&
        d_.feature(last).pieces <= 1 && d_.thing(last).sentence != d_.sentence();
    if (bare_name && same_share && same_map_share &&
        (spread || line_without_course || d_.feature(last).zones.empty())) {
      if (!phrase.qualities.share.has_value()) d_.Describe(phrase.qualities, last);
      d_.Mention(last);
      return {last};
    }
    // "a green space (lawn)": the same thing in another word.
    const bool in_brackets = at_ > 0 && IsKind(at_ - 1, ChunkKind::kComma) &&
                             d_.instruction()[chunks_[at_ - 1].begin] == '(' && !counted;
    if (in_brackets && last == LastSubject()) {
      d_.Describe(phrase.qualities, last);
      return {last};
    }
    // "marina: eastern edge, water there"
    const bool general_water = phrase.noun->phrase == "water" && last == d_.LastMentioned() &&
                               !frame_.has_value() && lead_.empty() &&
                               d_.thing(last).sentence == d_.sentence() && !IsLine(last);
    if (general_water && bare) return {last};
    // "forest and lakes. Many lakes."
    if (counted && phrase.plural && !phrase.indefinite && phrase.places.empty() &&
        d_.thing(last).noun == phrase.noun && d_.thing(last).plural &&
        d_.feature(last).pieces_least == 0 && d_.feature(last).zones.empty() && lead_.empty()) {
      d_.Describe(phrase.qualities, last);
      d_.Mention(last);
      return {last};
    }
    // "water: winding brook"
    if (last == LastSubject() && IsKind(at_ - 1, ChunkKind::kComma) && at_ >= 2 &&
        IsThing(at_ - 2) && d_.feature(last).zones.empty()) {
      // "a runway (use road)": the same, said in another way
      if (d_.instruction()[chunks_[at_ - 1].begin] == '(') return {last};
      d_.Drop(last);
      subjects_.clear();
      open_list_ = joining_ = false;
    }
  }
  const int created = d_.Create(phrase, chunk.begin, chunk.end);
  if (created < 0) return {};
  if (phrase.head == Head::kFirst) first_ = created;
  if (d_.thing(created).is_island) Island(created);
  const Sense beside =
      phrase.qualities.beside != Sense::kNone ? phrase.qualities.beside : BesideOf(*phrase.noun);
  if (beside != Sense::kNone && d_.feature(created).letter != 'W') Beside(created, beside);
  return {created};
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
