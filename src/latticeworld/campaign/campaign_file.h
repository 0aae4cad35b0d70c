#ifndef LATTICEWORLD_CAMPAIGN_CAMPAIGN_FILE_H_
#define LATTICEWORLD_CAMPAIGN_CAMPAIGN_FILE_H_

#include <cstddef>
#include <filesystem>
#include <string>

#include "latticeworld/campaign/campaign.h"
#include "latticeworld/common/result.h"

namespace latticeworld {

inline constexpr std::size_t kMaxCampaignBytes = 4u << 20;

// A campaign from the text of its YAML file (docs/campaigns.md has the keys). folder: that relative
// paths of bundles begin at. Errors: INVALID_ARGUMENT with every violation: the line and key, what
// is there and what is legal; keys that are not known are among them. Whether bundles are whole,
// and whether worlds offer the tasks, shows when the campaign runs.
Result<Campaign> ParseCampaign(const std::string& text, const std::filesystem::path& folder);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_CAMPAIGN_FILE_H_
