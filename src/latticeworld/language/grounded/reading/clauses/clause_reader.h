#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAUSES_CLAUSE_READER_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAUSES_CLAUSE_READER_H_

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/grounded/reading/chunk.h"
#include "latticeworld/language/grounded/reading/clauses/frame.h"
#include "latticeworld/language/grounded/reading/discourse.h"

namespace latticeworld {

// Reads the chunks of an instruction clause by clause and tells the discourse what they say: which
// thing words are about (its subjects), where a clause is set (its lead: "In the north ..."), what
// it relates (its frame), what it denies, corrects and orders. One pass; looks a few chunks ahead.
class ClauseReader {
 public:
  ClauseReader(const std::vector<Chunk>& chunks, Discourse* discourse)
      : chunks_(chunks), d_(*discourse) {}

  void Read();

 private:
  // "In the north there is ...", "The left half is ...".
  struct Lead {
    std::vector<Zone> zones;
    bool is_subject = false;  // no preposition before it
    bool extent = false;      // "half", "third": all of it is meant
    bool along = false;
    bool band = false;  // one of the stripes that the map is cut into
    bool used = false;
    std::size_t begin = 0;
    bool empty() const { return zones.empty(); }
  };

  // The last thing that was said to lie in a direction from another.
  struct Axis {
    int subject = -1;
    int object = -1;
    Heading heading;
    int sentence = 0;
  };

  // What stood right before a relation, in the one before it.
  struct Anchor {
    int owner = -1;            // "flows past the town on its western side": the town
    std::vector<int> nearest;  // its last object, if that is the last thing named
    bool nested = false;       // which lies in something itself: "a lake in a forest in a desert"
  };

  void ReadChunk(const Chunk& chunk);
  void ReadNounPhrase(const Chunk& chunk);
  void ReadPlace(const Chunk& chunk);
  void ReadDirection(const Chunk& chunk);
  void ReadAxis(const Chunk& chunk);
  void RunLinesAlong(const AxisMatch& axis, const Chunk& chunk);
  void RunPiecesAlong(const AxisMatch& axis, const Chunk& chunk);
  bool EndsThingAtAxis() const;
  void StretchAlong(const AxisMatch& axis, int index);
  void RunWhatComes(const AxisMatch& axis);
  bool IsStrip(int index) const;
  void ReadQualities(const Chunk& chunk);
  bool IsMereNumber(const Chunk& chunk) const;
  bool CorrectQualities(const Qualities& said);
  bool ReadNone(const Chunk& chunk);
  bool ReadGap(const Chunk& chunk);
  bool KeepForNext(const Qualities& said);
  std::vector<int> QualityOwners(const Qualities& said);
  void ReadSense(const Chunk& chunk);
  void ReadComma();
  void ReadAnd(bool is_or);
  bool StartsAnew(std::size_t next) const;
  bool FrameLacksObject() const;

  // Words by what they do: true where the word is one of the family; it is read then.
  bool ReadConjunction(const Chunk& chunk);
  bool ReadVerb(const Chunk& chunk);
  bool ReadDenial(const Chunk& chunk);
  bool ReadLimit(const Chunk& chunk);
  bool ReadAmount(const Chunk& chunk);
  bool ReadCourse(const Chunk& chunk);
  bool ReadTies(const Chunk& chunk);
  bool ReadWhereabouts(const Chunk& chunk);
  void ReadRelation(const Chunk& chunk);
  void ReadBreak();
  void ReadThen();
  void ReadInWhich(const Chunk& chunk);
  void ReadWhich();
  void ReadExists();
  void ReadBe(Sense sense);
  void ReadWith(Sense sense);
  bool ReadWithOfFrame(Sense sense);
  bool IsBareHas() const;
  void ReadCoveredBy(Sense sense);
  void ReadCovers(const Chunk& chunk);
  void ReadTravel(const Chunk& chunk);
  void ReadRuns(const Chunk& chunk);
  void ReadNothingElse();
  void ReadNoOther(const Chunk& chunk);
  void ReadOnly(const Chunk& chunk);
  void ReadMostly();
  void ReadEntirely();
  void ReadHalfEach();
  std::size_t AlikeAhead() const;

