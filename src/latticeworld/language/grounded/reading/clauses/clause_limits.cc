#include <algorithm>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

// How far what is said goes: "only", "nothing else", "mostly", "entirely", "half each".
namespace latticeworld {

// "nothing but trees", "forest and nothing else"
void ClauseReader::ReadNothingElse() {
  only_next_ = ThingFollows(at_ + 1, false) || IsThing(at_ + 1);
  if (IsKind(at_ + 1, ChunkKind::kPlace) || IsSense(at_ + 1, Sense::kIn)) {
    confining_ = true;
  } else if (at_ > 0 && IsKind(at_ - 1, ChunkKind::kPlace)) {
    for (const int index : subjects_) d_.feature(index).confined = true;
  } else if (!only_next_ && !subjects_.empty() &&
             (EndsAt(at_ + 1) || IsKind(at_ + 1, ChunkKind::kComma))) {
    for (const int index : subjects_) {
      if (!IsLine(index)) d_.feature(index).dominant = true;
    }
  }
}

// "that's all", "no other"
void ClauseReader::ReadNoOther(const Chunk& chunk) {
  const std::string said = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
  if (IsThing(at_ + 1) && EndsWithWord(said, "all")) return;  // "that's all fields"
  if (IsThing(at_ + 1)) {
    skip_next_ = true;
  } else {
    d_.AllIsSaid();
  }
}

// "only in the north"
void ClauseReader::ReadOnly(const Chunk& chunk) {
  confining_ = true;
  // "houses only along the road"
  if (EndsWithWord(ToLowerAscii(d_.Words(chunk.begin, chunk.end)), "along") && IsPhrase(at_ + 1)) {
    confining_ = false;
    OpenSense(Sense::kAlong, false);
  }
}

// "mostly forest", "forest mostly"
void ClauseReader::ReadMostly() {
  if (!subjects_.empty() && !verb_said_ &&
      (EndsAt(at_ + 1) || IsKind(at_ + 1, ChunkKind::kComma))) {
    for (const int index : subjects_) d_.feature(index).dominant = true;
  } else {
    mostly_next_ = true;
  }
}

// "everywhere", "entirely"
void ClauseReader::ReadEntirely() {
  if (subjects_.empty() || ThingFollows(at_ + 1, false)) {
    mostly_next_ = true;
    return;
  }
  for (const int index : subjects_) {
    PlannedFeature& feature = d_.feature(index);
    // "houses everywhere in the south"
    const bool town = feature.letter == 'B' && feature.form == FeatureForm::kPatch &&
                      d_.plan().vocabulary == Vocabulary::kSuburb && feature.pieces_least == 0 &&
                      IsSense(at_ + 1, Sense::kIn) && IsKind(at_ + 2, ChunkKind::kPlace);
    if (town) {
      feature.form = FeatureForm::kSpread;
      feature.pieces = 0;
    }
    if (feature.form == FeatureForm::kSpread && feature.texture == Texture::kUnsaid) {
      feature.dominant = true;
    } else if (feature.form == FeatureForm::kPatch) {
      feature.texture = Texture::kScattered;
    }
  }
}

// How many things of the list that follows share alike.
// "... of forest and fields, and a village where they meet": not the village.
std::size_t ClauseReader::AlikeAhead() const {
  const std::size_t listed = ListLength(at_ + 1);
  std::size_t alike = 0;
  for (std::size_t i = at_ + 1, seen = 0; seen < listed && i < chunks_.size(); ++i) {
    if (!IsThing(i)) continue;
    ++seen;
    if (seen > 2 && chunks_[i].phrase.indefinite) break;
    ++alike;
  }
  return alike;
}

// "half each": the things that follow, or were named, share it evenly.
void ClauseReader::ReadHalfEach() {
  const std::size_t count = std::max<std::size_t>(AlikeAhead(), 2);
  // "the rest is split evenly between fields and woods": how much that is nobody says.
  bool of_rest = false;
  for (std::size_t i = sentence_start_; i < at_; ++i) {
    of_rest = of_rest || (IsPhrase(i) && chunks_[i].phrase.head == Head::kRest);
  }
  const bool shared =
      std::any_of(d_.plan().features.begin(), d_.plan().features.end(),
                  [](const PlannedFeature& feature) { return feature.share.has_value(); });
  if (of_rest && !shared) return;
  if (subjects_.size() >= 2) {
    for (const int index : subjects_) {
      const double share = 1.0 / static_cast<double>(subjects_.size());
      d_.feature(index).share = share;
      d_.feature(index).share_least = share - 0.1;
      d_.feature(index).share_most = share + 0.1;
    }
  } else if (IsThing(at_ + 1)) {
    double left = 1.0;
    for (const PlannedFeature& feature : d_.plan().features) {
      left -= feature.share.value_or(0.0);
    }
    ShareMatch share;
    share.value = std::max(0.05, left / static_cast<double>(count));
    share.least = share.value - 0.1;
    share.most = share.value + 0.1;
    share.fraction = true;
    map_share_ = share;
    share_of_map_ = true;
    sharing_ = count;
  }
}

}  // namespace latticeworld
