#ifndef LATTICEWORLD_ROS_CONVERSION_MESSAGES_H_
#define LATTICEWORLD_ROS_CONVERSION_MESSAGES_H_

// The package's own messages and services, in the namespace latticeworld_msgs. gencpp puts them
// into a namespace named as the package, where Status, AgentState and StageTime would meet the
// core's; on the wire nothing differs, for names there are string literals. Include this header,
// never a generated one.

#define latticeworld latticeworld_msgs
#include <latticeworld/AgentEvent.h>
#include <latticeworld/AgentState.h>
#include <latticeworld/AgentStates.h>
#include <latticeworld/Bumper.h>
#include <latticeworld/ClaimOutcome.h>
#include <latticeworld/ElementState.h>
#include <latticeworld/ElementStates.h>
#include <latticeworld/Environment.h>
#include <latticeworld/Episode.h>
#include <latticeworld/EpisodeEnd.h>
#include <latticeworld/EpisodeStart.h>
#include <latticeworld/EpisodeStatus.h>
#include <latticeworld/FelledTree.h>
#include <latticeworld/GenerateWorld.h>
#include <latticeworld/GenerateWorldTaskAction.h>
#include <latticeworld/GenerationProgress.h>
#include <latticeworld/GetWorld.h>
#include <latticeworld/GetWorldBundle.h>
#include <latticeworld/JournalEntry.h>
#include <latticeworld/Layout.h>
#include <latticeworld/ListEpisodes.h>
#include <latticeworld/ListWorlds.h>
#include <latticeworld/LoadWorld.h>
#include <latticeworld/OpenGate.h>
#include <latticeworld/QueryTerrain.h>
#include <latticeworld/Reading.h>
#include <latticeworld/RemoveAgent.h>
#include <latticeworld/RemoveElement.h>
#include <latticeworld/ResetWorld.h>
#include <latticeworld/RestoreSnapshot.h>
#include <latticeworld/SaveSnapshot.h>
#include <latticeworld/SaveWorld.h>
#include <latticeworld/SceneChanges.h>
#include <latticeworld/SetPolicy.h>
#include <latticeworld/SetRealTimeFactor.h>
#include <latticeworld/SetWeather.h>
#include <latticeworld/SpawnAgent.h>
#include <latticeworld/SpawnElement.h>
#include <latticeworld/StageTime.h>
#include <latticeworld/StartEpisode.h>
#include <latticeworld/StateHash.h>
#include <latticeworld/Status.h>
#include <latticeworld/Step.h>
#include <latticeworld/StopEpisode.h>
#include <latticeworld/TerrainSample.h>
#include <latticeworld/Weather.h>
#include <latticeworld/WorldBundle.h>
#include <latticeworld/WorldFile.h>
#include <latticeworld/WorldFiles.h>
#include <latticeworld/WorldInfo.h>
#undef latticeworld

#endif  // LATTICEWORLD_ROS_CONVERSION_MESSAGES_H_
