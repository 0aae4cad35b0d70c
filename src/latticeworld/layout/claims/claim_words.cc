#include <cmath>
#include <cstdio>
#include <string>

#include "latticeworld/layout/claims/claim_headings.h"
#include "latticeworld/layout/claims/claim_measures.h"

// What a claim's reading says, in words: what is there, and what is asked.
namespace latticeworld::internal {
namespace {

std::string Percent(double share) {
  char text[16];
  std::snprintf(text, sizeof(text), "%.1f %%", 100.0 * share);
  return text;
}

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}

std::string Place(const Zone& zone) {
  return zone.is_anywhere() ? std::string("the layout") : "the " + zone.name;
}

// "at least 3", "at most 3", "3 to 5", "exactly 3".
std::string Asked(double least, double most, std::string (*show)(double)) {
  if (most == Claim::kUnsaid) return "at least " + show(least);
  if (least == most) return "exactly " + show(least);
  if (least <= 0.0) return "at most " + show(most);
  return show(least) + " to " + show(most);
}

class Words {
 public:
  Words(const Claim& claim, const ClaimMeasure& reading, Vocabulary vocabulary)
      : claim_(claim), reading_(reading), vocabulary_(vocabulary) {}

  std::string Found() const;
  std::string Demanded() const;

  std::string Name(char letter) const {
    const LayoutClass* entry = FindClass(vocabulary_, letter);
    return entry != nullptr ? std::string(entry->name) : std::string(1, letter);
  }

 private:
  std::string FoundShape() const;
  std::string DemandedShape() const;
  // "forest of the northern half".
  std::string Subject() const { return Named(claim_.subject, claim_.zone); }
  std::string Object() const { return Named(claim_.object, claim_.object_zone); }
  std::string Second() const { return Name(claim_.second_object); }
  std::string Named(char letter, const Zone& zone) const {
    return zone.is_anywhere() ? Name(letter) : Name(letter) + " of " + Place(zone);
  }

