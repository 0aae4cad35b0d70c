#ifndef LATTICEWORLD_LANGUAGE_LOCAL_LOCAL_H_
#define LATTICEWORLD_LANGUAGE_LOCAL_LOCAL_H_

#include <memory>
#include <string>

#include "latticeworld/common/result.h"
#include "latticeworld/language/chat/chat_server.h"

namespace latticeworld {

// A language model in this process instead of behind a server: a GGUF file of
// LLaMA's architecture with weights in f32, f16, q4_1 or q8_0 and a SentencePiece or
// byte-level tokenizer. Answers keep to the form that is asked for (its GBNF grammar, else
// its JSON schema) by construction: only tokens that the form allows are ever
// drawn. The same file, request and seed: the same answer, on every processor.
// What an earlier request's messages have in common with the next one's is not
// computed again.
//
// Two things a file may say of its model. `latticeworld.sees`: it was trained
// to look at height maps, and what shows them to it lies beside it
// ("layouts.eyes.gguf" beside "layouts.gguf", see HeightEyes).
// `latticeworld.guidance` g, 1 to 20: it was trained without a prompt now and
// then, and answers are drawn from u + g (p - u), where p are the logits after
// the prompt and u those after none (Ho and Salimans 2022), at twice the cost.
//
// threads: that compute, with the one that asks; 0: as many as the machine has
// cores. Answers do not depend on them.
//
// Safe to use from several threads; requests wait for each other. Errors of
// Complete: INVALID_ARGUMENT (a form that cannot be read, pictures that it does not see or
// that are none, temperature below 0), RESOURCE_EXHAUSTED (messages longer than the request
// allows or than the model's context; an answer that reaches the context's end is cut, with the
// reason "length"), DATA_LOSS (the model gives no number to any token that the form allows: its
// weights are damaged, or overflow), CANCELLED between two tokens.
//
// Errors: those of GgufFile::Open; DATA_LOSS: a model, tokenizer or eyes that
// are not read here, or do not go together.
Result<std::shared_ptr<ChatServer>> MakeLocalChatServer(const std::string& model_file,
                                                        int threads = 0);

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_LOCAL_LOCAL_H_
