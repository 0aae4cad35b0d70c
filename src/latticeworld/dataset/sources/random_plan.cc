#include "latticeworld/dataset/sources/random_plan.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "latticeworld/language/grounded/reading/claims_of_plan.h"
#include "latticeworld/layout/class_letters.h"
#include "latticeworld/layout/zone.h"

namespace latticeworld {
namespace {

// Zones in words that a place may have, by what is said of them.
constexpr std::string_view kLandZones[] = {"northern half",
                                           "southern half",
                                           "western half",
                                           "eastern half",
                                           "northern third",
                                           "southern third",
                                           "western third",
                                           "eastern third",
                                           "middle rows",
                                           "middle columns",
                                           "northern quarter",
                                           "southern quarter",
                                           "western quarter",
                                           "eastern quarter",
                                           "north-western quarter",
                                           "north-eastern quarter",
                                           "upper left",
                                           "upper right",
                                           "lower left",
                                           "lower right",
                                           "south-western quarter",
                                           "south-eastern quarter",
                                           "edges",
                                           "center"};
constexpr std::string_view kPieceZones[] = {"upper left",
                                            "upper",
                                            "upper right",
                                            "middle left",
                                            "center",
                                            "middle right",
                                            "lower left",
                                            "lower",
                                            "lower right",
                                            "northern half",
                                            "southern half",
                                            "western half",
                                            "eastern half",
                                            "north-west corner",
                                            "north-east corner",
                                            "south-west corner",
                                            "south-east corner",
                                            "northern third",
                                            "southern third",
                                            "western third",
                                            "eastern third"};
constexpr std::string_view kEndZones[] = {
    "northern edge",     "southern edge",     "western edge",      "eastern edge",
    "north-west corner", "north-east corner", "south-west corner", "south-east corner",
    "northern edge",     "southern edge",     "western edge",      "eastern edge"};

struct WeightedLetter {
  char letter;
  double weight;
};

// What a vocabulary's classes are made into.
struct Palette {
  std::vector<WeightedLetter> land;    // covers: also the background
  std::vector<WeightedLetter> pieces;  // lakes, villages, groves
  std::vector<WeightedLetter> lines;
};

Palette PaletteOf(Vocabulary vocabulary) {
  using class_letter::kForest, class_letter::kWater;
  if (vocabulary == Vocabulary::kSuburb) {
    using suburb_letter::kBarren, suburb_letter::kBuilding, suburb_letter::kFarmland,
        suburb_letter::kGrassland, suburb_letter::kRoad;
    return {{{kGrassland, 4.0},
             {kFarmland, 3.0},
             {kForest, 2.5},
             {kBarren, 1.2},
             {kBuilding, 0.6},
             {kWater, 0.5}},
            {{kBuilding, 3.5},
             {kWater, 3.0},
             {kForest, 2.0},
             {kFarmland, 1.0},
             {kBarren, 1.0},
             {kGrassland, 0.7}},
            {{kRoad, 3.0}, {kWater, 2.0}}};
  }
  using wild_letter::kGrassland, wild_letter::kRock, wild_letter::kSnow;
  return {{{kGrassland, 3.0}, {kForest, 3.0}, {kRock, 2.0}, {kSnow, 1.5}, {kWater, 0.6}},
          {{kWater, 3.0}, {kForest, 2.0}, {kRock, 2.0}, {kSnow, 1.5}, {kGrassland, 1.0}},
          {{kWater, 1.0}}};
}

class PlanMaker {
 public:
  PlanMaker(Vocabulary vocabulary, RandomStream* random)
      : random_(*random), palette_(PaletteOf(vocabulary)) {
    plan_.vocabulary = vocabulary;
  }

  LayoutPlan Make() {
    plan_.background = Draw(palette_.land);
    if (random_.Chance(0.12)) {
      AddBands();
    } else {
      for (int i = random_.UniformInt(1, 4); i > 0; --i) AddLand();
    }
    for (int i = random_.UniformInt(0, 4); i > 0; --i) AddPieces();
    const std::vector<double> lines = plan_.vocabulary == Vocabulary::kSuburb
                                          ? std::vector<double>{2.0, 4.0, 3.0, 1.0}
                                          : std::vector<double>{3.0, 4.0, 1.0};
    for (std::size_t i = random_.Weighted(lines); i > 0; --i) AddLine();
    while (plan_.features.empty()) AddPieces();
    for (int i = random_.UniformInt(0, 2); i > 0; --i) AddRelation();
    if (random_.Chance(0.15)) AddAbsence();
    plan_.claims = ClaimsOfPlan(plan_);
    return std::move(plan_);
  }

