#include "latticeworld/language/grounded/synthesis/piece_wishes.h"

#include <algorithm>
#include <cmath>

#include "latticeworld/language/grounded/synthesis/canvas.h"

namespace latticeworld {
namespace {

constexpr int kMaxPieces = 40;  // of one feature
constexpr double kPi = 3.14159265358979;

LayoutMask UnionOf(const std::vector<Zone>& zones) {
  if (zones.empty()) return LayoutMask::All();
  LayoutMask all;
  for (const Zone& zone : zones) all = all | MaskOf(zone);
  return all;
}

bool IsCompact(const PlannedFeature& feature) {
  return feature.form == FeatureForm::kPatch || feature.pieces > 0 ||
         feature.texture == Texture::kScattered || feature.shape.has_value();
}

class Wisher {
 public:
  Wisher(const LayoutPlan& plan, RandomStream* random) : plan_(plan), random_(random) {}

  std::vector<PieceWish> Run() {
    for (std::size_t i = 0; i < plan_.features.size(); ++i) {
      const PlannedFeature& feature = plan_.features[i];
      if (feature.form == FeatureForm::kLine || feature.fills_rest) continue;
      if (IsCompact(feature) || LiesWithin(static_cast<int>(i))) {
        AddCompact(static_cast<int>(i));
      } else {
        AddSpread(static_cast<int>(i));
      }
    }
    ShareOpenLand();
    MakeRoomForInnerPieces();
    for (PieceWish& wish : wishes_) {
      wish.cells = std::clamp(wish.cells, 1, kCellCount);
      wish.radius = std::sqrt(wish.cells / kPi);
    }
    return std::move(wishes_);
  }

 private:
  // The whole feature's cells, within what the amount claims of its letter allow.
  double Bounded(const PlannedFeature& feature, double cells) const {
    for (const PlannedFeature& other : plan_.features) {
      if (&other != &feature && other.letter == feature.letter) return cells;
    }
    const LayoutMask zone = UnionOf(feature.zones);
    for (const Claim& claim : plan_.claims) {
      if (claim.subject != feature.letter) continue;
      if (claim.kind != ClaimKind::kAmount && claim.kind != ClaimKind::kPresent) continue;
      const LayoutMask claimed = MaskOf(claim.zone);
      const double room = claimed.count();
      if (!claim.zone.is_anywhere() && !(claimed == zone)) continue;
      const double least = claim.least == Claim::kUnsaid ? 0.0 : claim.least;
      const double most = claim.most == Claim::kUnsaid ? 1.0 : claim.most;
      const double margin = std::min(0.02, 0.2 * (most - least));
      cells = std::clamp(cells, (least + margin) * room,
                         std::max((least + margin) * room, (most - margin) * room));
    }
    return cells;
  }

  // A clearing in a wood is a piece of its own, whatever it is of.
  bool LiesWithin(int feature) const {
    return !plan_.features[static_cast<std::size_t>(feature)].share &&
           std::any_of(
               plan_.relations.begin(), plan_.relations.end(),
               [&](const PlannedRelation& relation) {
                 return (relation.kind == RelationKind::kWithin && relation.subject == feature) ||
                        (relation.kind == RelationKind::kSurrounds && relation.object == feature);
               });
  }

  bool FollowsLine(int feature) const {
    return std::any_of(plan_.relations.begin(), plan_.relations.end(),
                       [&](const PlannedRelation& relation) {
                         return relation.subject == feature && relation.object >= 0 &&
                                (relation.kind == RelationKind::kBothSides ||
                                 (relation.kind == RelationKind::kAlong &&
                                  plan_.features[static_cast<std::size_t>(relation.object)].form ==
                                      FeatureForm::kLine));
                       });
  }

  bool IsTwoSided(int feature) const {
    return std::any_of(
        plan_.relations.begin(), plan_.relations.end(), [&](const PlannedRelation& relation) {
          return relation.subject == feature && relation.kind == RelationKind::kBothSides;
        });
  }

  void AddCompact(int index) {
    const PlannedFeature& feature = plan_.features[static_cast<std::size_t>(index)];
    const int zones = static_cast<int>(feature.zones.size());
    const bool late = FollowsLine(index);
    int pieces = std::max(feature.pieces, 1);
    double each = feature.cells;
    if (feature.texture == Texture::kScattered) {
      if (feature.pieces == 0) pieces = random_->UniformInt(6, 9);
      each = std::min(each, feature.form == FeatureForm::kSpread ? 9.0 : 6.0);
    } else if (feature.pieces == 0) {
      pieces = std::max(pieces, zones);
      if (late) pieces = std::max(pieces, IsTwoSided(index) ? 4 : 3);
      if (late && pieces > 1) each = std::min(each, 8.0);
    }
    pieces = std::min(pieces, kMaxPieces);
    LayoutMask all = UnionOf(feature.zones);
    if (all.empty()) all = LayoutMask::All();
    double total = each * pieces;
    if (feature.share) {
      total = *feature.share * all.count();
    } else {
      // Many pieces must find room.
      total = std::min(total, 0.45 * all.count());
    }
    total = Bounded(feature, total);
    for (int piece = 0; piece < pieces; ++piece) {
      PieceWish wish;
      wish.feature = index;
      wish.zoned = zones > 0;
      wish.zone = zones > 0 && feature.texture != Texture::kScattered
                      ? MaskOf(feature.zones[static_cast<std::size_t>(piece % zones)])
                      : all;
      if (wish.zone.empty()) wish.zone = LayoutMask::All();
      wish.late = late;
      const double vary = feature.share || pieces == 1 ? 1.0 : random_->Uniform(0.75, 1.25);
      wish.cells = std::max(2, static_cast<int>(std::lround(total / pieces * vary)));
      wishes_.push_back(wish);
    }
  }

