#ifndef LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETATION_H_
#define LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETATION_H_

#include <string>
#include <string_view>
#include <vector>

#include "latticeworld/common/progress.h"
#include "latticeworld/common/result.h"
#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/generator.h"
#include "latticeworld/language/sentences/sentence_tables.h"
#include "latticeworld/layout/vocabulary.h"

namespace latticeworld {

// A question for the sentences of an instruction.
struct Interpretation {
  std::string_view purpose;  // "layout_words", "environment_words"
  std::string_view text;     // the instruction
  SentenceKind kind = SentenceKind::kLayout;
  Vocabulary vocabulary = Vocabulary::kSuburb;
  std::vector<ChatMessage> messages;
  int repair_turns = 2;
  int max_tokens = 2048;
  double temperature = 0.7;
  std::uint64_t seed = 0;
};

// The instruction in sentences of the small language, without their stops; none where it asks for
// nothing. A sentence of no form, and a known noun, place or number of the text that no sentence
// carries, goes back to the model, until nothing is wrong, it says the same again, its turns are
// used up, or its server fails after it has said something. replies: every answer, appended in
// order. Errors: those of Ask while nothing has been said; CANCELLED.
Result<std::vector<std::string>> Interpret(ChatServer* server, const Interpretation& interpretation,
                                           const Progress& progress,
                                           std::vector<ModelReply>* replies);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_INTERPRETED_INTERPRETATION_H_
