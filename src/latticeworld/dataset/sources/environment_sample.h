#ifndef LATTICEWORLD_DATASET_SOURCES_ENVIRONMENT_SAMPLE_H_
#define LATTICEWORLD_DATASET_SOURCES_ENVIRONMENT_SAMPLE_H_

#include <string>
#include <vector>

#include "latticeworld/common/random.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/layout/symbolic_layout.h"

namespace latticeworld {

// An environment, and which of its fine values are not the usual ones and so must be told.
struct SampledEnvironment {
  EnvironmentConfig environment;
  std::vector<std::string> told;  // keys of phrases: "fine.lake.material.silty"
};

// An environment for a layout. What does not depend on the land is drawn so that every value comes
// up: season, time of day, style, the agents' categories, states, numbers and places. What depends
// on it follows: the kind of land from the layout, the weather among those that season and land
// allow, agents where they can live (FitAgents: no whale without open water, no grazing without
// grass), fine values by the rules (DeriveFineAttributes), some of them drawn among the legal ones.
// Valid. size_m: side of the world.
SampledEnvironment SampleEnvironment(const SymbolicLayout& layout, double size_m,
                                     RandomStream* random);

// The weathers that common sense allows: snow falls in winter, and on mountains not in summer;
// sandstorms need dry open land and no winter.
std::vector<Weather> LikelyWeathers(const SymbolicLayout& layout, TerrainType terrain,
                                    Season season);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_SOURCES_ENVIRONMENT_SAMPLE_H_
