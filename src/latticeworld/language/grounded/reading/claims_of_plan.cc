#include "latticeworld/language/grounded/reading/claims_of_plan.h"

#include <algorithm>
#include <string>
#include <utility>

namespace latticeworld {
namespace {

constexpr double kSpreadShare = 0.2;  // of a zone, that what spreads is said to lie in
constexpr double kLineShare = 0.008;  // of the same for a line
constexpr double kSpotShare = 0.004;  // of the whole map, for what is small
constexpr int kSpotCells = 12;        // which is below this size

bool SameClaim(const Claim& a, const Claim& b) {
  return a.kind == b.kind && a.subject == b.subject && a.object == b.object &&
         a.second_object == b.second_object && a.zone == b.zone && a.object_zone == b.object_zone &&
         a.from == b.from && a.to == b.to && a.sequence == b.sequence && a.heading == b.heading &&
         a.least == b.least && a.most == b.most && a.shape == b.shape;
}

bool IsLine(const PlannedFeature& feature) { return feature.form == FeatureForm::kLine; }

class ClaimMaker {
 public:
  explicit ClaimMaker(const LayoutPlan& plan) : plan_(plan) {}

  std::vector<Claim> Make() {
    for (const PlannedFeature& feature : plan_.features)
      if (!feature.supposed) ClaimFeature(feature);
    for (const PlannedFeature& feature : plan_.features) ClaimCount(feature);
    for (const PlannedRelation& relation : plan_.relations) ClaimRelation(relation);
    for (const PlannedOrder& order : plan_.orders) ClaimOrder(order);
    for (const PlannedAbsence& absence : plan_.absences) {
      Claim claim = Of(ClaimKind::kAbsent, absence.letter, absence.words);
      claim.zone = absence.zone;
      Add(std::move(claim));
    }
    return std::move(claims_);
  }

 private:
  static Claim Of(ClaimKind kind, char subject, const std::string& words) {
    Claim claim;
    claim.kind = kind;
    claim.subject = subject;
    claim.words = words;
    return claim;
  }
  void Add(Claim claim) {
    const bool known = std::any_of(claims_.begin(), claims_.end(),
                                   [&](const Claim& other) { return SameClaim(other, claim); });
    if (!known) claims_.push_back(std::move(claim));
  }
  const PlannedFeature& At(int index) const {
    return plan_.features[static_cast<std::size_t>(index)];
  }
  int FeaturesOf(char letter) const {
    return static_cast<int>(std::count_if(
        plan_.features.begin(), plan_.features.end(),
        [&](const PlannedFeature& other) { return other.letter == letter && !other.supposed; }));
  }
  bool IsAlone(const PlannedFeature& feature) const { return FeaturesOf(feature.letter) == 1; }
  // The relation makes the feature only what lies around another: a ring, an island.
  bool HasRelation(const PlannedFeature& feature, RelationKind kind) const {
    return std::any_of(plan_.relations.begin(), plan_.relations.end(),
                       [&](const PlannedRelation& relation) {
                         return relation.kind == kind && &At(relation.subject) == &feature;
                       });
  }

  void ClaimFeature(const PlannedFeature& feature) {
    if (IsLine(feature)) ClaimCourse(feature);
    ClaimPresence(feature);
    ClaimExtent(feature);
    if (feature.texture == Texture::kScattered && !IsLine(feature) &&
        (feature.pieces_least == 0 || feature.pieces > 4)) {
      Add(Of(ClaimKind::kScattered, feature.letter, feature.words));
    }
    if (feature.texture == Texture::kClustered && IsAlone(feature)) {
      Add(Of(ClaimKind::kClustered, feature.letter, feature.words));
    }
    const bool whole = feature.shape == ClaimShape::kRing || feature.shape == ClaimShape::kGridded;
    if (feature.shape.has_value() && (IsAlone(feature) || (whole && IsLine(feature))) &&
        feature.pieces <= 1) {
      Claim claim = Of(ClaimKind::kShape, feature.letter, feature.words);
      claim.shape = *feature.shape;
      Add(std::move(claim));
    }
    if (feature.confined && !feature.zones.empty()) {
      Claim claim = Of(ClaimKind::kLocated, feature.letter, feature.words);
      claim.zone = Union(feature.zones);
      claim.least = 0.9;
      Add(std::move(claim));
    } else if (feature.located_least > 0.0) {
      Claim claim = Of(ClaimKind::kLocated, feature.letter, feature.words);
      claim.zone = feature.located_in;
      claim.least = feature.located_least;
      Add(std::move(claim));
    }
    if (feature.gap > 0.0) {
      Claim claim = Of(ClaimKind::kApart, feature.letter, feature.words);
      claim.object = feature.letter;
      claim.least = feature.gap;
      Add(std::move(claim));
    }
    if (feature.fills_rest) ClaimRest(feature);
  }

