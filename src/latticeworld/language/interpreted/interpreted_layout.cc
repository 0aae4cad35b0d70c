#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/drawn/grounded.h"
#include "latticeworld/language/interpreted/interpretation.h"
#include "latticeworld/language/interpreted/interpreted.h"
#include "latticeworld/language/interpreted/prompts.h"
#include "latticeworld/language/interpreted/reading_text.h"
#include "latticeworld/language/interpreted/sentences.h"

namespace latticeworld {
namespace {

class InterpretedLayoutGenerator final : public LayoutGenerator {
 public:
  InterpretedLayoutGenerator(std::shared_ptr<ChatServer> server, const RemoteOptions& options)
      : server_(std::move(server)), options_(options), embedded_(MakeGroundedLayoutGenerator()) {}

  std::string_view name() const override { return options_.name; }

  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress& progress,
                                std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    if (Trimmed(request.instruction).empty())
      return embedded_->Generate(request, progress, replies);
    progress.Report("layout", 0.0);
    Interpretation interpretation;
    interpretation.purpose = "layout_words";
    interpretation.messages = LayoutWordsMessages(request);
    interpretation.read_back = [vocabulary = request.vocabulary](const std::string& words) {
      return TextOf(ReadLayoutInstruction(words, vocabulary));
    };
    interpretation.read_back_turns = options_.repair_turns;
    interpretation.max_tokens = options_.layout_max_tokens;
    interpretation.temperature = options_.temperature;
    interpretation.seed = request.seed;
    LW_ASSIGN_OR_RETURN(const std::string words,
                        Interpret(server_.get(), interpretation, progress, replies));
    LayoutRequest plain = request;
    plain.reading = nullptr;
    // Where nothing is asked of the map, the person's own words are nearest to it.
    if (!words.empty()) plain.instruction = words;
    LW_ASSIGN_OR_RETURN(LayoutAnswer answer, embedded_->Generate(plain, progress, replies));
    answer.warnings.insert(answer.warnings.begin(), ReadAsWarning(plain.instruction));
    return answer;
  }

 private:
  const std::shared_ptr<ChatServer> server_;
  const RemoteOptions options_;
  const std::unique_ptr<LayoutGenerator> embedded_;
};

}  // namespace

std::unique_ptr<LayoutGenerator> MakeInterpretedLayoutGenerator(std::shared_ptr<ChatServer> server,
                                                                const RemoteOptions& options) {
  LW_CHECK(server != nullptr, "a model that interprets needs a server");
  LW_CHECK(Validate(options).empty(), "options are validated where they come in");
  return std::make_unique<InterpretedLayoutGenerator>(std::move(server), options);
}

}  // namespace latticeworld
