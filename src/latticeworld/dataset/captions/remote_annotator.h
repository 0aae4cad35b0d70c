#ifndef LATTICEWORLD_DATASET_CAPTIONS_REMOTE_ANNOTATOR_H_
#define LATTICEWORLD_DATASET_CAPTIONS_REMOTE_ANNOTATOR_H_

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/status.h"
#include "latticeworld/dataset/captions/annotator.h"
#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

struct RemoteAnnotatorOptions {
  int repair_turns = 3;         // times that what is wrong goes back to the model; 0 .. 8
  double temperature = 0.8;     // 0 .. 2
  int max_tokens = 1024;        // of one answer, thinking included; 64 .. 65536
  int least_claims = 3;         // that a caption must make of a layout; 1 .. 20
  int pixels_per_cell = 16;     // of the picture of the layout, for a model that sees; 4 .. 32
  double size_m = 512.0;        // side of the worlds that environments are meant for, > 0
  std::string name = "remote";  // of the annotator: the model's
};
std::vector<Violation> Validate(const RemoteAnnotatorOptions& options);

// Lets a model write, over any chat server: prompts (prompts/*_caption_*.txt) with the classes'
// colours and the layout as a picture for a model that sees, its letters otherwise, with guidance
// and examples. The configuration of an environment is drawn as the written annotator draws it; the
// model words it.
// An answer counts when the words agree with what they are about: what the grounded reader reads in
// them is measured on the layout, or on the configuration (caption_checks.h). What does not agree
// goes back to the model with what is there instead, repair_turns times. Relief is told by the
// written annotator's words, which the model is given and may change. Errors: those of the server
// (with its retries behind them); CANCELLED; DATA_LOSS with all that was wrong with the last
// answer. options: valid.
std::unique_ptr<Annotator> MakeRemoteAnnotator(std::shared_ptr<ChatServer> server,
                                               const RemoteAnnotatorOptions& options = {});

}  // namespace latticeworld

#endif  // LATTICEWORLD_DATASET_CAPTIONS_REMOTE_ANNOTATOR_H_