  static Zone Union(const std::vector<Zone>& zones) {
    Zone all = zones.front();
    for (std::size_t i = 1; i < zones.size(); ++i) {
      all.name += " and " + zones[i].name;
      all.boxes.insert(all.boxes.end(), zones[i].boxes.begin(), zones[i].boxes.end());
    }
    return all;
  }

  void ClaimPresence(const PlannedFeature& feature) {
    if (feature.zones.empty()) {
      const auto placed = [](const std::optional<Waypoint>& end) {
        return end.has_value() && end->said;
      };
      const bool runs = placed(feature.from) || placed(feature.to) || feature.along.has_value();
      const bool said_more = (IsLine(feature) && runs) || feature.dominant || feature.fills_rest ||
                             feature.share.has_value();
      if (said_more) return;
      Claim claim = Of(ClaimKind::kPresent, feature.letter, feature.words);
      if (IsLine(feature)) claim.least = kLineShare;
      if (!IsLine(feature) && feature.cells * std::max(1, feature.pieces) < kSpotCells) {
        claim.least = kSpotShare;
      }
      Add(std::move(claim));
      return;
    }
    // "hardly any forest in the east"
    if (feature.share_of_zones && feature.share_least == 0.0) return;
    for (const Zone& zone : feature.zones) {
      Claim claim = Of(ClaimKind::kPresent, feature.letter, feature.words);
      claim.zone = zone;
      const bool little = feature.share_most.has_value() && *feature.share_most <= 0.25;
      if (IsLine(feature)) {
        claim.least = kLineShare;
      } else if (feature.form == FeatureForm::kSpread && !little && !feature.dominant &&
                 feature.texture != Texture::kScattered && feature.zones.size() <= 4) {
        claim.least = kSpreadShare;
      } else if (feature.cells < kSpotCells || little) {
        claim.least = kSpotShare;
      }
      Add(std::move(claim));
    }
  }

  void ClaimExtent(const PlannedFeature& feature) {
    std::vector<Zone> zones = feature.zones;
    if (zones.empty()) zones.push_back(Zone());
    if (feature.dominant) {
      for (const Zone& zone : zones) {
        Claim claim = Of(ClaimKind::kDominant, feature.letter, feature.words);
        claim.zone = zone;
        Add(std::move(claim));
      }
    }
    if (!feature.share_least.has_value() && !feature.share_most.has_value()) return;
    // "the northern half is forest", "half of the north is forest" are said of the place, any other
    // number of the whole map.
    const bool of_zone = feature.share_of_zones && zones.size() == 1;
    const bool of_map = !of_zone && (!feature.dominant || feature.share.has_value());
    Claim claim = Of(ClaimKind::kAmount, feature.letter, feature.words);
    claim.zone = of_map || zones.size() > 1 ? Zone() : zones.front();
    if (feature.share_least.has_value()) claim.least = *feature.share_least;
    if (feature.share_most.has_value() && *feature.share_most < 1.0) {
      const bool total = std::all_of(
          plan_.features.begin(), plan_.features.end(), [&](const PlannedFeature& other) {
            return &other == &feature || other.letter != feature.letter ||
                   (of_zone && IsElsewhere(other, zones.front())) ||
                   (other.zones.empty() && other.pieces_least == 0 && !IsLine(other) &&
                    !other.share.has_value() && feature.zones.empty());
          });
      if (total) claim.most = *feature.share_most;
    }
    if (claim.least != Claim::kUnsaid || claim.most != Claim::kUnsaid) Add(std::move(claim));
  }

  // Placed somewhere, and nowhere in the zone.
  static bool IsElsewhere(const PlannedFeature& feature, const Zone& place) {
    const LayoutMask there = MaskOf(place);
    return !feature.zones.empty() &&
           std::all_of(feature.zones.begin(), feature.zones.end(),
                       [&](const Zone& zone) { return (MaskOf(zone) & there).empty(); });
  }

  // Pieces of one class cannot be told apart: they are counted where all that is asked of the
  // class is countable.
  void ClaimCount(const PlannedFeature& feature) {
    if (feature.pieces_least == 0) return;
    int least = 0;
    int most = 0;
    bool bounded = true;
    std::string words;
    for (const PlannedFeature& other : plan_.features) {
      if (other.letter != feature.letter) continue;
      const bool mixed = IsLine(other) != IsLine(feature) || other.pieces_least == 0 ||
                         other.form == FeatureForm::kSpread || other.fills_rest || other.dominant;
      if (mixed) return;
      least += other.pieces_least;
      most += other.pieces_most;
      bounded = bounded && other.pieces_most > 0;
      if (words.empty()) words = other.words;
    }
    if (feature.letter == plan_.background) return;
    for (const PlannedRelation& relation : plan_.relations) {
      const bool joins = relation.kind == RelationKind::kCrosses &&
                         At(relation.subject).letter == feature.letter &&
                         At(relation.object).letter == feature.letter;
      // A line that another one cuts falls into parts.
      const bool parts = IsLine(feature) && relation.kind == RelationKind::kCrosses &&
                         At(relation.object).letter == feature.letter;
      if (joins || parts) return;
    }
    Claim claim = Of(ClaimKind::kCount, feature.letter, words);
    claim.least = least;
    if (bounded) claim.most = most;
    Add(std::move(claim));
    ClaimCountThere(feature);
  }

