#ifndef LATTICEWORLD_GEOMORPHOLOGY_REALISM_FIT_H_
#define LATTICEWORLD_GEOMORPHOLOGY_REALISM_FIT_H_

#include <vector>

#include "latticeworld/geomorphology/realism.h"

namespace latticeworld {

// Slope of the line through the points: the median of the slopes of all pairs (Theil 1950, Sen
// 1968), which up to 29 % of bad points do not carry off. Its standard error is that of least
// squares with the residuals' spread taken from their median absolute deviation. x, y: of one
// length. NaN for fewer than four points or when all x are one.
RealismEstimate FitSlope(const std::vector<double>& x, const std::vector<double>& y);

// Sums of samples by half octaves of a positive key.
class HalfOctaves {
 public:
  struct Bin {
    int count = 0;
    double log_key = 0.0;  // sum of weight * ln(key)
    double value = 0.0;    // sum of what was added
    double weight = 0.0;   // sum of the weights
  };

  // Keys below `low` are refused: the first bin is [low, sqrt(2) * low).
  explicit HalfOctaves(double low) : low_(low) {}

  void Add(double key, double value, double weight);
  const std::vector<Bin>& bins() const { return bins_; }

 private:
  double low_;
  std::vector<Bin> bins_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_GEOMORPHOLOGY_REALISM_FIT_H_
