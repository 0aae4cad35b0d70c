#include "latticeworld/language/reading/model_reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"
#include "latticeworld/language/reading/reading_of_sentences.h"
#include "latticeworld/language/reading/things/beside_things.h"
#include "latticeworld/language/reading/words/subjects.h"
#include "latticeworld/language/sentences/sentence.h"
#include "latticeworld/language/sentences/sentence_grammar.h"

namespace latticeworld {
namespace {

constexpr int kMostTokens = 512;  // of an answer; the longest that was taught has some 200
// Of the text with what stands around it: some 2,000 characters of English, three times the longest
// text that the shipped reader was taught. The keys and values of a
// token of text or answer take 46 kB.
constexpr int kMostPromptTokens = 512;

bool IsBlank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

// Whether a text is the small language already.
bool IsControlled(const std::vector<std::string>& sentences, SentenceKind kind) {
  return std::all_of(sentences.begin(), sentences.end(), [kind](const std::string& sentence) {
    return ReadSentence(sentence, kind).has_value();
  });
}

class ModelReader final : public InstructionReader {
 public:
  explicit ModelReader(std::shared_ptr<ChatServer> server) : server_(std::move(server)) {}

  std::string_view name() const override { return "model"; }
  bool reads_by_kind() const override { return true; }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                   std::vector<ModelReply>* replies) override {
    std::vector<std::string> sentences = SplitSentences(request.instruction);
    if (IsControlled(sentences, SentenceKind::kLayout)) {
      return ReadingOfSentences(request, std::move(sentences));
    }
    return ReadBesideThings(request, ThingsTaken::kWhole, [&](const LayoutRequest& rest) {
      return ReadLand(rest, progress, replies);
    });
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& whole,
                                             const Progress& progress,
                                             std::vector<ModelReply>* replies) override {
    std::vector<std::string> sentences = SplitSentences(whole.instruction);
    if (IsControlled(sentences, SentenceKind::kEnvironment)) {
      return ReadingOfSentences(whole, std::move(sentences));
    }
    const EnvironmentRequest request = OfItsKind(whole);
    double log_probability = 0.0;
    LW_ASSIGN_OR_RETURN(sentences, Read(request.instruction, SentenceKind::kEnvironment,
                                        request.seed, progress, replies, &log_probability));
    EnvironmentReading reading = ReadingOfSentences(request, std::move(sentences));
    reading.log_probability = log_probability;
    return reading;
  }

 private:
  Result<LayoutReading> ReadLand(const LayoutRequest& whole, const Progress& progress,
                                 std::vector<ModelReply>* replies) {
    const LayoutRequest request = OfItsKind(whole);
    double log_probability = 0.0;
    LW_ASSIGN_OR_RETURN(std::vector<std::string> sentences,
                        Read(request.instruction, SentenceKind::kLayout, request.seed, progress,
                             replies, &log_probability));
    LayoutReading reading = ReadingOfSentences(request, std::move(sentences));
    reading.log_probability = log_probability;
    return reading;
  }

  Result<std::vector<std::string>> Read(const std::string& text, SentenceKind kind,
                                        std::uint64_t seed, const Progress& progress,
                                        std::vector<ModelReply>* replies, double* log_probability) {
    if (IsBlank(text)) return std::vector<std::string>();
    const bool layout = kind == SentenceKind::kLayout;
    ChatRequest request;
    request.messages = {{ChatRole::kSystem, layout ? "layout" : "environment", {}},
                        {ChatRole::kUser, text, {}}};
    // A recording finds its reply by the form's name.
    const std::string purpose(layout ? kLayoutWords : kEnvironmentWords);
    request.form.name = purpose;
    request.form.gbnf = layout ? layout_grammar_ : environment_grammar_;
    request.max_tokens = kMostTokens;
    request.max_prompt_tokens = kMostPromptTokens;
    request.temperature = 0.0;
    request.seed = seed;
    LW_ASSIGN_OR_RETURN(const ChatReply reply, server_->Complete(request, {}, progress));
    ModelReply said;
    said.purpose = purpose;
    said.model = reply.model;
    said.text = reply.text;
    said.finish_reason = reply.finish_reason;
    said.prompt_tokens = reply.prompt_tokens;
    said.completion_tokens = reply.completion_tokens;
    said.retries = reply.retries;
    said.seconds = reply.total_s;
    said.log_probability = reply.log_probability;
    *log_probability = reply.log_probability / std::max(1, reply.completion_tokens);
    replies->push_back(std::move(said));
    return WithoutRepeats(SplitSentences(reply.text == "-" ? std::string() : reply.text),
                          reply.finish_reason == "stop");
  }

  // Small models say a thing again now and then; and an answer that was cut ends in half a
  // sentence.
  static std::vector<std::string> WithoutRepeats(std::vector<std::string> sentences, bool whole) {
    if (!whole && !sentences.empty()) sentences.pop_back();
    std::vector<std::string> kept;
    for (std::string& sentence : sentences) {
      if (std::find(kept.begin(), kept.end(), sentence) == kept.end()) {
        kept.push_back(std::move(sentence));
      }
    }
    return kept;
  }

  const std::shared_ptr<ChatServer> server_;
  const std::string layout_grammar_ = SentenceGrammar(SentenceKind::kLayout);
  const std::string environment_grammar_ = SentenceGrammar(SentenceKind::kEnvironment);
};

}  // namespace

std::unique_ptr<InstructionReader> MakeModelReader(std::shared_ptr<ChatServer> server) {
  LW_CHECK(server != nullptr, "a model that reads needs a server");
  return std::make_unique<ModelReader>(std::move(server));
}

}  // namespace latticeworld
