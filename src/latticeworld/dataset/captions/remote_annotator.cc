#include "latticeworld/dataset/captions/remote_annotator.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/captions/caption_checks.h"
#include "latticeworld/dataset/captions/phrase_book.h"
#include "latticeworld/dataset/captions/relief_words.h"
#include "latticeworld/dataset/sources/environment_sample.h"
#include "latticeworld/environment/environment_config.h"
#include "latticeworld/language/remote/conversation.h"
#include "latticeworld/language/remote/prompt_template.h"
#include "latticeworld/language/remote/thinking_filter.h"
#include "latticeworld/layout/picture.h"

namespace latticeworld {

std::string_view DatasetFile(std::string_view file_name);  // compiled in from data/ and prompts/

namespace {

std::string Fill(std::string_view file_name, const std::vector<PromptValue>& values) {
  // The files are part of the program: a name that does not fit is a bug, and a test finds it.
  std::string text = FillTemplate(DatasetFile(file_name), values).value();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

// "F = forest: woodland, dense trees", with the picture's colours for a model that sees.
std::string ClassLines(Vocabulary vocabulary, bool colours) {
  std::string text;
  for (const LayoutClass& entry : ClassesOf(vocabulary)) {
    if (!text.empty()) text += '\n';
    if (colours) {
      char colour[16];
      std::snprintf(colour, sizeof(colour), "#%02X%02X%02X", entry.color.r, entry.color.g,
                    entry.color.b);
      text += colour;
    } else {
      text += entry.letter;
    }
    text.append(" = ").append(entry.meaning);
  }
  return text;
}

std::string Lines(const std::vector<Violation>& violations) {
  constexpr std::size_t kMost = 12;  // more would fill a small model's context
  std::string text;
  for (std::size_t i = 0; i < std::min(violations.size(), kMost); ++i) {
    if (i > 0) text += '\n';
    text += "- " + violations[i].message;
  }
  return text;
}

// A layout as the model is shown it: the text that stands for it, and the picture.
struct Shown {
  std::string text;
  std::string png;
};

class RemoteAnnotator final : public Annotator {
 public:
  RemoteAnnotator(std::shared_ptr<ChatServer> server, const RemoteAnnotatorOptions& options)
      : server_(std::move(server)), options_(options) {}

  std::string_view name() const override { return options_.name; }

  Result<LayoutCaption> DescribeLayout(const Instance& instance, std::uint64_t seed,
                                       const Progress& progress) override {
    RandomStream random(StreamSeed(seed, instance.id), "remote layout caption");
    LayoutCaption caption;
    std::string relief;
    if (instance.relief != nullptr) {
      caption.relief_text =
          WordRelief(FactsOf(*instance.relief), Voice::kTechnical, false, &random);
      relief = "\nHeights, for your knowledge: " + caption.relief_text + "\n";
    }
    LW_ASSIGN_OR_RETURN(const Shown shown, Show(instance.layout));
    const bool sees = server_->sees();
    Question question = Ask("layout caption", &random);
    question.first.messages = {
        {ChatRole::kSystem,
         Fill("layout_caption_system.txt",
              {{"shown", sees ? "a picture, one colour for each kind of land"
                              : "a matrix of 32 lines of 32 letters"},
               {"classes", ClassLines(instance.layout.vocabulary, sees)}}),
         ""},
        {ChatRole::kUser,
         Fill("layout_caption_user.txt",
              {{"layout", shown.text}, {"relief", relief}, {"voice", DrawnVoice(&random)}}),
         shown.png}};
    question.read = [&](std::string_view answer) {
      caption.text = Prose(answer);
      return CheckLayoutCaption(caption.text, instance.layout, options_.least_claims,
                                &caption.claims);
    };
    LW_RETURN_IF_ERROR(Converse(std::move(question), progress));
    return caption;
  }

  Result<EnvironmentCaption> DescribeEnvironment(const Instance& instance,
                                                 const LayoutCaption& layout, std::uint64_t seed,
                                                 const Progress& progress) override {
    // The same draw as the written annotator's, so that the two differ in words alone.
    RandomStream draw(StreamSeed(seed, instance.id), "environment");
    const SampledEnvironment sample = SampleEnvironment(instance.layout, options_.size_m, &draw);
    RandomStream random(StreamSeed(seed, instance.id), "remote environment caption");
    EnvironmentCaption caption;
    caption.environment = sample.environment;
    Question question = Ask("environment caption", &random);
    question.first.messages = {
        {ChatRole::kSystem, Fill("environment_caption_system.txt", {}), ""},
        {ChatRole::kUser,
         Fill("environment_caption_user.txt",
              {{"layout", layout.text}, {"facts", Facts(sample)}, {"voice", DrawnVoice(&random)}}),
         ""}};
    question.read = [&](std::string_view answer) {
      caption.text = Prose(answer);
      return CheckEnvironmentCaption(caption.text, instance.layout, caption.environment,
                                     options_.size_m);
    };
    LW_RETURN_IF_ERROR(Converse(std::move(question), progress));
    return caption;
  }

 private:
  Question Ask(std::string_view purpose, RandomStream* random) const {
    Question question;
    question.purpose = purpose;
    question.first.max_tokens = options_.max_tokens;
    question.first.temperature = options_.temperature;
    question.first.seed = random->NextBits();
    question.repair_turns = options_.repair_turns;
    question.make_listener = [] { return [](std::string_view) { return true; }; };
    question.repair_text = [](const std::vector<Violation>& violations) {
      return Fill("caption_repair.txt", {{"violations", Lines(violations)}});
    };
    return question;
  }

  Status Converse(Question question, const Progress& progress) const {
    std::vector<ModelReply> replies;
    return latticeworld::Ask(server_.get(), std::move(question), progress, &replies);
  }

  Result<Shown> Show(const SymbolicLayout& layout) const {
    Shown shown;
    if (server_->sees()) {
      LW_ASSIGN_OR_RETURN(shown.png, ToPng(layout, options_.pixels_per_cell));
      shown.text = "The map is the picture that comes with this message.";
      return shown;
    }
    shown.text = "The map, line 1 in the north, the first letter of a line in the west:\n";
    shown.text += ToText(layout);
    shown.text.pop_back();
    return shown;
  }

  static std::string DrawnVoice(RandomStream* random) {
    static constexpr std::string_view kVoices[] = {
        "short notes, without verbs where they are not needed", "literary prose",
        "the way a person talks to a friend", "the exact words of a surveyor"};
    return std::string(kVoices[static_cast<std::size_t>(random->UniformInt(0, 3))]);
  }

  // What a model leaves around its text: thinking, fences, quotation marks.
  static std::string Prose(std::string_view answer) {
    std::string text = WithoutThinking(answer);
    const char* around = " \t\r\n\"`*";
    const std::size_t begin = text.find_first_not_of(around);
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(around) - begin + 1);
  }

  static std::string Facts(const SampledEnvironment& sample) {
    const CoarseAttributes& coarse = sample.environment.coarse;
    std::string text = "- season: " + std::string(NameOf(coarse.season));
    text += "\n- time of day: " + std::string(NameOf(coarse.time_of_day));
    text += "\n- weather: " + std::string(NameOf(coarse.weather));
    text += "\n- style: " + std::string(NameOf(coarse.artistic_style));
    for (const std::string& key : sample.told) {
      text += "\n- " + PhraseBook::BuiltIn().PhrasesOf(key).front();
    }
    for (const AgentGroup& group : sample.environment.agents) {
      text += "\n- " + std::to_string(group.quantity) + " " + std::string(NameOf(group.category)) +
              ", " + std::string(NameOf(group.state));
      if (group.position != Region::kAnywhere) {
        text += ", in the " + std::string(NameOf(group.position)) + " part of the map";
      }
    }
    if (sample.environment.agents.empty()) text += "\n- no animals, people or robots";
    return text;
  }

  std::shared_ptr<ChatServer> server_;
  const RemoteAnnotatorOptions options_;
};

}  // namespace

std::vector<Violation> Validate(const RemoteAnnotatorOptions& options) {
  std::vector<Violation> violations;
  const auto demand = [&](const char* name, double given, double low, double high) {
    if (given >= low && given <= high) return;
    violations.push_back({"out_of_range", name,
                          std::string(name) + " must be from " + FormatDouble(low) + " to " +
                              FormatDouble(high) + "; given " + FormatDouble(given),
                          FormatDouble(given)});
  };
  demand("repair_turns", options.repair_turns, 0, 8);
  demand("temperature", options.temperature, 0, 2);
  demand("max_tokens", options.max_tokens, 64, 65536);
  demand("least_claims", options.least_claims, 1, 20);
  demand("pixels_per_cell", options.pixels_per_cell, 4, 32);
  demand("size_m", options.size_m, 1, 1e6);
  return violations;
}

std::unique_ptr<Annotator> MakeRemoteAnnotator(std::shared_ptr<ChatServer> server,
                                               const RemoteAnnotatorOptions& options) {
  LW_CHECK(server != nullptr, "a remote annotator needs a server");
  LW_CHECK(Validate(options).empty(), "options are validated where they come in");
  return std::make_unique<RemoteAnnotator>(std::move(server), options);
}

}  // namespace latticeworld
