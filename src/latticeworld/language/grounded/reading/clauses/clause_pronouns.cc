#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// Which things are meant by words that name none: "it", "they", "both", "the former", "the other".
namespace latticeworld {

std::vector<int> ClauseReader::ReferByPronoun(const Chunk& chunk, const std::vector<int>& about) {
  switch (chunk.phrase.head) {
    case Head::kIt:
      return ReferToIt(chunk, about);
    case Head::kThey:
      return ReferToThem(chunk.phrase, about);
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
      return {chunk.phrase.head == Head::kFormer ? two[0] : two[1]};
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

std::vector<int> ClauseReader::ReferToIt(const Chunk& chunk, const std::vector<int>& about) {
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

std::vector<int> ClauseReader::ReferToThem(const NounPhrase& phrase,
                                           const std::vector<int>& about) {
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
    const bool alike = many.size() == 2 && d_.feature(many[0]).letter == d_.feature(one).letter;
    for (int i = one - 1; i >= 0 && !alike; --i) {
      const bool fellow = !d_.thing(i).dropped && d_.feature(one).form == FeatureForm::kPatch &&
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

// "one in the north", "the other", "the southern one": one of several, or one more of a kind.
std::vector<int> ClauseReader::ReferToOne(const Chunk& chunk, const std::vector<int>& about) {
  const NounPhrase& phrase = chunk.phrase;
  const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  if (EndsWithWord(words, "second")) {
    if (split_ >= 0 && d_.feature(split_).pieces > 1) return {d_.SplitOff(split_)};
    if (const int nth = NthOfThese(1); nth >= 0) return {nth};
  }
  // "highways cross in the middle (one N-S, one E-W)"
  if (phrase.head == Head::kOne &&
      (phrase.qualities.axis.has_value() || IsKind(at_ + 1, ChunkKind::kAxis))) {
    if (const std::vector<int> line = OneLine(chunk); !line.empty()) return line;
  }
  if (IsOneElsewhere(phrase)) return OneMore(chunk);
  // "a copse in the west and a bigger one in the east"
  if (phrase.head == Head::kOne && phrase.indefinite) return OneMore(chunk);
  const int model = OneOfSeveral();
  if (!phrase.places.empty() && model >= 0) return OneByPlace(chunk, about, model);
  if (const int part = OneOfParts(phrase, about); part >= 0) return {part};
  if ((phrase.head == Head::kOne || first_ < 0) && OneAgain()) return OneMore(chunk);
  // "close to one of them": whichever.
  if (EndsWithWord(words, "them") || EndsWithWord(words, "these")) {
    const std::vector<int> many = d_.Antecedent(about, /*many=*/true);
    if (many.size() >= 2) return {many.back()};
    const int line = d_.LastMentioned();
    if (line >= 0 && frame_.has_value()) return Likes(line, about);
  }
  if (phrase.head == Head::kOther && first_ >= 0 && first_ < d_.size()) return BesideFirst(chunk);
  // The one that no clause since has told of.
  std::vector<int> two = d_.LastTwo({});
  for (const int index : two) {
    if (std::find(about.begin(), about.end(), index) == about.end() &&
        d_.feature(index).zones.empty()) {
      return {index};
    }
  }
  return d_.Antecedent(about, false);
}

// "On the left is the old town, on the right the new one": another.
bool ClauseReader::IsOneElsewhere(const NounPhrase& phrase) const {
  const int model = d_.LastMentioned();
  return phrase.head == Head::kOne && phrase.definite && phrase.places.empty() && !lead_.empty() &&
         !lead_.used && model >= 0 && !frame_.has_value() && d_.feature(model).pieces <= 1 &&
         d_.feature(model).zones.size() == 1 && d_.thing(model).sentence == d_.sentence() &&
         RegionOf(d_.feature(model).zones.front()) != RegionOf(lead_.zones.front());
}

// "the northern lake and the southern one": of the kind of the model, where it is said.
std::vector<int> ClauseReader::OneByPlace(const Chunk& chunk, const std::vector<int>& about,
                                          int model) {
  NounPhrase like = chunk.phrase;
  like.head = Head::kThing;
  like.noun = d_.thing(model).noun;
  const std::vector<int> known = d_.Find(like, about);
  if (!known.empty()) return known;
  if (const int sibling = Unplaced(model); sibling >= 0) {
    if (!IsLine(sibling)) d_.AddZones(sibling, ZonesOf(chunk.phrase.places));
    return {sibling};
  }
  const int created = d_.Create(like, chunk.begin, chunk.end);
  return created < 0 ? std::vector<int>() : std::vector<int>{created};
}

// One of what was named together, or what is left of it; -1: nothing was.
int ClauseReader::OneOfParts(const NounPhrase& phrase, const std::vector<int>& about) {
  // "a road from one to the other"
  const bool to_other = phrase.head == Head::kOne && frame_.has_value() &&
                        frame_->sense == Sense::kFrom && IsSense(at_ + 1, Sense::kTo);
  if (to_other) {
    const std::vector<int> ends = d_.LastTwo(about);
    if (ends.size() == 2) {
      split_ = ends[1];
      return ends[0];
    }
  }
  // "Ten houses. Two ponds, one north and one south": the second is no house.
  const int part = d_.size() - 1;
  if (phrase.head == Head::kOne && split_ >= 0 && d_.feature(split_).pieces == 1 &&
      !d_.thing(split_).dropped && part != split_ && d_.thing(part).noun == d_.thing(split_).noun &&
      d_.thing(part).sentence == d_.sentence()) {
    return std::exchange(split_, -1);
  }
  for (int i = d_.size() - 1; i >= 0 && i >= d_.size() - 8; --i) {
    if (d_.thing(i).dropped) continue;
    const bool several = d_.feature(i).pieces > 1;
    if (phrase.head == Head::kOne && several) {
      // "four huts, one in each corner", "one on each side of the road"
      if (IsEach(at_ + 1) || IsSense(at_ + 1, Sense::kBothSides)) return i;
      split_ = i;
      return d_.SplitOff(i);
    }
  }
  return std::exchange(split_, -1);
}

// "The first lake is round, the second is long": there are two of them.
std::vector<int> ClauseReader::BesideFirst(const Chunk& chunk) {
  NounPhrase like;
  like.noun = d_.thing(first_).noun;
  const int model = std::exchange(first_, -1);
  const int created = d_.Create(like, chunk.begin, chunk.end);
  if (created >= 0 && model == fork_) BranchOff(created, fork_);
  return created < 0 ? std::vector<int>() : std::vector<int>{created};
}

}  // namespace latticeworld
