#ifndef LATTICEWORLD_LANGUAGE_CHAT_COMPLETION_READER_H_
#define LATTICEWORLD_LANGUAGE_CHAT_COMPLETION_READER_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "latticeworld/language/chat/api_key.h"
#include "latticeworld/language/chat/event_stream.h"
#include "latticeworld/language/chat/failure.h"

namespace latticeworld {

// Completion is what a server has said of one answer so far.
struct Completion {
  std::string text;
  std::string thinking;       // what the server marks as thinking
  std::string refusal;        // what is said in the text's place
  std::string finish_reason;  // "": not said (yet)
  std::string model;
  int prompt_tokens = 0;
  int completion_tokens = 0;
};

// CompletionReader reads the body of a 200 answer to POST /chat/completions as it comes: an event
// stream or one JSON object, which it tells apart by how they begin and not by their Content-Type,
// which servers get wrong. What is marked as thinking (reasoning_content, reasoning, thinking,
// thinking parts) is not part of the text; all but the parts is kept apart from it.
class CompletionReader {
 public:
  // `key` must outlive the reader, which scrubs it from what it quotes.
  explicit CompletionReader(const ApiKey* key) : key_(key) {}

  // Takes the next bytes of the body. Returns false once the answer is whole or has failed; the
  // rest is then of no interest.
  bool Feed(std::string_view bytes);
  // Ends the body, which came to its end or was cut off. Returns OK where the answer is whole, and
  // a failure to try again where the answer broke off. Errors: DATA_LOSS (no chat completion),
  // INVALID_ARGUMENT (the model refuses) and those of FailureOf for an error that stands in the 200
  // answer. `content_type` is quoted in the message.
  Failure Finish(std::string_view content_type);

  const Completion& completion() const { return completion_; }
  // Returns whether a token has come, thinking included.
  bool spoken() const { return spoken_; }
  // Returns whether the server said why it stopped; only usage and the end mark may follow then.
  bool finished() const { return !completion_.finish_reason.empty(); }

 private:
  enum class Kind : std::uint8_t { kUnknown, kJson, kEvents, kOther };

  void Sniff();
  void ReadEvent(std::string_view type, std::string_view data);
  // Reads one JSON object. in_stream: it is one chunk of many, which may say nothing.
  void ReadObject(std::string_view text, bool in_stream);
  void Fail(Failure failure);

  const ApiKey* key_;
  Kind kind_ = Kind::kUnknown;
  std::string body_;  // of an answer that is no event stream, or not known to be one
  EventStreamParser events_;
  Completion completion_;
  bool spoken_ = false;
  bool done_ = false;  // the end mark came
  std::optional<Failure> failure_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_LANGUAGE_CHAT_COMPLETION_READER_H_
