#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"
#include "latticeworld/language/grounded/reading/place_phrases.h"

namespace latticeworld {
void ClauseReader::ReadSense(const Chunk& chunk) {
  const Sense sense = chunk.lexeme.sense;
  switch (sense) {
    case Sense::kAnd:
      ReadAnd(/*is_or=*/false);
      break;
    case Sense::kOr:
      ReadAnd(/*is_or=*/true);
      break;
    case Sense::kBut:
    case Sense::kBreak:
      // "covers everything but the south", "fields everywhere but in the north"
      if (sense == Sense::kBut && AfterAll()) {
        ReadExcept();
        break;
      }
      negating_ = false;
      if (IsPhrase(at_ + 1) || IsKind(at_ + 1, ChunkKind::kPlace) || IsSense(at_ + 1, Sense::kIn) ||
          IsSense(at_ + 1, Sense::kExists) || IsKind(at_ + 1, ChunkKind::kDirection) ||
          (IsSense(at_ + 1, Sense::kTo) && IsKind(at_ + 2, ChunkKind::kDirection))) {
        if (!(IsSense(at_ + 1, Sense::kIn) && !ThingFollows(at_ + 3, false))) {
          BeginClause();
          if (!(IsPhrase(at_ + 1) && chunks_[at_ + 1].phrase.negated)) lead_ = Lead();
        }
      }
      break;
    case Sense::kThere:
      // "No forest in the south. Farmland there."
      for (const int index : subjects_) {
        if (d_.feature(index).zones.empty() && !IsLine(index)) d_.AddZones(index, there_);
      }
      break;
    case Sense::kThen:
      negating_ = false;
      then_after_ = LastSubject();
      if (!ordering_ && !subjects_.empty() &&
          (IsPhrase(at_ + 1) || (IsSense(at_ + 1, Sense::kNothingElse) && IsThing(at_ + 2)))) {
        ReadNext();
      }
      break;
    case Sense::kExists:
      if (IsKind(at_ + 1, ChunkKind::kQualities) && chunks_[at_ + 1].qualities.none) break;
      if (!subjects_.empty()) BeginClause();
      negating_ = false;
      break;
    case Sense::kBe:
    case Sense::kStands:
      verb_said_ = true;
      ++verbs_said_;
      if (subjects_.empty() && absences_.empty() &&
          ((!lead_.empty() && lead_.is_subject && sense == Sense::kBe) ||
           (map_is_subject_ && sense == Sense::kBe))) {
        cover_next_ = true;
      }
      if (frame_.has_value() && frame_->fronted && !frame_->objects.empty()) {
        frame_->expecting = false;
      }
      break;
    case Sense::kWith:
    case Sense::kHas: {
      if (frame_.has_value() && !frame_->fronted && WantsTwo(frame_->sense) &&
          frame_->objects.size() == 1 && IsPhrase(at_ + 1)) {
        frame_->expecting = true;  // "connects the lake with the village"
        break;
      }
      if (frame_.has_value() && frame_->sense == Sense::kConnects && frame_->expecting &&
          !frame_->subjects.empty() && IsKind(at_ + 1, ChunkKind::kPlace)) {
        break;  // "connects the north with the south"
      }
      // "connects the village with the eastern edge"
      if (sense == Sense::kWith && frame_.has_value() && frame_->sense == Sense::kConnects &&
          !frame_->fronted && frame_->objects.size() == 1 && IsKind(at_ + 1, ChunkKind::kPlace)) {
        OpenSense(Sense::kTo, false);
        break;
      }
      // "A village holds the middle."
      if (sense == Sense::kHas && !subjects_.empty() && IsKind(at_ + 1, ChunkKind::kPlace) &&
          EndsAt(at_ + 2)) {
        break;
      }
      // "has drawn a bow through the fields": no more than a verb.
      if (sense == Sense::kHas && !subjects_.empty() &&
          (IsSense(at_ + 1, Sense::kStands) || IsSense(at_ + 1, Sense::kRuns) ||
           IsSense(at_ + 1, Sense::kWinds) || IsSense(at_ + 1, Sense::kBe))) {
        break;
      }
      verb_said_ = false;
      // "Fill the map with forest."
      if (subjects_.empty() && at_ >= 2 && IsSense(at_ - 2, Sense::kCovers)) cover_next_ = true;
      int host = LastSubject();
      if (sense == Sense::kWith && frame_.has_value() && !frame_->fronted &&
          !frame_->objects.empty() && IsPhrase(at_ - 1)) {
        host = frame_->objects.back();
      }
      if (frame_.has_value() && frame_->fronted && !frame_->objects.empty()) {
        frame_->expecting = false;
        break;
      }
      if (!subjects_.empty() || !absences_.empty()) BeginClause();
      d_.SetTopic(host >= 0 ? std::vector<int>{host} : std::vector<int>());
      if (host >= 0 && !IsLine(host)) host_ = host;
      if (host >= 0 && d_.feature(host).form == FeatureForm::kPatch && !d_.thing(host).is_island) {
        side_of_ = host;
      }
      lead_.used = true;
      break;
    }
    case Sense::kWhere:
      if (ReadWhere()) break;
      // "a forest in which there are two clearings"
      if (at_ > 0 && IsThing(at_ - 1) && d_.LastMentioned() >= 0 && !IsLine(d_.LastMentioned()) &&
          (IsSense(at_ + 1, Sense::kExists) ||
           (ThingFollows(at_ + 1, false) &&
            ToLowerAscii(d_.Words(chunk.begin, chunk.end)).find("which") != std::string::npos))) {
        const int host = d_.LastMentioned();
        BeginClause();
        d_.SetTopic({host});
        Frame frame;
        frame.sense = Sense::kIn;
        frame.inside = true;
        frame.objects = {host};
        frame.fronted = true;
        frame.expecting = false;
        frame_ = std::move(frame);
        if (IsSense(at_ + 1, Sense::kExists)) ++at_;
        break;
      }
      if (!last_zones_.empty() && IsKind(at_ - 1, ChunkKind::kComma) && at_ >= 2 &&
          IsKind(at_ - 2, ChunkKind::kPlace)) {
        BeginClause();
        lead_ = Lead();
        lead_.zones = last_zones_;
        lead_.begin = chunk.begin;
      }
      break;
    case Sense::kWhich:
      if (frame_.has_value() && !frame_->objects.empty()) {
        const int nearest = frame_->objects.back();
        if (WantsTwo(frame_->sense) && frame_->objects.size() < 2) {
          paused_ = std::move(frame_);
          frame_.reset();
        }
        CloseFrame();
        d_.SetTopic(subjects_);
        subjects_ = {nearest};
        open_list_ = false;
      } else if (subjects_.size() > 1) {
        d_.SetTopic(subjects_);
        subjects_ = {subjects_.back()};
      }
      if (excepting_ && !lead_.empty()) {
        subjects_.clear();
        lead_.is_subject = true;
        lead_.extent = true;
      }
      break;
    case Sense::kNo:
      // "A sandbank? No."
      if (at_ == sentence_start_ && at_ > 0 && d_.instruction()[chunks_[at_ - 1].begin] == '?') {
        DropQuestion(chunk);
      }
      break;
    case Sense::kAll:
      break;
    case Sense::kNot:
      if (ReadSideWithout(chunk)) break;
      not_next_ = true;
      break;
    case Sense::kNothingElse:
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
      break;
    case Sense::kOnly:
      confining_ = true;
      // "houses only along the road"
      if (EndsWithWord(ToLowerAscii(d_.Words(chunk.begin, chunk.end)), "along") &&
          IsPhrase(at_ + 1)) {
        confining_ = false;
        OpenSense(Sense::kAlong, false);
      }
      break;
    case Sense::kExcept:
      // "near the houses but not near the road"
      if (EndsWithWord(ToLowerAscii(d_.Words(chunk.begin, chunk.end)), "not") &&
          (IsSense(at_ + 1, Sense::kNear) || IsSense(at_ + 1, Sense::kNextTo))) {
        not_next_ = true;
        break;
      }
      ReadExcept();
      break;
    case Sense::kInsteadOf:
      skip_next_ = true;
      break;
    case Sense::kCorrection:
      correcting_ = true;
      negating_ = false;
      break;
    case Sense::kScratch: {
      // "six huts, scratch that, four": only the number changes.
      const std::size_t number = at_ + (IsKind(at_ + 1, ChunkKind::kComma) ? 2 : 1);
      if (IsKind(number, ChunkKind::kQualities) && chunks_[number].qualities.count.has_value() &&
          !subjects_.empty()) {
        correcting_ = true;
        break;
      }
      CloseFrame();
      subjects_.clear();
      // "a village square, no, forget the square"
      if (EndsWithWord(ToLowerAscii(d_.Words(chunk.begin, chunk.end)), "the")) {
        DropNamed();
        break;
      }
      int first = sentence_first_feature_;
      if (first >= d_.size()) first = d_.size() - 1;
      for (int i = std::max(0, first); i < d_.size(); ++i) d_.Drop(i);
      break;
    }
    case Sense::kMostly:
      if (!subjects_.empty() && !verb_said_ &&
          (EndsAt(at_ + 1) || IsKind(at_ + 1, ChunkKind::kComma))) {
        for (const int index : subjects_) d_.feature(index).dominant = true;
      } else {
        mostly_next_ = true;
      }
      break;
    case Sense::kEntirely:
      if (!subjects_.empty() && !ThingFollows(at_ + 1, false)) {
        for (const int index : subjects_) {
          PlannedFeature& feature = d_.feature(index);
          // "houses everywhere in the south"
          const bool town = feature.letter == 'B' && feature.form == FeatureForm::kPatch &&
                            d_.plan().vocabulary == Vocabulary::kSuburb &&
                            feature.pieces_least == 0 && IsSense(at_ + 1, Sense::kIn) &&
                            IsKind(at_ + 2, ChunkKind::kPlace);
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
      } else {
        mostly_next_ = true;
      }
      break;
    case Sense::kCoveredBy:
    case Sense::kDominatedBy:
      verb_said_ = true;
      if (subjects_.empty()) {
        cover_next_ = true;
        if (sense == Sense::kDominatedBy) mostly_next_ = true;
      } else {
        const int host = LastSubject();
        if (ClotheIsland(host)) break;
        BeginClause();
        host_ = IsLine(host) ? -1 : host;
      }
      break;
    case Sense::kTreeless:
    case Sense::kRoadless:
    case Sense::kWaterless:
    case Sense::kUnbuilt:
    case Sense::kUnfarmed:
    case Sense::kSnowless: {
      const bool wild = d_.plan().vocabulary == Vocabulary::kWild;
      const char letter = sense == Sense::kTreeless    ? 'F'
                          : sense == Sense::kWaterless ? 'W'
                          : sense == Sense::kRoadless  ? (wild ? '\0' : 'R')
                          : sense == Sense::kUnbuilt   ? (wild ? '\0' : 'B')
                          : sense == Sense::kUnfarmed  ? (wild ? '\0' : 'A')
                                                       : (wild ? 'S' : '\0');
      if (letter != '\0') DenyAround(letter, chunk);
      break;
    }
    case Sense::kTravel: {
      traveling_ = true;
      // "To the right of it, in this order: beach, road, houses"
      if (frame_.has_value() && frame_->fronted && frame_->is_direction &&
          !frame_->objects.empty() && !ordering_) {
        const Heading heading = frame_->heading;
        const int first = frame_->objects.back();
        frame_.reset();
        BeginOrder(heading);
        order_ = {first};
        break;
      }
      const std::string words = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
      const bool from = EndsWithWord(words, "from") && IsKind(at_ + 1, ChunkKind::kPlace);
      if (from && subjects_.empty()) OpenSense(Sense::kFrom, false);
      break;
    }
    case Sense::kRuns:
    case Sense::kWinds: {
      verb_said_ = true;
      // "passes the village"
      const std::string verb = ToLowerAscii(d_.Words(chunk.begin, chunk.end)).substr(0, 4);
      if (verb == "pass" && IsPhrase(at_ + 1) && LineOf(subjects_) >= 0) {
        OpenSense(Sense::kPast, false);
        break;
      }
      if (frame_.has_value() && frame_->fronted && !frame_->objects.empty()) {
        frame_->expecting = false;
      }
      // "a village by a river running from ...": said of the river.
      if (frame_.has_value() && !frame_->fronted && !frame_->objects.empty() &&
          LineOf(subjects_) < 0 && IsLine(frame_->objects.back())) {
        const int line = frame_->objects.back();
        CloseFrame();
        d_.SetTopic(subjects_);
        subjects_ = {line};
      }
      if (sense == Sense::kWinds) {
        const int line = LineOf(subjects_);
        if (line >= 0) {
          d_.feature(line).meander = 2.2;
          d_.feature(line).shape = ClaimShape::kWinding;
        }
      }
      break;
    }
    case Sense::kDiagonal: {
      const int line = LineOf(subjects_);
      if (line >= 0 && !d_.feature(line).from.has_value()) {
        Waypoint from;
        from.zone = RimZoneOf({-1, -1});
        from.said = false;
        Waypoint to;
        to.zone = RimZoneOf({1, 1});
        to.said = false;
        d_.feature(line).from = from;
        d_.feature(line).to = to;
      }
      break;
    }
    case Sense::kStepsOnto:
      StepOnto();
      break;
    case Sense::kAtBothEnds:
      ReadBothEnds(chunk.lexeme.of_it);
      break;
    case Sense::kOptional:
      for (const int index : subjects_) {
        if (d_.thing(index).sentence == d_.sentence()) d_.Drop(index);
      }
      subjects_.clear();
      break;
    case Sense::kInsideBend:
      ReadInsideBend();
      break;
    case Sense::kInEach:
      PlaceInEach();
      break;
    case Sense::kAllButOne:
      ReadAllButOne();
      break;
    case Sense::kMeets:
      ReadMeeting();
      break;
    case Sense::kSwap:
      ReadSwap();
      break;
    case Sense::kLikewise:
      RunLikewise();
      break;
    case Sense::kToThere:
      ReadToThere();
      break;
    case Sense::kFromThere: {
      const int line = LineOf(subjects_);
      if (line >= 0) {
        const std::vector<int> origin = d_.Antecedent(subjects_, false);
        Frame frame;
        frame.sense = Sense::kFrom;
        frame.subjects = {line};
        frame.objects = origin;
        if (!origin.empty()) Assert(frame, line, &d_);
      }
      break;
    }
    case Sense::kCrossEachOther:
    case Sense::kParallelEach: {
      Frame frame;
      frame.sense = sense;
      frame.subjects = subjects_;
      AssertEachOther(frame, &d_);
      break;
    }
    case Sense::kApartEach:
      KeepApart();
      break;
    case Sense::kHalfEach: {
      // The things that follow, or were named, share it evenly.
      // "... of forest and fields, and a village where they meet": not the village.
      const std::size_t listed = ListLength(at_ + 1);
      std::size_t alike = 0;
      for (std::size_t i = at_ + 1, seen = 0; seen < listed && i < chunks_.size(); ++i) {
        if (!IsThing(i)) continue;
        ++seen;
        if (seen > 2 && chunks_[i].phrase.indefinite) break;
        ++alike;
      }
      const std::size_t count = std::max<std::size_t>(alike, 2);
      // "the rest is split evenly between fields and woods": how much that is nobody says.
      bool of_rest = false;
      for (std::size_t i = sentence_start_; i < at_; ++i) {
        of_rest = of_rest || (IsPhrase(i) && chunks_[i].phrase.head == Head::kRest);
      }
      const bool shared =
          std::any_of(d_.plan().features.begin(), d_.plan().features.end(),
                      [](const PlannedFeature& feature) { return feature.share.has_value(); });
      if (of_rest && !shared) break;
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
      break;
    }
    case Sense::kMoreThan:
    case Sense::kLessThan:
      // "more should be grass than trees": "than" says what is compared.
      comparing_less_ = sense == Sense::kLessThan;
      break;
    case Sense::kThan:
      // "and than" is a slip for "and then".
      if (!subjects_.empty() && !IsSense(at_ - 1, Sense::kAnd)) comparing_ = true;
      break;
    case Sense::kOtherSide:
      ReadOtherSide(chunk);
      break;
    case Sense::kBridge:
      ReadBridge(chunk);
      break;
    case Sense::kOutsideRing:
      if (ThingFollows(at_ + 1, true)) {
        if (!subjects_.empty()) BeginClause();
        lead_ = Lead();
        rest_next_ = true;
        FrontRing();
      } else {
        // "four fields outside it" are only these.
        const std::vector<int> about =
            list_has_and_ || subjects_.empty() ? subjects_ : std::vector<int>{subjects_.back()};
        for (const int index : about) {
          const bool counted = d_.feature(index).pieces_least > 0;
          if (!IsLine(index) && !counted) d_.feature(index).fills_rest = true;
        }
      }
      break;
    case Sense::kInsideRing:
      ReadInsideRing();
      break;
    case Sense::kWithin:
      // "outside the ring road fields, inside houses"
      if (ToLowerAscii(d_.Words(chunk.begin, chunk.end)) == "inside" && HasRing() &&
          (!IsPhrase(at_ + 1) || subjects_.empty() || IsKind(at_ - 1, ChunkKind::kComma)) &&
          !IsKind(at_ + 1, ChunkKind::kPlace)) {
        ReadInsideRing();
        break;
      }
      OpenSense(sense, chunk.lexeme.of_it);
      break;
    case Sense::kRest:
    case Sense::kMap:
    case Sense::kFunction:
    case Sense::kNone:
    case Sense::kAtMost:
    case Sense::kAtLeast:
    case Sense::kBands:
    case Sense::kLand:
    case Sense::kNoOther:
      if (sense == Sense::kNoOther) {
        const std::string said = ToLowerAscii(d_.Words(chunk.begin, chunk.end));
        if (IsThing(at_ + 1) && EndsWithWord(said, "all")) break;  // "that's all fields"
        if (IsThing(at_ + 1)) {
          skip_next_ = true;
        } else {
          d_.AllIsSaid();
        }
      }
      if (sense == Sense::kLand && comparing_ && !subjects_.empty()) {
        d_.feature(subjects_.back()).share = 0.58;
        d_.feature(subjects_.back()).share_least = 0.5;
        d_.feature(subjects_.back()).share_most = 1.0;
        comparing_ = false;
      }
      break;
    case Sense::kIn:
      if (IsPhrase(at_ + 1) || IsKind(at_ + 1, ChunkKind::kPlace) ||
          IsKind(at_ + 1, ChunkKind::kDirection)) {
        if (IsPhrase(at_ + 1)) OpenSense(sense, false);
      }
      break;
    case Sense::kCovers: {
      // "cover 40 % with woods", "fill the northern half with water"
      const bool share =
          IsKind(at_ + 1, ChunkKind::kQualities) && chunks_[at_ + 1].qualities.share.has_value();
      const bool place = IsKind(at_ + 1, ChunkKind::kPlace);
      if (subjects_.empty() && (share || place) && IsSense(at_ + 2, Sense::kWith)) {
        cover_next_ = true;
        break;
      }
      OpenSense(sense, chunk.lexeme.of_it);
      break;
    }
    default:
      if (sense == Sense::kCrosses && ReadAcross()) break;
      if (sense == Sense::kTo && ReadHalves()) break;
      if (sense == Sense::kTo && (IsInfinitive(at_) || IsSense(at_ + 1, Sense::kBothSides))) break;
      if (sense == Sense::kTo && IsKind(at_ + 1, ChunkKind::kDirection)) break;  // "to its south"
      OpenSense(sense, chunk.lexeme.of_it);
      break;
  }
}

}  // namespace latticeworld