  // Whether nothing ties the feature to another, nor says how many pieces there are.
  bool IsFree(int index) const {
    const PlannedFeature& feature = plan_.features[static_cast<std::size_t>(index)];
    if (feature.texture == Texture::kClustered) return false;
    for (const PlannedRelation& relation : plan_.relations) {
      if (relation.kind == RelationKind::kMoreThan) continue;
      if (relation.subject == index || relation.object == index ||
          relation.second_object == index) {
        return false;
      }
    }
    return std::none_of(plan_.claims.begin(), plan_.claims.end(), [&](const Claim& claim) {
      return claim.subject == feature.letter &&
             (claim.kind == ClaimKind::kCount || claim.kind == ClaimKind::kClustered ||
              claim.kind == ClaimKind::kShape);
    });
  }

  // How much of the zone others, who say that they lie there, want as well.
  double RivalsIn(int index, const LayoutMask& zone, bool* dominated) const {
    const PlannedFeature& feature = plan_.features[static_cast<std::size_t>(index)];
    double rivals = 0.0;
    for (const PlannedFeature& other : plan_.features) {
      if (&other == &feature || other.letter == feature.letter || other.zones.empty()) continue;
      if (other.form == FeatureForm::kLine || IsCompact(other)) continue;
      const double overlap = (UnionOf(other.zones) & zone).count();
      rivals += overlap / zone.count();
      if (other.dominant && overlap > 0.3 * zone.count()) *dominated = true;
    }
    return rivals;
  }

  void AddSpread(int index) {
    const PlannedFeature& feature = plan_.features[static_cast<std::size_t>(index)];
    if (feature.zones.empty()) {
      if (feature.letter == plan_.background && !feature.share) return;
      PieceWish wish;
      wish.feature = index;
      wish.zone = LayoutMask::All();
      wish.spread = true;
      wish.late = FollowsLine(index);
      if (feature.share) {
        wish.cells = static_cast<int>(*feature.share * kCellCount);
      } else if (feature.dominant) {
        wish.cells = static_cast<int>(0.62 * kCellCount);
      } else {
        wish.cells = 0;  // ShareOpenLand
      }
      if (wish.cells > 0) wish.cells = static_cast<int>(Bounded(feature, wish.cells));
      wishes_.push_back(wish);
      // Woods of which nothing is said but that they are there lie here and there.
      if (wish.cells == 0 && IsFree(index) && random_->Chance(0.5)) wishes_.push_back(wish);
      return;
    }
    for (const Zone& zone : feature.zones) {
      PieceWish wish;
      wish.feature = index;
      wish.zone = MaskOf(zone);
      if (wish.zone.empty()) continue;
      wish.zoned = true;
      wish.spread = true;
      wish.late = FollowsLine(index);
      bool dominated = false;
      const double rivals = RivalsIn(index, wish.zone, &dominated);
      double share = 0.75 / (1.0 + rivals);
      if (feature.dominant) share = rivals > 0.0 ? 0.62 : 0.85;
      if (!feature.dominant && dominated) share = 0.22 / std::max(1.0, rivals);
      if (feature.share) share = *feature.share;
      const double cells = share * wish.zone.count();
      wish.cells = static_cast<int>(feature.zones.size() == 1 ? Bounded(feature, cells) : cells);
      wishes_.push_back(wish);
    }
  }

  // What shall hold another thing must be larger than it.
  void MakeRoomForInnerPieces() {
    for (const PlannedRelation& relation : plan_.relations) {
      int inner = -1;
      int outer = -1;
      if (relation.kind == RelationKind::kWithin) {
        inner = relation.subject;
        outer = relation.object;
      } else if (relation.kind == RelationKind::kSurrounds) {
        inner = relation.object;
        outer = relation.subject;
      }
      if (inner < 0 || outer < 0) continue;
      double needed = 0.0;
      for (const PieceWish& wish : wishes_) {
        if (wish.feature != inner) continue;
        const double radius = std::sqrt(wish.cells / kPi) + 3.0;
        needed += kPi * radius * radius - wish.cells;
      }
      for (PieceWish& wish : wishes_) {
        if (wish.feature != outer) continue;
        if (plan_.features[static_cast<std::size_t>(outer)].share) break;
        wish.cells = std::max(wish.cells, static_cast<int>(needed));
        break;
      }
    }
  }

  // Spreads of which neither place nor size is said share what the others leave.
  void ShareOpenLand() {
    double taken = 0.0;
    int open = 0;
    for (const PieceWish& wish : wishes_) {
      taken += wish.cells;
      open += wish.cells == 0 ? 1 : 0;
    }
    const double left = std::max(0.1, 1.0 - taken / kCellCount);
    for (PieceWish& wish : wishes_) {
      const PlannedFeature& feature = plan_.features[static_cast<std::size_t>(wish.feature)];
      if (wish.cells > 0) continue;
      const double share = std::min(0.28, 0.8 * left / (open + 1)) * random_->Uniform(0.85, 1.15);
      wish.cells = std::max(1, static_cast<int>(Bounded(feature, share * kCellCount)));
    }
  }

  const LayoutPlan& plan_;
  RandomStream* random_;
  std::vector<PieceWish> wishes_;
};

}  // namespace

std::vector<PieceWish> PieceWishesOf(const LayoutPlan& plan, RandomStream* random) {
  return Wisher(plan, random).Run();
}

}  // namespace latticeworld
