#ifndef LATTICEWORLD_SENSING_SENSOR_RULES_H_
#define LATTICEWORLD_SENSING_SENSOR_RULES_H_

#include <string>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/sensing/sensor_suite.h"

namespace latticeworld {

// Each adds what is wrong between values of which each is legal by itself; pointers begin with
// `pointer`.

// Rings that are not in order, ranges the wrong way round, more beams than kMaxBeams.
void CheckLidar(const LidarModel& model, const std::string& pointer,
                std::vector<Violation>* violations);
// near_m beyond far_m, a distortion that folds within the picture.
void CheckCamera(const CameraModel& model, const std::string& pointer,
                 std::vector<Violation>* violations);
// A name that a robot's other topics or frames have.
void CheckSensorName(const std::string& name, const std::string& pointer,
                     std::vector<Violation>* violations);
// A lidar in a sensor: too many beams, a revolution too long for its points' times or too short for
// the delays between its rings.
void CheckLidarSensor(const SensorSpec& spec, const std::string& pointer,
                      std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_SENSING_SENSOR_RULES_H_
