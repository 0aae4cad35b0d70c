#include "latticeworld/language/grounded/reading/clauses/clause_reader.h"

// What words do that name neither a thing nor a place nor a quality, family by family.
namespace latticeworld {

void ClauseReader::ReadSense(const Chunk& chunk) {
  const bool read = ReadConjunction(chunk) || ReadVerb(chunk) || ReadDenial(chunk) ||
                    ReadLimit(chunk) || ReadAmount(chunk) || ReadCourse(chunk) || ReadTies(chunk) ||
                    ReadWhereabouts(chunk);
  if (!read) ReadRelation(chunk);
}

// "and", "but", "while", "which": how clauses go together.
bool ClauseReader::ReadConjunction(const Chunk& chunk) {
  switch (chunk.lexeme.sense) {
    case Sense::kAnd:
      ReadAnd(/*is_or=*/false);
      return true;
    case Sense::kOr:
      ReadAnd(/*is_or=*/true);
      return true;
    case Sense::kBut:
      // "covers everything but the south", "fields everywhere but in the north"
      if (AfterAll()) {
        ReadExcept();
      } else {
        ReadBreak();
      }
      return true;
    case Sense::kBreak:
      ReadBreak();
      return true;
    case Sense::kThen:
      ReadThen();
      return true;
    case Sense::kWhere:
      ReadInWhich(chunk);
      return true;
    case Sense::kWhich:
      ReadWhich();
      return true;
    default:
      return false;
  }
}

// "there is", "has", "is covered by", "runs".
bool ClauseReader::ReadVerb(const Chunk& chunk) {
  const Sense sense = chunk.lexeme.sense;
  switch (sense) {
    case Sense::kExists:
      ReadExists();
      return true;
    case Sense::kBe:
    case Sense::kStands:
      ReadBe(sense);
      return true;
    case Sense::kWith:
    case Sense::kHas:
      ReadWith(sense);
      return true;
    case Sense::kCoveredBy:
    case Sense::kDominatedBy:
      ReadCoveredBy(sense);
      return true;
    case Sense::kCovers:
      ReadCovers(chunk);
      return true;
    case Sense::kTravel:
      ReadTravel(chunk);
      return true;
    case Sense::kRuns:
    case Sense::kWinds:
      ReadRuns(chunk);
      return true;
    default:
      return false;
  }
}

// "not", "treeless", "instead of", "scratch that": what is not so, or no longer.
bool ClauseReader::ReadDenial(const Chunk& chunk) {
  switch (chunk.lexeme.sense) {
    case Sense::kNo:
      // "A sandbank? No."
      if (at_ == sentence_start_ && at_ > 0 && d_.instruction()[chunks_[at_ - 1].begin] == '?') {
        DropQuestion(chunk);
      }
      return true;
    case Sense::kNot:
      if (!ReadSideWithout(chunk)) not_next_ = true;
      return true;
    case Sense::kTreeless:
    case Sense::kRoadless:
    case Sense::kWaterless:
    case Sense::kUnbuilt:
    case Sense::kUnfarmed:
    case Sense::kSnowless:
      ReadLack(chunk);
      return true;
    case Sense::kExcept:
      ReadExceptOrNot(chunk);
      return true;
    case Sense::kInsteadOf:
      skip_next_ = true;
      return true;
    case Sense::kCorrection:
      correcting_ = true;
      negating_ = false;
      return true;
    case Sense::kScratch:
      ReadScratch(chunk);
      return true;
    case Sense::kSwap:
      ReadSwap();
      return true;
    case Sense::kOptional:
      DropOptional();
      return true;
    default:
      return false;
  }
}

// "only", "nothing else", "mostly", "entirely": how far what is said goes.
bool ClauseReader::ReadLimit(const Chunk& chunk) {
  switch (chunk.lexeme.sense) {
    case Sense::kNothingElse:
      ReadNothingElse();
      return true;
    case Sense::kNoOther:
      ReadNoOther(chunk);
      return true;
    case Sense::kOnly:
      ReadOnly(chunk);
      return true;
    case Sense::kMostly:
      ReadMostly();
      return true;
    case Sense::kEntirely:
      ReadEntirely();
      return true;
    default:
      return false;
  }
}

// "half each", "more than": how much there is, beside something else.
bool ClauseReader::ReadAmount(const Chunk& chunk) {
  const Sense sense = chunk.lexeme.sense;
  switch (sense) {
    case Sense::kHalfEach:
      ReadHalfEach();
      return true;
    case Sense::kMoreThan:
    case Sense::kLessThan:
      // "more should be grass than trees": "than" says what is compared.
      comparing_less_ = sense == Sense::kLessThan;
      return true;
    case Sense::kThan:
      // "and than" is a slip for "and then".
      if (!subjects_.empty() && !IsSense(at_ - 1, Sense::kAnd)) comparing_ = true;
      return true;
    case Sense::kLand:
      // "more water than land"
      if (comparing_ && !subjects_.empty()) {
        d_.feature(subjects_.back()).share = 0.58;
        d_.feature(subjects_.back()).share_least = 0.5;
        d_.feature(subjects_.back()).share_most = 1.0;
        comparing_ = false;
      }
      return true;
    default:
      return false;
  }
}

// "diagonally", "to there", "inside its bend": how lines run.
bool ClauseReader::ReadCourse(const Chunk& chunk) {
  switch (chunk.lexeme.sense) {
    case Sense::kDiagonal:
      RunDiagonally();
      return true;
    case Sense::kStepsOnto:
      StepOnto();
      return true;
    case Sense::kAtBothEnds:
      ReadBothEnds(chunk.lexeme.of_it);
      return true;
    case Sense::kInsideBend:
      ReadInsideBend();
      return true;
    case Sense::kLikewise:
      RunLikewise();
      return true;
    case Sense::kToThere:
      ReadToThere();
      return true;
    case Sense::kFromThere:
      RunFromThere();
      return true;
    case Sense::kBridge:
      ReadBridge(chunk);
      return true;
    default:
      return false;
  }
}

// "cross each other", "far apart": what things are to each other.
bool ClauseReader::ReadTies(const Chunk& chunk) {
  const Sense sense = chunk.lexeme.sense;
  switch (sense) {
    case Sense::kCrossEachOther:
    case Sense::kParallelEach: {
      Frame frame;
      frame.sense = sense;
      frame.subjects = subjects_;
      AssertEachOther(frame, &d_);
      return true;
    }
    case Sense::kApartEach:
      KeepApart();
      return true;
    case Sense::kMeets:
      ReadMeeting();
      return true;
    default:
      return false;
  }
}

// "there", "in each", "on the other side", "inside the ring": where things are.
bool ClauseReader::ReadWhereabouts(const Chunk& chunk) {
  switch (chunk.lexeme.sense) {
    case Sense::kThere:
      // "No forest in the south. Farmland there."
      for (const int index : subjects_) {
        if (d_.feature(index).zones.empty() && !IsLine(index)) d_.AddZones(index, there_);
      }
      return true;
    case Sense::kInEach:
      PlaceInEach();
      return true;
    case Sense::kAllButOne:
      ReadAllButOne();
      return true;
    case Sense::kOtherSide:
      ReadOtherSide(chunk);
      return true;
    case Sense::kOutsideRing:
      ReadOutsideRing();
      return true;
    case Sense::kInsideRing:
      ReadInsideRing();
      return true;
    case Sense::kWithin:
      ReadWithin(chunk);
      return true;
    default:
      return false;
  }
}

// Words that begin a relation, and those that tell nothing by themselves.
void ClauseReader::ReadRelation(const Chunk& chunk) {
  const Sense sense = chunk.lexeme.sense;
  switch (sense) {
    case Sense::kNone:
    case Sense::kFunction:
    case Sense::kAll:
    case Sense::kRest:
    case Sense::kMap:
    case Sense::kAtMost:
    case Sense::kAtLeast:
    case Sense::kBands:
      return;
    case Sense::kIn:
      if (IsPhrase(at_ + 1)) OpenSense(sense, false);
      return;
    case Sense::kCrosses:
      if (ReadAcross()) return;
      break;
    case Sense::kTo:
      if (ReadHalves()) return;
      if (IsInfinitive(at_) || IsSense(at_ + 1, Sense::kBothSides)) return;
      if (IsKind(at_ + 1, ChunkKind::kDirection)) return;  // "to its south"
      break;
    default:
      break;
  }
  OpenSense(sense, chunk.lexeme.of_it);
}

}  // namespace latticeworld
