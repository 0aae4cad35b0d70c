#ifndef LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SKELETON_ENERGY_H_
#define LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SKELETON_ENERGY_H_

#include <cstddef>
#include <utility>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/language/grounded/layout_plan.h"
#include "latticeworld/language/grounded/synthesis/canvas.h"
#include "latticeworld/language/grounded/synthesis/piece_wishes.h"
#include "latticeworld/language/grounded/synthesis/skeleton.h"
#include "latticeworld/relief/relief.h"

namespace latticeworld {

// How far a skeleton is from what its plan wants: the sum of what pieces miss of their zones and
// their room, lines of their course, and features of their relations, in cells, weighted.
class SkeletonEnergy {
 public:
  // skeleton: with all of its pieces and lines, looked at anew by each call. relief: or nullptr.
  // All of them outlive this.
  SkeletonEnergy(const LayoutPlan& plan, const std::vector<PieceWish>& wishes,
                 const ForbiddenCells& forbidden, const Relief* relief, const Skeleton& skeleton);

  double Now() const;
  // The middle of a feature's pieces, or of its line's stops; the map's middle where it has none.
  Spot PointOf(int feature) const;

 private:
  // What two features have with each other, as far as the room between them is concerned.
  enum class Tie { kNone, kTouch, kNear, kNested, kLoose };

  static std::size_t Index(int value) { return static_cast<std::size_t>(value); }
  const PlannedFeature& FeatureOf(int feature) const { return plan_.features[Index(feature)]; }

  void AddDepth(const PieceWish& wish);
  void NoteTie(const PlannedRelation& relation);
  void SetTie(int a, int b, Tie tie);

  bool HasPoint(int feature) const {
    return feature >= 0 && (!pieces_of_[Index(feature)].empty() || line_of_[Index(feature)] >= 0);
  }
  // Whether all that is of the claim's class is to lie on that one side.
  bool HasOneSide(const Claim& claim) const;
  // The middle of all that is of a letter; weight 0: nothing is.
  std::pair<Spot, double> LetterPoint(char letter) const;
  // Returns the radius of the largest of its pieces [cells]; 0: it has none.
  double RadiusOf(int feature) const;
  // Distance between the nearest rims of one piece of a and of all of b [cells].
  double GapFrom(int piece, int b) const;
  // The sum of cost(gap) over the pieces of one of them, or of two lines.
  template <typename Cost>
  double OverGaps(int a, int b, Cost cost) const;

  double PieceEnergy(std::size_t i) const;
  double PairEnergy() const;
  double LineEnergy(std::size_t index) const;
  // Rivers run from high to low ground.
  double ReliefEnergyOf(const SkeletonLine& line) const;
  double RelationEnergy(const PlannedRelation& relation) const;
  double DirectionEnergy(Spot subject, Spot object, Claim::Heading heading, double margin) const;
  // Each inner piece lies well inside some outer one.
  double NestedEnergy(int inner, int outer) const;
  double BetweenEnergy(const PlannedRelation& relation) const;
  double ClaimEnergy(const Claim& claim) const;

  const LayoutPlan& plan_;
  const std::vector<PieceWish>& wishes_;
  const ForbiddenCells& forbidden_;
  const Relief* relief_;
  const Skeleton& skeleton_;
  std::vector<LayoutMask> depth_masks_;
  std::vector<Grid<float>> depths_;
  std::vector<std::size_t> depth_of_;        // beside the wishes
  std::vector<std::vector<int>> pieces_of_;  // by feature, without late ones
  std::vector<int> line_of_;                 // by feature; -1: none
  std::vector<std::vector<Tie>> tied_;       // by feature and feature
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_GROUNDED_SYNTHESIS_SKELETON_ENERGY_H_