 private:
  char Draw(const std::vector<WeightedLetter>& letters) {
    std::vector<double> weights;
    for (const WeightedLetter& entry : letters) weights.push_back(entry.weight);
    return letters[random_.Weighted(weights)].letter;
  }
  template <std::size_t kCount>
  Zone DrawZone(const std::string_view (&names)[kCount]) {
    return *FindZone(names[random_.UniformInt(0, static_cast<int>(kCount) - 1)]);
  }
  bool Uses(char letter) const {
    return letter == plan_.background ||
           std::any_of(plan_.features.begin(), plan_.features.end(),
                       [&](const PlannedFeature& feature) { return feature.letter == letter; });
  }

  void AddLand() {
    PlannedFeature land;
    land.letter = Draw(palette_.land);
    if (Uses(land.letter)) return;
    land.form = FeatureForm::kSpread;
    land.cells = random_.UniformInt(80, 220);
    const std::size_t way = random_.Weighted({5.0, 2.0, 1.5, 1.0});
    if (way == 0) {
      land.zones.push_back(DrawZone(kLandZones));
      if (random_.Chance(0.15)) land.zones.push_back(DrawZone(kLandZones));
      land.confined = random_.Chance(0.2);
      land.dominant = random_.Chance(0.3);
    } else if (way == 1) {
      const double share = 0.05 * random_.UniformInt(2, 9);
      land.share = share;
      land.share_least = share - 0.05;
      land.share_most = share + 0.05;
    } else if (way == 2) {
      land.dominant = true;
    } else {
      land.texture = Texture::kScattered;
      land.cells = random_.UniformInt(20, 60);
    }
    plan_.features.push_back(std::move(land));
  }

  // Land in strips from one side to the other, as it lies on a mountain's flank.
  void AddBands() {
    std::vector<char> letters;
    for (const WeightedLetter& entry : palette_.land) {
      const bool taken = entry.letter != class_letter::kWater || random_.Chance(0.4);
      if (taken) letters.push_back(entry.letter);
    }
    random_.Shuffle(&letters);
    letters.resize(static_cast<std::size_t>(random_.UniformInt(2, 3)));
    plan_.background = letters.front();
    PlannedOrder order;
    constexpr Claim::Heading kHeadings[] = {{0, 1}, {0, -1}, {1, 0}, {-1, 0}};
    order.heading = kHeadings[random_.UniformInt(0, 3)];
    for (const char letter : letters) {
      PlannedFeature band;
      band.letter = letter;
      band.cells = 1024 / static_cast<int>(letters.size());
      order.features.push_back(static_cast<int>(plan_.features.size()));
      plan_.features.push_back(std::move(band));
    }
    plan_.orders.push_back(std::move(order));
  }

  void AddPieces() {
    PlannedFeature piece;
    piece.letter = Draw(palette_.pieces);
    if (piece.letter == plan_.background) return;
    piece.form = FeatureForm::kPatch;
    piece.pieces = random_.Chance(0.55) ? 1 : random_.UniformInt(2, 5);
    piece.pieces_least = piece.pieces_most = piece.pieces;
    piece.cells = random_.UniformInt(6, 60);
    if (piece.pieces > 1) piece.cells = std::clamp(200 / piece.pieces, 5, piece.cells);
    if (random_.Chance(0.75)) piece.zones.push_back(DrawZone(kPieceZones));
    if (piece.pieces == 1 && piece.cells >= 16 && random_.Chance(0.3)) {
      constexpr ClaimShape kShapes[] = {ClaimShape::kRound, ClaimShape::kElongated,
                                        ClaimShape::kBent, ClaimShape::kRing};
      piece.shape = kShapes[random_.UniformInt(0, 3)];
    }
    if (piece.pieces >= 4 && random_.Chance(0.5)) piece.texture = Texture::kScattered;
    plan_.features.push_back(std::move(piece));
  }

  Waypoint DrawEnd() {
    Waypoint end;
    // A line may begin or end at a lake, a village, a wood: at one place, not along another line.
    if (random_.Chance(0.3)) {
      for (std::size_t i = 0; i < plan_.features.size(); ++i) {
        const PlannedFeature& at = plan_.features[i];
        if (at.form == FeatureForm::kPatch && at.pieces == 1 && random_.Chance(0.6)) {
          end.feature = static_cast<int>(i);
          return end;
        }
      }
    }
    end.zone = DrawZone(kEndZones);
    return end;
  }

