#ifndef LATTICEWORLD_SENSING_MOTION_WANDERING_BIAS_H_
#define LATTICEWORLD_SENSING_MOTION_WANDERING_BIAS_H_

#include <Eigen/Core>
#include <cstdint>

namespace latticeworld {

// A first-order Gauss-Markov process of three axes, sampled at a sensor's readings: stationary,
// with a standard deviation for each axis and a correlation time (IEEE Std 952-1997, annex B). Its
// values are functions of the key and the reading's number alone, whatever was asked for before:
// b(k+1) = phi b(k) + sqrt(1 - phi^2) n(k), phi = exp(-interval / correlation time).
class WanderingBias {
 public:
  // stddev >= 0; interval_s, correlation_s > 0.
  WanderingBias(std::uint64_t key, const Eigen::Vector3d& stddev, double interval_s,
                double correlation_s);

  // Returns the bias at reading k. The cost grows with how far k is from the k asked for before.
  Eigen::Vector3d At(std::uint64_t k);

 private:
  std::uint64_t key_;
  Eigen::Vector3d stddev_;
  double phi_, innovation_;
  std::uint64_t memory_;  // readings after which nothing of a value is left
  bool begun_ = false;
  std::uint64_t k_ = 0;
  Eigen::Vector3d unit_ = Eigen::Vector3d::Zero();  // at k_, standard deviation 1
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_MOTION_WANDERING_BIAS_H_