  // Noun phrases. Those that answer with a bool: whether the phrase did that; it is read then.
  void JoinByLine(const NounPhrase& phrase);
  bool ReadMapOrRest(const Chunk& chunk);
  bool CountThem(const Chunk& chunk);
  bool DenyThing(const Chunk& chunk);
  bool CorrectCountOf(const NounPhrase& phrase);
  bool SaysMore(const Chunk& chunk);
  void CompareWith(int other);
  bool LayOnShore(const std::vector<int>& found);
  void ReadMap(const Chunk& chunk);
  void ReadRest(const Chunk& chunk);
  void ReadAbsence(const Chunk& chunk);
  bool DeniesAnother(const ClassWord& noun) const;

  // The things that a noun phrase refers to. `about`: those that the clause speaks of already;
  // `known`: those that the phrase could mean, one at least. Each way of referring to them answers
  // with those that are meant, empty or -1 where it is not the way that the words go.
  std::vector<int> Refer(const Chunk& chunk);
  std::vector<int> ReferByPronoun(const Chunk& chunk, const std::vector<int>& about);
  std::vector<int> ReferToIt(const Chunk& chunk, const std::vector<int>& about);
  std::vector<int> ReferToThem(const NounPhrase& phrase, const std::vector<int>& about);
  std::vector<int> ReferToOne(const Chunk& chunk, const std::vector<int>& about);
  bool IsOneElsewhere(const NounPhrase& phrase) const;
  std::vector<int> OneByPlace(const Chunk& chunk, const std::vector<int>& about, int model);
  int OneOfParts(const NounPhrase& phrase, const std::vector<int>& about);
  std::vector<int> BesideFirst(const Chunk& chunk);
  int ClothedIsland(const NounPhrase& phrase);
  bool AfterMark(char mark) const;
  int MeasuredAgain(const NounPhrase& phrase);
  std::vector<int> ReferToKnown(const Chunk& chunk, const std::vector<int>& known);
  std::vector<int> PartOfKnown(const NounPhrase& phrase, const std::vector<int>& known);
  std::vector<int> ExplainedAgain(const Chunk& chunk, const std::vector<int>& known);
  std::vector<int> NextOfKnown(const NounPhrase& phrase, const std::vector<int>& known);
  std::vector<int> CountedAgain(const Chunk& chunk, const std::vector<int>& known);
  std::vector<int> PointedBackTo(const NounPhrase& phrase, const std::vector<int>& known);
  std::vector<int> NamedAsObject(const NounPhrase& phrase, const std::vector<int>& known);
  std::vector<int> NamedBarely(const NounPhrase& phrase, const std::vector<int>& known);
  std::vector<int> NamedInOtherWords(const NounPhrase& phrase, const std::vector<int>& known);
  std::vector<int> ReplacedBy(const std::vector<int>& known);
  std::vector<int> ReferToNew(const Chunk& chunk);

  // What things are in their clause.
  std::vector<int> OneMore(const Chunk& chunk);
  int SameObject() const;
  void TakeSubjects(const std::vector<int>& found, bool is_new, const Chunk& chunk);
  void PassInOrder(const std::vector<int>& found);
  void BecomeSubjects(const std::vector<int>& found, bool fronted, const NounPhrase& phrase);
  void LimitTo(int index, bool is_new, bool fronted);
  void FillAll(int index, bool is_new, const NounPhrase& phrase);
  void TakeLeadOf(int index, bool is_new, bool named);
  void TakeShare(int index, bool is_new, bool named, const Chunk& chunk);
  void TakeCourse(int index, bool is_new, bool alone);
  void AssertFronted(const std::vector<int>& found);
  void RunParallel(const std::vector<int>& found);
  void TakeSides(const std::vector<int>& found);
  void TakeObjects(const std::vector<int>& found);
  void Cover(int index, const Chunk& chunk);
  void ShareOfPlace(int index);
  void ShareOfLead(int index, const Chunk& chunk);
  bool ReadPartOf(const Chunk& chunk);
  void OnlyThis(int index, bool is_new);
  bool IsSameThing(const std::vector<int>& found, bool is_new) const;
  void Merge(int known, int other);
  bool SaysAround(std::size_t at) const;
  bool IsElsewhere(const NounPhrase& phrase, int known) const;
  bool CountsAgain(const Chunk& chunk, int known) const;
  bool SaysExactly(const Chunk& chunk) const;
  void CountExactly(const Chunk& chunk, int index);
  std::vector<Zone> PlacesAhead(const Chunk& chunk) const;
  bool IsInAnother(int index) const;
  bool RunsElsewhere(int line) const;
  bool CountsAll(const Chunk& chunk, const std::vector<int>& known);
  std::vector<int> OfCounted(const Chunk& chunk);
  int ShapedAgain(const Chunk& chunk, const std::vector<int>& known) const;
  bool BoundsAgain(const Chunk& chunk, int known) const;
  void JoinBounds(const Chunk& chunk, int known);
  void Island(int index);
  void Beside(int index, Sense beside);

