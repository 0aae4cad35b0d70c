#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/remote/conversation.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/remote/layout_reader.h"
#include "latticeworld/language/remote/prompts.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

// Follows a layout as it arrives: reports its rows, and wants no more of one that cannot become
// legal.
class LayoutListener {
 public:
  LayoutListener(Vocabulary vocabulary, const Progress* progress)
      : vocabulary_(vocabulary), progress_(progress), reader_(vocabulary) {}

  bool Hear(std::string_view text) {
    // A retry begins the answer anew.
    if (text.substr(0, heard_.size()) != heard_) {
      reader_ = LayoutReader(vocabulary_);
      heard_.clear();
    }
    reader_.Feed(text.substr(heard_.size()));
    heard_ = text;
    if (reader_.rows() != reported_) {
      reported_ = reader_.rows();
      progress_->Report("layout", static_cast<double>(reported_) / kLayoutSize);
    }
    return !reader_.hopeless();
  }

 private:
  Vocabulary vocabulary_;
  const Progress* progress_;
  LayoutReader reader_;
  std::string heard_;
  int reported_ = 0;
};

class RemoteLayoutGenerator final : public LayoutGenerator {
 public:
  RemoteLayoutGenerator(std::shared_ptr<ChatServer> server, const RemoteOptions& options)
      : server_(std::move(server)), options_(options) {}

  std::string_view name() const override { return options_.name; }

  Result<LayoutAnswer> Generate(const LayoutRequest& request, const Progress& progress,
                                std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    const Vocabulary vocabulary = request.vocabulary;
    LayoutAnswer answer;
    Question question;
    question.purpose = "layout";
    LW_ASSIGN_OR_RETURN(question.first.messages, LayoutMessages(request, server_->sees()));
    question.first.form = LayoutForm(vocabulary);
    question.first.max_tokens = options_.layout_max_tokens;
    question.first.temperature = options_.temperature;
    question.first.seed = request.seed;
    question.repair_turns = options_.repair_turns;
    question.make_listener = [vocabulary, &progress] {
      auto listener = std::make_shared<LayoutListener>(vocabulary, &progress);
      return [listener](std::string_view text) { return listener->Hear(text); };
    };
    question.read = [vocabulary, &answer](std::string_view text) {
      LW_ASSIGN_OR_RETURN(answer.layout, ReadLayoutAnswer(text, vocabulary));
      return Status();
    };
    question.repair_text = [vocabulary](const std::vector<Violation>& violations) {
      return LayoutRepairText(violations, vocabulary);
    };
    const std::size_t before = replies->size();
    LW_RETURN_IF_ERROR(Ask(server_.get(), std::move(question), progress, replies));
    for (std::string& warning : ServerWarnings(*replies, before)) {
      answer.warnings.push_back(std::move(warning));
    }
    return answer;
  }

 private:
  std::shared_ptr<ChatServer> server_;
  RemoteOptions options_;
};

}  // namespace

std::unique_ptr<LayoutGenerator> MakeRemoteLayoutGenerator(std::shared_ptr<ChatServer> server,
                                                           const RemoteOptions& options) {
  LW_CHECK(server != nullptr, "a remote generator needs a server");
  LW_CHECK(Validate(options).empty(), "options are validated where they come in");
  return std::make_unique<RemoteLayoutGenerator>(std::move(server), options);
}

}  // namespace latticeworld
