#ifndef LATTICEWORLD_ROS_EPISODE_EPISODE_FILES_H_
#define LATTICEWORLD_ROS_EPISODE_EPISODE_FILES_H_

#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld_ros/conversion/messages.h"

namespace latticeworld {

// The episodes in a directory, by name: NAME.bag, or NAME.part0.bag, NAME.part1.bag and so on;
// ".active" after the name of one that is not whole. Nothing is opened. Empty where there is no
// directory.
std::vector<latticeworld_msgs::Episode> EpisodesIn(const std::filesystem::path& directory);
// The files of one.
std::vector<std::string> FilesOfEpisode(const std::filesystem::path& directory,
                                        const std::string& name);

}  // namespace latticeworld

#endif  // LATTICEWORLD_ROS_EPISODE_EPISODE_FILES_H_
