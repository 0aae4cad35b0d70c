#ifndef LATTICEWORLD_TERRAIN_FORMS_RELIEF_CLAIM_LIST_H_
#define LATTICEWORLD_TERRAIN_FORMS_RELIEF_CLAIM_LIST_H_

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/terrain/forms/relief_claims.h"

namespace latticeworld::internal {

// "9.5 m", "120 m".
inline std::string Metres(double value) {
  const double rounded =
      std::abs(value) < 10.0 ? std::round(value * 10.0) / 10.0 : std::round(value);
  return FormatDouble(rounded + 0.0) + " m";
}
inline std::string Degrees(double value) {
  return FormatDouble(std::round(value * 10.0) / 10.0) + " degrees";
}
inline std::string Percent(double share) { return FormatDouble(std::round(100.0 * share)) + " %"; }

// Claims measured so far.
class ReliefClaimList {
 public:
  void Add(const char* kind, const std::string& words, bool holds, double distance,
           std::string explanation) {
    all_.push_back({kind, words, holds, holds ? 0.0 : std::clamp(distance, 0.02, 1.0),
                    std::move(explanation)});
  }

  // A measure that was said [m], and the share of it that it may be off.
  void AddAsked(const char* kind, const std::string& words, const std::string& what, double is_m,
                double asked_m, double room) {
    const double off = std::abs(is_m - asked_m) / std::max(asked_m, 0.1);
    Add(kind, words, off <= room || std::abs(is_m - asked_m) <= 0.5, off,
        what + "; " + Metres(asked_m) + " +- " + Percent(room) + " is asked");
  }

  std::vector<ReliefMeasure> Take() { return std::move(all_); }

 private:
  std::vector<ReliefMeasure> all_;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_TERRAIN_FORMS_RELIEF_CLAIM_LIST_H_
