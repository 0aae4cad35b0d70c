#ifndef LATTICEWORLD_LANGUAGE_READING_MODEL_READER_H_
#define LATTICEWORLD_LANGUAGE_READING_MODEL_READER_H_

#include <memory>

#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// A language model that was taught to say instructions in the small language (training/, "readers")
// reads them: the system message is the kind ("layout", "environment"), the user's the text, and
// the answer is held to the grammar of sentences, drawn greedily. What it says is read by the
// tables of forms. A text that already is the small language, whole, is not given to the model.
// Words of the text that name a class of land which no sentence speaks of are not understood.
// server: never null. Errors: those of ChatServer::Complete.
std::unique_ptr<InstructionReader> MakeModelReader(std::shared_ptr<ChatServer> server);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_MODEL_READER_H_