  const Claim& claim_;
  const ClaimMeasure& reading_;
  const Vocabulary vocabulary_;
};

std::string Words::Found() const {
  const std::string value = Number(reading_.value), share = Percent(reading_.value);
  const bool holds = reading_.distance == 0.0;
  // Each kind tells in words what MeasureClaim put into `value` and `other`.
  switch (claim_.kind) {
    case ClaimKind::kPresent:
    case ClaimKind::kAbsent:
    case ClaimKind::kAmount:
    case ClaimKind::kDominant:
    case ClaimKind::kMoreThan:
      return Name(claim_.subject) + " covers " + share + " of " + Place(claim_.zone);
    case ClaimKind::kLocated:
      return share + " of " + Name(claim_.subject) + " lies in " + Place(claim_.zone);
    case ClaimKind::kCount:
      return Name(claim_.subject) + " has " + value + (value == "1" ? " piece" : " pieces") +
             " in " + Place(claim_.zone);
    case ClaimKind::kClustered:
      return Subject() + " lies in " + Number(reading_.other) + " pieces, the largest " +
             Number(MostOf(claim_)) + " with " + share;
    case ClaimKind::kScattered:
      return Subject() + " lies in " + value + " pieces, the largest with " +
             Percent(reading_.other);
    case ClaimKind::kAdjacent:
    case ClaimKind::kApart:
      return Subject() + " and " + Object() + " are " + value +
             (value == "1" ? " step apart" : " steps apart");
    case ClaimKind::kSurrounds:
      return Subject() + " makes up " + share + " of the border of " + Object();
    case ClaimKind::kWithin:
      return Object() + " makes up " + share + " of the border of " + Subject();
    case ClaimKind::kBothSides:
      return share + " of the " + Subject() + " near " + Object() + " is on its lesser side";
    case ClaimKind::kBetween:
      if (holds) return Subject() + " lies between " + Object() + " and " + Second();
      return Subject() + " is " + value + " cells from lying between " + Object() + " and " +
             Second();
    case ClaimKind::kDirection: {
      const bool away = reading_.value < 0.0;
      const Claim::Heading heading{away ? -claim_.heading.east : claim_.heading.east,
                                   away ? -claim_.heading.south : claim_.heading.south};
      return Subject() + " lies " + Number(std::abs(reading_.value)) + " cells to the " +
             std::string(NameOf(heading)) + " of " + Object();
    }
    case ClaimKind::kOrder:
      return value + " of " + std::to_string(claim_.sequence.size() - 1) + " steps go another way";
    case ClaimKind::kCourse:
      return "the best " + Subject() + " ends " + value + " cells short";
    case ClaimKind::kThrough:
      return Subject() + " has " + Object() + " on both sides along " + value + " cells";
    case ClaimKind::kAlong:
      return share + " of " + Name(claim_.subject) + " lies along " +
             (claim_.object == '\0' ? Place(claim_.zone) : Object());
    case ClaimKind::kCrosses:
      return Subject() + " and " + Object() + (holds ? " cross" : " do not cross");
    case ClaimKind::kParallel:
      return Subject() + " and " + Object() + " differ by " + value + " degrees and overlap by " +
             Percent(reading_.other);
    case ClaimKind::kConnects:
      return "the best " + Subject() + " is " + value + " cells short of " + Object() + " and " +
             Second();
    case ClaimKind::kShape:
      return "the largest piece of " + Subject() + " " + FoundShape();
    case ClaimKind::kRest:
      return Name(claim_.subject) + " covers " + share + " of what is left of " +
             Place(claim_.zone);
  }
  return "";
}

std::string Words::FoundShape() const {
  const std::string value = Number(reading_.value), other = Number(reading_.other);
  switch (claim_.shape) {
    case ClaimShape::kRound:
      return "is " + value + " times as long as wide and fills " + Percent(reading_.other) +
             " of its outline";
    case ClaimShape::kElongated:
      return "is " + value + " times as long as wide";
    case ClaimShape::kBent:
      return "is " + value + " times as long as wide, its middle " + Percent(reading_.other) +
             " of its length off its chord";
    case ClaimShape::kRing:
      return "encloses " + value + " cells";
    case ClaimShape::kStraight:
    case ClaimShape::kWinding:
      return "is " + value + " times as long as wide and leaves its chord by " + other + " cells";
    case ClaimShape::kGridded:
      return "encloses " + value + " blocks and parts the layout into " + other;
  }
  return "";
}

std::string Words::Demanded() const {
  const double least = LeastOf(claim_), most = MostOf(claim_);
  // Each kind tells in words what its bounds ask for, or the usual bounds if it has none.
  switch (claim_.kind) {
    case ClaimKind::kPresent:
    case ClaimKind::kLocated:
    case ClaimKind::kSurrounds:
    case ClaimKind::kWithin:
    case ClaimKind::kAlong:
    case ClaimKind::kRest:
      return "at least " + Percent(least) + " is asked";
    case ClaimKind::kAbsent:
      return (most <= 0.0 ? "none" : "at most " + Percent(most)) + " is asked";
    case ClaimKind::kAmount:
      return Asked(least, most, Percent) + " is asked";
    case ClaimKind::kDominant:
      return "more than any other class (" + Percent(reading_.other) + ") is asked";
    case ClaimKind::kMoreThan:
      return "more than " + Name(claim_.object) + " (" + Percent(reading_.other) + ") is asked";
    case ClaimKind::kCount:
      return Asked(least, most, Number) + " is asked";
    case ClaimKind::kClustered:
      return "90 % in at most " + Number(most) + " is asked";
    case ClaimKind::kScattered:
      return "at least " + Number(least) + " is asked, none with more than half";
    case ClaimKind::kAdjacent:
      return "at most " + Number(most) + " is asked";
    case ClaimKind::kApart:
      return "at least " + Number(least) + " is asked";
    case ClaimKind::kBothSides:
      return "at least 10 % is asked";
    case ClaimKind::kBetween:
      return "a place on the way from one to the other is asked";
    case ClaimKind::kDirection:
      return "more to the " + std::string(NameOf(claim_.heading)) + " than to the side is asked";
    case ClaimKind::kOrder:
      return "the order " + claim_.sequence + " to the " + std::string(NameOf(claim_.heading)) +
             " is asked";
    case ClaimKind::kCourse:
      return "one piece from " + Place(claim_.from) + " to " + Place(claim_.to) + " is asked";
    case ClaimKind::kThrough:
      return "at least 2 is asked";
    case ClaimKind::kCrosses:
      return "a crossing is asked";
    case ClaimKind::kParallel:
      return "two lines side by side that do not touch are asked";
    case ClaimKind::kConnects:
      return "one piece that reaches both is asked";
    case ClaimKind::kShape:
      return DemandedShape();
  }
  return "";
}

std::string Words::DemandedShape() const {
  switch (claim_.shape) {
    case ClaimShape::kRound:
      return "at most 1.6 times and at least 70 % is asked";
    case ClaimShape::kElongated:
      return "at least 2 times is asked";
    case ClaimShape::kBent:
      return "at least 2 times and 15 % is asked";
    case ClaimShape::kRing:
      return "at least a tenth of its own is asked";
    case ClaimShape::kStraight:
      return "at least 2.5 times and at most 1.5 cells is asked";
    case ClaimShape::kWinding:
      return "at least 2.5 times and 2 cells is asked";
    case ClaimShape::kGridded:
      return "two blocks, or six parts, is asked";
  }
  return "";
}

}  // namespace

std::string Explain(const Claim& claim, const ClaimMeasure& reading, Vocabulary vocabulary) {
  const Words words(claim, reading, vocabulary);
  if (reading.missing != '\0') return "there is too little " + words.Name(reading.missing);
  return words.Found() + "; " + words.Demanded();
}

}  // namespace latticeworld::internal
