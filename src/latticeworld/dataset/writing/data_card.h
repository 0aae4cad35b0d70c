#ifndef LATTICEWORLD_DATASET_WRITING_DATA_CARD_H_
#define LATTICEWORLD_DATASET_WRITING_DATA_CARD_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "latticeworld/dataset/sources/instance_source.h"
#include "latticeworld/dataset/writing/dataset_options.h"
#include "latticeworld/dataset/writing/dataset_part.h"

namespace latticeworld {

// A file of records.
struct DatasetFile {
  DatasetTask task = DatasetTask::kLayout;
  DatasetSplit split = DatasetSplit::kTrain;
  std::string path;  // below the data set's folder
  std::uint64_t records = 0;
  std::uint64_t bytes = 0;
  std::string sha256;
};

// All that is told of a data set: what its manifest and its card are made of.
struct DatasetFacts {
  std::string version;    // of the program
  std::string annotator;  // "written", or the model
  std::string command;    // that makes it again; "" is left out of the card
  SourceCard source;
  std::uint64_t groups = 0;  // of the source
  DatasetOptions options;
  DatasetTallies tallies;
  std::vector<DatasetFile> files;  // none is empty
  std::string image_sums_sha256;   // "": no images
  std::vector<FailedInstance> failed;
};

// The value of a tally, 0 where there is none.
std::uint64_t TallyOf(const DatasetTallies& tallies, const std::string& key);

// dataset.json: what was made of what with which options, every file with its SHA-256, counts, and
// what failed and why.
std::string ManifestJson(const DatasetFacts& facts);

// README.md: a card as the Hugging Face Hub reads them, YAML before the words.
std::string DataCard(const DatasetFacts& facts);

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_WRITING_DATA_CARD_H_