  // Places. Those that answer with a bool: whether the place was said of that; it is there then.
  std::vector<Zone> ZonesSaid(const Chunk& chunk) const;
  bool MeansAllOf(const std::vector<Zone>& zones, const Chunk& chunk) const;
  void PlaceAnywhere(const Chunk& chunk);
  bool PlaceInBrackets(const std::vector<Zone>& zones, const Chunk& chunk);
  bool ExceptPlace(const std::vector<Zone>& zones, const Chunk& chunk);
  bool DenyPlace(const std::vector<Zone>& zones, const Chunk& chunk);
  bool CorrectPlace(const std::vector<Zone>& zones);
  bool TravelToward(const std::vector<Zone>& zones, const Chunk& chunk);
  bool PlaceFrontedObject(const std::vector<Zone>& zones, const Chunk& chunk);
  bool TurnBehind(const std::vector<Zone>& zones);
  bool TakePlaceAsObject(const std::vector<Zone>& zones, const Chunk& chunk);
  bool PlaceBorders(const std::vector<Zone>& zones, const Chunk& chunk);
  bool PlaceTouching(const std::vector<Zone>& zones, const Chunk& chunk);
  bool LeadsClause() const;
  void TakeLead(const std::vector<Zone>& zones, const Chunk& chunk);
  void Attach(const std::vector<Zone>& zones, bool extent, const Chunk& chunk);
  void NarrowDenials(const std::vector<Zone>& zones, const Chunk& chunk);
  std::vector<int> PlaceOwners() const;
  bool AttachToObject(const std::vector<Zone>& zones, const Chunk& chunk, std::vector<int>* owners);
  void LeaveOutUnplaced(std::vector<int>* owners) const;
  void AttachTo(int index, const std::vector<Zone>& zones, bool fills, const Chunk& chunk);
  bool RunTo(const std::vector<Zone>& zones, const std::string& words, PlannedFeature* line) const;
  bool IsUncounted(int index) const;
  bool TurnsAt(const std::vector<Zone>& zones, PlannedFeature* line) const;
  void Lead_(const std::vector<Zone>& zones, const Chunk& chunk);
  static bool IsMany(const std::vector<Zone>& zones);
  std::vector<Zone> OtherZones(std::vector<Zone> zones, std::string_view words) const;
  bool TakeEndZone(const std::vector<Zone>& zones);
  bool TakeFirstEnd(const std::vector<Zone>& zones);
  bool HugEdge(const std::vector<Zone>& zones, const Chunk& chunk);
  bool TakePassage(const std::vector<Zone>& zones, const Chunk& chunk);
  void EndLines(const std::vector<Zone>& zones, const Waypoint& end, const Chunk& chunk);
  bool ReachEdges(int line, const std::vector<Zone>& zones, const Chunk& chunk);
  bool BendToward(int line, const std::vector<Zone>& zones, const Chunk& chunk);
  void EndLine(int index, const Waypoint& end, const Chunk& chunk);
  bool WalkOn(const std::vector<Zone>& zones);
  bool StandThere(const std::vector<Zone>& zones, const Chunk& chunk);
  void EndWhatComes(const Waypoint& end);
  void EndBelt(const std::vector<Zone>& zones, const Waypoint& end, const Chunk& chunk);
  bool TakeOtherEnd(const std::vector<Zone>& zones);
  void JoinEnds(int line);
  bool DealOut(int line, const std::vector<Zone>& zones, const std::string& words, bool from);
  bool TakeHeading(const std::vector<Zone>& zones);
  bool SplitsMap(const std::vector<Zone>& zones, const std::string& words);
  void Deny(char letter, const std::vector<Zone>& zones, const Chunk& chunk);
  void ReadExcept();
  void ReadExceptOrNot(const Chunk& chunk);
  void ReadLack(const Chunk& chunk);
  void ReadScratch(const Chunk& chunk);
  void DropOptional();
  bool AfterAll() const;
  void ReadNext();
  void DropQuestion(const Chunk& chunk);
  bool ReadSideWithout(const Chunk& chunk);
  void ReadToThere();
  void StepOnto();
  bool ReadNextRing();
  void ResolveBehind(Frame* frame) const;
  void ReadAllButOne();
  void FrontRing();
  void ReadInsideBend();
  Heading WayOf(int index) const;
  void ReadBothEnds(bool of_it);
  bool ReadFartherSides();
  bool ReadInBetween();
  bool InBrackets();
  bool BeginsImperative(std::size_t next) const;
  bool ClotheIsland(int host);
  bool OppositePlace(const std::string& words, std::vector<Zone>* zones) const;
  void ReadMeeting();
  void ReadSwap();
  bool ReadLeftOut(const Chunk& chunk);
  bool ReadAcross();
  void ReachAllSides(int line);
  bool SaysReach() const;
  void TakeMoreEnds(int line);
  void RunLikewise();
  void RunDiagonally();
  void RunFromThere();
  void DenyAround(char letter, const Chunk& chunk);