  // "five in the southern half, one in the northern": each number where it was said, where no two
  // of them overlap.
  void ClaimCountThere(const PlannedFeature& feature) {
    if (IsLine(feature) || IsAlone(feature) || feature.zones.size() != 1) return;
    const LayoutMask own = MaskOf(feature.zones.front());
    for (const PlannedFeature& other : plan_.features) {
      if (&other == &feature || other.letter != feature.letter) continue;
      if (other.zones.size() != 1) return;
      if (!(MaskOf(other.zones.front()) & own).empty()) return;
    }
    Claim claim = Of(ClaimKind::kCount, feature.letter, feature.words);
    claim.zone = feature.zones.front();
    claim.least = feature.pieces_least;
    if (feature.pieces_most > 0) claim.most = feature.pieces_most;
    Add(std::move(claim));
  }

  void ClaimRest(const PlannedFeature& feature) {
    Claim claim = Of(ClaimKind::kRest, feature.letter, feature.words);
    for (const PlannedFeature& other : plan_.features) {
      const bool shares = other.fills_rest && other.letter != feature.letter;
      // The rest is two things: neither is nearly all of it.
      if (shares) {
        if (feature.zones.empty()) Add(Of(ClaimKind::kPresent, feature.letter, feature.words));
        return;
      }
      if (other.letter != feature.letter &&
          claim.sequence.find(other.letter) == std::string::npos) {
        claim.sequence += other.letter;
      }
    }
    Add(std::move(claim));
  }

  void ClaimCourse(const PlannedFeature& feature) {
    if (feature.along.has_value()) {
      Claim claim = Of(ClaimKind::kAlong, feature.letter, feature.words);
      claim.zone = *feature.along;
      Add(std::move(claim));
    }
    const auto zone_of = [&](const std::optional<Waypoint>& end) -> std::optional<Zone> {
      if (!end.has_value() || !end->said) return std::nullopt;
      if (end->feature < 0) return end->zone;
      const PlannedFeature& at = At(end->feature);
      // The arm of a river comes from where the river comes from.
      if (IsLine(at) && at.letter == feature.letter && at.from.has_value() && at.from->said &&
          at.from->feature < 0) {
        return at.from->zone;
      }
      if (at.zones.size() != 1 || IsLine(at)) return std::nullopt;
      return at.zones.front();
    };
    const std::optional<Zone> from = zone_of(feature.from);
    const std::optional<Zone> to = zone_of(feature.to);
    if (from.has_value() && to.has_value()) {
      Claim claim = Of(ClaimKind::kCourse, feature.letter, feature.words);
      claim.from = *from;
      claim.to = *to;
      Add(std::move(claim));
    } else if (from.has_value() || to.has_value()) {
      Claim claim = Of(ClaimKind::kPresent, feature.letter, feature.words);
      claim.zone = from.has_value() ? *from : *to;
      claim.least = kLineShare;
      if (!claim.zone.is_anywhere()) Add(std::move(claim));
    }
    for (const Waypoint& via : feature.via) {
      if (via.feature >= 0 || via.zone.is_anywhere()) continue;
      Claim claim = Of(ClaimKind::kPresent, feature.letter, feature.words);
      claim.zone = via.zone;
      claim.least = kLineShare;
      Add(std::move(claim));
    }
  }

  void ClaimOrder(const PlannedOrder& order) {
    Claim claim = Of(ClaimKind::kOrder, '?', order.words);
    const std::vector<int>& features = order.features;
    for (std::size_t first = 0, next = 0; first < features.size(); first = next) {
      const char letter = At(features[first]).letter;
      while (next < features.size() && At(features[next]).letter == letter) ++next;
      // A class that comes again later, or elsewhere too, has no one place in the order.
      if (FeaturesOf(letter) == static_cast<int>(next - first)) claim.sequence += letter;
    }
    if (claim.sequence.size() < 2) return;
    claim.subject = claim.sequence.front();
    claim.heading = order.heading;
    Add(std::move(claim));
  }

