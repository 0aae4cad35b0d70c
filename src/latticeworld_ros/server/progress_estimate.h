#ifndef LATTICEWORLD_ROS_SERVER_PROGRESS_ESTIMATE_H_
#define LATTICEWORLD_ROS_SERVER_PROGRESS_ESTIMATE_H_

#include <string_view>

namespace latticeworld {

// Guesses how long a generation will still take [s] from where it is, each stage having its usual
// share of the whole. elapsed_s: since it began. -1 as long as too little is done to tell, or for a
// stage that is not known.
double EstimateTimeLeft(std::string_view stage, double fraction, double elapsed_s);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_SERVER_PROGRESS_ESTIMATE_H_