  void AddLine() {
    PlannedFeature line;
    line.letter = Draw(palette_.lines);
    if (line.letter == plan_.background) return;
    line.form = FeatureForm::kLine;
    line.cells = 0;
    line.meander =
        line.letter == class_letter::kWater ? random_.UniformInt(1, 2) : random_.UniformInt(0, 2);
    line.wide = line.letter == class_letter::kWater && random_.Chance(0.2);
    if (random_.Chance(0.12)) {
      constexpr std::string_view kSides[] = {"northern edge", "southern edge", "western edge",
                                             "eastern edge"};
      line.along = DrawZone(kSides);
    } else {
      line.from = DrawEnd();
      line.to = DrawEnd();
      // Both ends at one place: the other one stays open.
      if (line.from->feature == line.to->feature && line.from->zone == line.to->zone)
        line.to.reset();
      if (random_.Chance(0.2)) line.via.push_back({DrawZone(kPieceZones), -1, true});
    }
    if (line.meander == 2 && random_.Chance(0.3)) line.shape = ClaimShape::kWinding;
    if (line.meander == 0 && random_.Chance(0.3)) line.shape = ClaimShape::kStraight;
    plan_.features.push_back(std::move(line));
  }

  // Ties two features of different classes; a draw that makes no sense ties nothing.
  void AddRelation() {
    const int count = static_cast<int>(plan_.features.size());
    if (count < 2) return;
    PlannedRelation relation;
    relation.subject = random_.UniformInt(0, count - 1);
    relation.object = random_.UniformInt(0, count - 1);
    const PlannedFeature& subject = plan_.features[static_cast<std::size_t>(relation.subject)];
    const PlannedFeature& object = plan_.features[static_cast<std::size_t>(relation.object)];
    if (relation.subject == relation.object || subject.letter == object.letter) return;
    const bool line = subject.form == FeatureForm::kLine;
    const bool to_line = object.form == FeatureForm::kLine;
    std::vector<RelationKind> kinds;
    if (line && to_line) {
      kinds = {RelationKind::kCrosses, RelationKind::kParallel};
    } else if (line) {
      kinds = {RelationKind::kThrough, RelationKind::kAlong};
    } else if (to_line) {
      kinds = {RelationKind::kBothSides, RelationKind::kAlong, RelationKind::kNear,
               RelationKind::kAdjacent};
    } else {
      kinds = {RelationKind::kAdjacent,  RelationKind::kNear,   RelationKind::kApart,
               RelationKind::kDirection, RelationKind::kWithin, RelationKind::kSurrounds,
               RelationKind::kMoreThan};
    }
    relation.kind =
        kinds[static_cast<std::size_t>(random_.UniformInt(0, static_cast<int>(kinds.size()) - 1))];
    if (relation.kind == RelationKind::kWithin && subject.form != FeatureForm::kPatch) return;
    if (relation.kind == RelationKind::kSurrounds && object.form != FeatureForm::kPatch) return;
    if (relation.kind == RelationKind::kDirection) {
      constexpr Claim::Heading kHeadings[] = {{0, 1}, {0, -1}, {1, 0},  {-1, 0},
                                              {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
      relation.heading = kHeadings[random_.UniformInt(0, 7)];
      // What has places of its own already lies somewhere.
      if (!subject.zones.empty() && !object.zones.empty()) return;
    }
    plan_.relations.push_back(std::move(relation));
  }

  void AddAbsence() {
    std::vector<char> unused;
    for (const LayoutClass& entry : ClassesOf(plan_.vocabulary)) {
      if (!Uses(entry.letter)) unused.push_back(entry.letter);
    }
    if (unused.empty()) return;
    plan_.absences.push_back({unused[static_cast<std::size_t>(
                                  random_.UniformInt(0, static_cast<int>(unused.size()) - 1))],
                              Zone(), ""});
  }

  RandomStream& random_;
  const Palette palette_;
  LayoutPlan plan_;
};

}  // namespace

LayoutPlan RandomPlan(Vocabulary vocabulary, RandomStream* random) {
  return PlanMaker(vocabulary, random).Make();
}

}  // namespace latticeworld