  // One of several features of a class is told from the others by its place, if it has one.
  bool Tell(const PlannedFeature& feature, Zone* zone) const {
    if (IsAlone(feature)) return true;
    if (IsLine(feature) || feature.zones.size() != 1) return false;
    for (const PlannedFeature& other : plan_.features) {
      if (&other == &feature || other.letter != feature.letter) continue;
      if (other.zones.empty() || IsLine(other)) return false;
      for (const Zone& there : other.zones) {
        if (RegionOf(there) == RegionOf(feature.zones.front())) return false;
      }
    }
    *zone = feature.zones.front();
    return true;
  }

  // Whether all features of the subject's class are tied to the object in the same way.
  bool AllOfClass(const PlannedRelation& relation) const {
    int tied = 0;
    for (const PlannedRelation& other : plan_.relations) {
      const bool same = other.kind == relation.kind && other.object == relation.object &&
                        other.heading == relation.heading &&
                        At(other.subject).letter == At(relation.subject).letter;
      if (same) ++tied;
    }
    return tied == FeaturesOf(At(relation.subject).letter);
  }

  void ClaimRelation(const PlannedRelation& relation) {
    const PlannedFeature& subject = At(relation.subject);
    const PlannedFeature& object = At(relation.object);
    Claim claim = Of(KindOf(relation.kind), subject.letter, relation.words);
    claim.object = object.letter;
    if (relation.second_object >= 0) claim.second_object = At(relation.second_object).letter;
    const bool same = subject.letter == object.letter;
    switch (relation.kind) {
      case RelationKind::kBetween:
        if (same || subject.letter == claim.second_object) return;
        if (object.letter == claim.second_object && relation.object != relation.second_object &&
            FeaturesOf(object.letter) > 2) {
          return;
        }
        Add(std::move(claim));
        return;
      case RelationKind::kConnects:
        if (same || subject.letter == claim.second_object) return;
        Add(std::move(claim));
        return;
      case RelationKind::kCrosses:
      case RelationKind::kParallel:
        Add(std::move(claim));
        return;
      case RelationKind::kMoreThan:
        if (!same) Add(std::move(claim));
        return;
      default:
        break;
    }
    if (same) return;
    // Which of them is meant counts for what must hold for all cells of a class.
    const bool for_all =
        relation.kind == RelationKind::kApart || relation.kind == RelationKind::kAlong;
    const bool told =
        (Tell(subject, &claim.zone) || AllOfClass(relation)) && Tell(object, &claim.object_zone);
    if (for_all && !told) return;
    if (!told) {
      claim.zone = Zone();
      claim.object_zone = Zone();
    }
    switch (relation.kind) {
      case RelationKind::kAdjacent:
      case RelationKind::kNear:
        claim.most = relation.steps > 0.0                       ? relation.steps
                     : relation.kind == RelationKind::kAdjacent ? 2.0
                                                                : 4.0;
        break;
      case RelationKind::kApart:
        claim.least = relation.steps > 0.0 ? relation.steps : 3.0;
        break;
      case RelationKind::kDirection:
        claim.heading = relation.heading;
        break;
      case RelationKind::kBothSides:
        // "fields north and south of the river"
        if (relation.heading.east != 0 || relation.heading.south != 0) {
          for (const int sign : {1, -1}) {
            Claim side = Of(ClaimKind::kDirection, subject.letter, relation.words);
            side.object = object.letter;
            side.heading = {sign * relation.heading.east, sign * relation.heading.south};
            Add(std::move(side));
          }
        }
        break;
      default:
        break;
    }
    Add(std::move(claim));
  }

  static ClaimKind KindOf(RelationKind kind) {
    switch (kind) {
      case RelationKind::kAdjacent:
      case RelationKind::kNear:
        return ClaimKind::kAdjacent;
      case RelationKind::kApart:
        return ClaimKind::kApart;
      case RelationKind::kSurrounds:
        return ClaimKind::kSurrounds;
      case RelationKind::kWithin:
        return ClaimKind::kWithin;
      case RelationKind::kBothSides:
        return ClaimKind::kBothSides;
      case RelationKind::kBetween:
        return ClaimKind::kBetween;
      case RelationKind::kDirection:
        return ClaimKind::kDirection;
      case RelationKind::kMoreThan:
        return ClaimKind::kMoreThan;
      case RelationKind::kAlong:
        return ClaimKind::kAlong;
      case RelationKind::kThrough:
        return ClaimKind::kThrough;
      case RelationKind::kCrosses:
        return ClaimKind::kCrosses;
      case RelationKind::kParallel:
        return ClaimKind::kParallel;
      case RelationKind::kConnects:
        return ClaimKind::kConnects;
    }
    return ClaimKind::kPresent;
  }

  const LayoutPlan& plan_;
  std::vector<Claim> claims_;
};

}  // namespace

std::vector<Claim> ClaimsOfPlan(const LayoutPlan& plan) { return ClaimMaker(plan).Make(); }

}  // namespace latticeworld
