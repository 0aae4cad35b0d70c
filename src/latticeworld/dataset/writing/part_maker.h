#ifndef LATTICEWORLD_DATASET_WRITING_PART_MAKER_H_
#define LATTICEWORLD_DATASET_WRITING_PART_MAKER_H_

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/dataset/captions/prompt_texts.h"
#include "latticeworld/dataset/sources/instance_source.h"
#include "latticeworld/dataset/writing/dataset_options.h"
#include "latticeworld/dataset/writing/dataset_part.h"

namespace latticeworld {

// Makes records of groups. Const and shared by threads; all pointers outlive it.
struct PartMaker {
  const InstanceSource* source = nullptr;
  Annotator* annotator = nullptr;
  const DatasetOptions* options = nullptr;
  const PromptTexts* prompts = nullptr;

  // Keeps an image. Errors end the part.
  using ImageSink = std::function<Status(const std::string& file_name, std::string_view bytes)>;
  // Records of the groups first .. last - 1. image_folder: what records say before a file's name.
  // A group that cannot be read and an instance that cannot be described become failures of the
  // part. Errors: CANCELLED; a server that cannot be had (UNAVAILABLE, UNAUTHENTICATED,
  // PERMISSION_DENIED, NOT_FOUND, DEADLINE_EXCEEDED, FAILED_PRECONDITION); those of the sink.
  Result<DatasetPart> Make(std::size_t first, std::size_t last, const std::string& image_folder,
                           const ImageSink& sink, const Progress& progress,
                           const std::function<void()>& group_done) const;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_WRITING_PART_MAKER_H_
