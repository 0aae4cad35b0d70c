#ifndef LATTICEWORLD_DATASET_CAPTIONS_WRITTEN_ANNOTATOR_H_
#define LATTICEWORLD_DATASET_CAPTIONS_WRITTEN_ANNOTATOR_H_

#include <memory>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/dataset/captions/annotator.h"

namespace latticeworld {

struct WrittenOptions {
  int least_facts = 3;    // of a layout caption; 1 .. 12
  int most_facts = 8;     // least_facts .. 12
  double mistyped = 0.0;  // share of the words of five letters and more with a slip of the finger;
                          // [0, 0.2]. Claims are those of the words without slips
  double size_m = 512.0;  // side of the worlds that environments are meant for, > 0
};
std::vector<Violation> Validate(const WrittenOptions& options);

// Writes from the layout, the relief and the rules of environments alone, with no model and no
// network: facts that hold by their claims' own measure, worded in four voices. options: valid.
std::unique_ptr<Annotator> MakeWrittenAnnotator(const WrittenOptions& options = {});

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_WRITTEN_ANNOTATOR_H_