  // Frames.
  std::vector<int> InContrast(const Frame& frame, const std::vector<int>& found) const;
  void NoteAxis(const Frame& frame, int subject);
  bool TakeContrast(const std::vector<Zone>& zones);
  void Follow(int index);
  void ReadOtherSide(const Chunk& chunk);
  bool ReadOppositeOf();
  void ReadInsideRing();
  void ReadOutsideRing();
  void ReadWithin(const Chunk& chunk);
  bool HasRing() const;
  void ReadBridge(const Chunk& chunk);
  std::vector<int> Own(const Frame& frame, const std::vector<int>& subjects) const;
  bool SaysLeaving() const;
  void KeepApart();
  bool SaysThreeSides() const;
  bool RunsBetween() const;
  bool TiesSubject(std::size_t at) const;
  bool IsBeyondKnown(int index) const;
  void Open(Frame frame);
  bool NamesSecondObject(Sense sense);
  void StartFromObject();
  bool StandsInFrame(const Frame& frame, Sense sense);
  bool GiveWay(Sense sense, const std::string& words, Frame* frame);
  Anchor AnchorOf(const Frame& frame, Sense sense) const;
  bool AfterBreak() const;
  bool MayLead(const Frame& frame, Sense sense) const;
  void OpenFronted(Frame frame, Sense sense);
  std::vector<int> SubjectsOf(Sense sense, const std::string& words, const Anchor& anchor);
  bool TakeOwnObject(int owner, Frame* frame);
  void OpenSense(Sense sense, bool of_it);
  void TakeBackDenials();
  void PlaceDenials(const Frame& frame);
  void DropNamed();
  void CloseFrame();
  bool Fronts(std::size_t at) const;
  bool SaysClose(const Chunk& chunk) const;
  bool ReadSideToCome();
  bool ReadSideOfHost();
  bool ReadSideAt(std::size_t at);
  void AssertMoreSides(Frame frame);
  int LineOf(const std::vector<int>& indices) const;

  // Clauses.
  void BeginClause();
  void EndSentence();
  void EndHost();
  bool IsSpot(int index) const;
  void FinishOrder();
  void BeginOrder(Heading heading);
  void LayInBand(int index, const Zone& band);
  void FillBand(int index);

