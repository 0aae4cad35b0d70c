#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

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

}  // namespace

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
        std::vector<int> found = d_.Antecedent(about, /*many=*/false);
        // "... fields south of it. It runs from west to east": what runs.
        if (found.size() == 1 && !IsLine(found[0]) && about.empty() &&
            d_.feature(found[0]).form == FeatureForm::kSpread &&
            (IsSense(at_ + 1, Sense::kRuns) || IsSense(at_ + 1, Sense::kWinds) ||
             IsSense(at_ + 1, Sense::kFrom))) {
          for (int i = d_.size() - 1; i >= 0; --i) {
            if (!IsLine(i) || d_.thing(i).dropped) continue;
            found = {i};
            break;
          }
        }
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
        // "two of them lie in the north"
        if (phrase.qualities.count.has_value()) {
          const int whole = split_ >= 0 ? split_ : d_.LastMentioned();
          if (whole >= 0 && SomeOf(phrase, whole)) {
            split_ = whole;
            return {d_.SplitOff(whole, phrase.qualities.count->least)};
          }
        }
        const std::vector<int> many = d_.Antecedent(about, /*many=*/true);
        // "Fields in the east, woods in the west; a brook separates them."
        const bool two = frame_.has_value() && frame_->expecting && WantsTwo(frame_->sense);
        // "A village north of the lake, another one south of it, and a road connects them."
        if (two && !many.empty() && many.size() <= 2) {
          const int one = many.back();
          const bool alike =
              many.size() == 2 && d_.feature(many[0]).letter == d_.feature(one).letter;
          for (int i = one - 1; i >= 0 && !alike; --i) {
            const bool fellow = !d_.thing(i).dropped &&
                                d_.feature(one).form == FeatureForm::kPatch &&
                                d_.feature(i).form == FeatureForm::kPatch &&
                                d_.feature(i).letter == d_.feature(one).letter;
            if (fellow) return {i, one};
          }
        }
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
      case Head::kOther:
        return ReferToOne(chunk, about);
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
  if (const std::vector<int> member = OfCounted(chunk); !member.empty()) return member;
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
    const bool bounds_share = phrase.qualities.share.has_value() && EndsAt(at_ + 1) &&
                              IsBound(*phrase.qualities.share) && IsBound(d_.feature(last)) &&
                              d_.thing(last).sentence < d_.sentence();
    const bool same_share = !phrase.qualities.share.has_value() || bounds_share ||
                            (d_.feature(last).share.has_value() &&
                             *d_.feature(last).share == phrase.qualities.share->value);
    const bool spread = phrase.noun->shape == WordShape::kMass;
    const bool bounds_map_share = map_share_.has_value() && IsBound(*map_share_) &&
                                  IsBound(d_.feature(last)) &&
                                  d_.thing(last).sentence < d_.sentence();
    const bool same_map_share =
        !map_share_.has_value() || bounds_map_share ||
        (d_.feature(last).share.has_value() && *d_.feature(last).share == map_share_->value);
    // "a stream under the road. Stream north to south, road east to west"
    const bool line_without_course =
        IsLine(last) && !d_.feature(last).from.has_value() && !d_.feature(last).to.has_value() &&
        d_.feature(last).pieces <= 1 && d_.thing(last).sentence != d_.sentence();
    if (bare_name && same_share && same_map_share &&
        (spread || line_without_course || d_.feature(last).zones.empty())) {
      if (!phrase.qualities.share.has_value() || bounds_share) d_.Describe(phrase.qualities, last);
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
  CountExactly(chunk, created);
  if (phrase.head == Head::kFirst) first_ = created;
  if (d_.thing(created).is_island) Island(created);
  const Sense beside =
      phrase.qualities.beside != Sense::kNone ? phrase.qualities.beside : BesideOf(*phrase.noun);
  if (beside != Sense::kNone && d_.feature(created).letter != 'W') Beside(created, beside);
  return {created};
}

}  // namespace latticeworld
