#ifndef LATTICEWORLD_CAMPAIGN_REPORTS_WORLD_SECTION_H_
#define LATTICEWORLD_CAMPAIGN_REPORTS_WORLD_SECTION_H_

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "latticeworld/campaign/campaign.h"
#include "latticeworld/common/status.h"

namespace latticeworld {

// The worlds of `worlds:`, one for each seed of an entry. Violations: as ParseCampaign.
std::vector<CampaignWorld> ReadWorldSection(const YAML::Node& node,
                                            const std::filesystem::path& folder,
                                            std::vector<Violation>* violations);

// [1, 2, 5] or {from: 1, to: 20}; empty where it is neither, with violations.
std::vector<std::uint64_t> ReadSeeds(const YAML::Node& node, const std::string& path,
                                     std::vector<Violation>* violations);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_REPORTS_WORLD_SECTION_H_
