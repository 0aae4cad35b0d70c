#ifndef LATTICEWORLD_TOOLS_COMMANDS_CAMPAIGN_COMMAND_H_
#define LATTICEWORLD_TOOLS_COMMANDS_CAMPAIGN_COMMAND_H_

namespace CLI {
class App;
}

namespace latticeworld::tools {

// `latticeworld campaign`: runs the trials of a campaign's file and reports them.
void AddCampaignCommand(CLI::App* app, int* exit_status);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_COMMANDS_CAMPAIGN_COMMAND_H_
