#ifndef LATTICEWORLD_REFERENCE_NAVIGATOR_OBSTACLE_LAYER_H_
#define LATTICEWORLD_REFERENCE_NAVIGATOR_OBSTACLE_LAYER_H_

#include <cstdint>
#include <vector>

#include "latticeworld/geometry/grid.h"
#include "latticeworld/geometry/grid_geometry.h"
#include "latticeworld/reference_navigator/navigator.h"

namespace latticeworld {

// What the map says of the ground where a scan may meet it.
class GroundGuess {
 public:
  virtual ~GroundGuess() = default;
  // How much the ground may rise from one place to another at most, judged by the map [m].
  virtual double MostRise(WorldPoint from, WorldPoint to) const = 0;
};

// Obstacles that were seen around the robot: a square window of small cells that goes with it. A
// cell holds when it was last seen occupied; rays that pass over it free it again, and what was not
// seen for long is forgotten.
class ObstacleLayer {
 public:
  // Takes from the options the robot and what is said of what is seen; the window is local_size_m
  // wide or wider.
  explicit ObstacleLayer(const NavigatorOptions& options);

  double reach_m() const { return 0.5 * cells_ * cell_m_ - 0.5; }  // from the robot

  // The window's middle goes to the cell of the base; what it held stays where it was on the map.
  void MoveTo(const Eigen::Vector3d& base_m);
  // Sightings of before the first MoveTo are passed over. ground: of planar ones; may be null.
  void See(const SensorSighting& sighting, const GroundGuess* ground);
  void Forget();
  // Forgets what is older than the memory reaches; distances count from then on.
  void Settle(double time_s);

  // DistanceAt returns the distance from a place to the middle of the nearest cell that was
  // occupied at the last Settle [m]; infinity: none is within kFar_m, or the place is outside the
  // window.
  static constexpr double kFar_m = 2.0;
  double DistanceAt(WorldPoint point) const;
  WorldPoint middle() const { return {middle_m_.x(), middle_m_.y()}; }

 private:
  struct Hit {
    Eigen::Vector3d at_m;
    bool is_obstacle;
  };
  int Wrapped(int cell) const { return cell & (cells_ - 1); }
  CellIndex CellOf(double x_m, double y_m) const;
  bool IsInside(CellIndex cell) const;  // by cell numbers of the plane
  void JudgeByHeight(std::vector<Hit>* hits) const;
  void JudgeByPlane(const Eigen::Vector3d& sensor_m, const GroundGuess* ground,
                    std::vector<Hit>* hits) const;
  void DropLoneOnes(const Eigen::Vector3d& sensor_m, std::vector<Hit>* hits);
  void Clear(const SensorSighting& sighting, const std::vector<Hit>& hits);

  NavigatorRobot robot_;
  double cell_m_;
  int cells_;  // a side, a power of 2: numbers wrap by their last bits
  double memory_s_;
  bool is_placed_ = false;
  Eigen::Vector3d middle_m_ = Eigen::Vector3d::Zero();
  CellIndex corner_;         // number in the plane of the window's first cell (row: along y)
  Grid<double> seen_s_;      // by wrapped number; -infinity: free
  Grid<float> distance_m_;   // the same
  Grid<std::uint8_t> hits_;  // the same: of the sweep that is taken in, else 0
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_REFERENCE_NAVIGATOR_OBSTACLE_LAYER_H_
