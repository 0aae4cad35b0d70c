#ifndef LATTICEWORLD_TOOLS_DATASET_SOURCES_H_
#define LATTICEWORLD_TOOLS_DATASET_SOURCES_H_

#include <memory>

#include "latticeworld/common/result.h"
#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/dataset/sources/instance_source.h"

namespace CLI {
class App;
}

namespace latticeworld::tools {

// The options of `latticeworld dataset` that say where places come from and who writes.
void AddDatasetSourceOptions(CLI::App* command);

// Errors: INVALID_ARGUMENT naming every unusable option; those of the source.
Result<std::unique_ptr<InstanceSource>> MakeDatasetSource(const CLI::App& command);

// size_m: side of the world that environments are for. Errors: INVALID_ARGUMENT naming every
// unusable option.
Result<std::unique_ptr<Annotator>> MakeDatasetAnnotator(const CLI::App& command, double size_m);

}  // namespace latticeworld::tools

#endif  // LATTICEWORLD_TOOLS_DATASET_SOURCES_H_
