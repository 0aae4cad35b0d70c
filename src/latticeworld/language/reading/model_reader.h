#ifndef LATTICEWORLD_LANGUAGE_READING_MODEL_READER_H_
#define LATTICEWORLD_LANGUAGE_READING_MODEL_READER_H_

#include <memory>

#include "latticeworld/language/chat/chat_server.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {

// Makes a reader that asks a language model which was taught to say instructions in the small
// language (training/, "readers"). The system message is the kind ("layout", "environment"), the
// user's message is the text, and the server holds the answer, drawn greedily, to the grammar of
// sentences. The tables of forms read what the model says. A text that is wholly the small language
// already is not given to the model. Words of the text that name a class of land of which no
// sentence speaks count as not understood. `server` is never null. Errors: those of
// ChatServer::Complete; RESOURCE_EXHAUSTED where a text takes more than 512 tokens of the model.
std::unique_ptr<InstructionReader> MakeModelReader(std::shared_ptr<ChatServer> server);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_READING_MODEL_READER_H_