  // What lies ahead.
  const Chunk* ChunkAt(std::size_t at) const {
    return at < chunks_.size() ? &chunks_[at] : nullptr;
  }
  bool IsThing(std::size_t at) const;   // a noun phrase that names a class
  bool IsPhrase(std::size_t at) const;  // any noun phrase
  bool IsSense(std::size_t at, Sense sense) const;
  bool IsKind(std::size_t at, ChunkKind kind) const;
  bool ReadWhere();
  bool ReadHalves();
  bool IsInfinitive(std::size_t at) const;
  bool IsOtherWord(const Chunk& chunk) const;
  bool OrderGoesOn() const;
  int OneOfSeveral() const;
  bool OneAgain() const;
  bool SomeOf(const NounPhrase& phrase, int index) const;
  int NthOfThese(std::size_t n) const;
  std::vector<int> Likes(int index, const std::vector<int>& about) const;
  int NextPart();
  std::vector<int> Arm(const Chunk& chunk);
  std::vector<int> OneLine(const Chunk& chunk);
  void BranchOff(int arm, int river);
  std::vector<int> IslandOf(const NounPhrase& phrase);
  void PlaceInEach();
  int Unplaced(int model);
  bool IsEach(std::size_t at) const;
  bool EndsAt(std::size_t at) const;  // the sentence or the instruction
  bool ThingFollows(std::size_t at, bool over_comma) const;
  bool IsSaidAnew(std::size_t at) const;  // "some houses", "a lot of forest"
  bool IsBareList(std::size_t at) const;  // "fields, meadows and woods" with nothing of their own
  std::size_t SkipVerbs(std::size_t at) const;
  std::size_t ListLength(std::size_t at) const;

  bool IsLine(int index) const { return d_.feature(index).form == FeatureForm::kLine; }
  int LastSubject() const { return subjects_.empty() ? -1 : subjects_.back(); }

  const std::vector<Chunk>& chunks_;
  Discourse& d_;
  std::size_t at_ = 0;

  std::vector<int> subjects_;
  bool open_list_ = false;  // a noun phrase may still join the subjects
  bool list_has_and_ = false;
  bool joining_ = false;  // the next one does
  bool verb_said_ = false;
  int verbs_said_ = 0;  // in this sentence
  int gave_way_ = -1;   // the last sentence in which something gave way to something
  int covered_ = -1;    // the last sentence that said what covers a place
  std::optional<Frame> frame_;
  std::optional<Frame> paused_;  // waits for its second object: "between X, which ..., and Y"
  Lead lead_;
  bool map_is_subject_ = false;
  std::optional<ShareMatch> map_share_;
  bool share_of_map_ = false;  // map_share_ is said to be one: "half of the map"
  std::size_t sharing_ = 0;    // things that are still to take map_share_, each of them
  bool cover_next_ = false;
  bool mostly_next_ = false;
  bool only_next_ = false;  // "nothing but"
  bool rest_next_ = false;
  bool skip_next_ = false;  // "instead of"
  bool not_next_ = false;
  bool negating_ = false;  // a list of what is denied goes on
  bool excepting_ = false;
  bool confining_ = false;  // "only in"
  bool correcting_ = false;
  bool comparing_ = false;  // "more forest than"
  bool comparing_less_ = false;
  std::vector<std::size_t> absences_;  // of this clause: a place belongs to them
  int gap_ = 0;                        // cells that are said to lie between two things
  std::vector<Zone> last_zones_;
  std::vector<Zone> zones_before_;  // the same, from whatever sentence
  std::vector<Zone> halves_;        // the last two halves or other like places that were named
  std::vector<Zone> there_;         // what "there" means, of an earlier sentence too
  Axis axis_;
  std::vector<std::pair<int, Heading>> sides_to_come_;  // of a thing that is yet to be named
  int then_after_ = -1;                                 // "..., then": what comes next follows it
  std::optional<Waypoint> from_;                        // of a line that is to come
  std::optional<Waypoint> to_;
  bool ordering_ = false;
  Heading order_heading_;
  std::vector<int> order_;
  std::size_t order_begin_ = 0;
  bool traveling_ = false;
  int it_ = -1;           // what "it" meant last
  int it_sentence_ = -1;  // in this sentence
  int first_ = -1;        // "the first lake", which no words before it named
  int fork_ = -1;         // a river that forks; its first arm is the river itself
  int split_ = -1;        // what is left of it is "the other"
  int host_ = -1;         // "a forest with ..."
  int side_of_ = -1;      // "a village with fields to the west, a lake to the east": the village
  int hosted_ = -1;
  std::size_t host_relations_ = 0;
  std::size_t sentence_start_ = 0;  // chunk
  int sentence_first_feature_ = 0;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_READING_CLAUSES_CLAUSE_READER_H_
