#include "latticeworld/language/interpreted/prompts.h"

#include <string_view>
#include <utility>

#include "latticeworld/language/remote/prompt_template.h"
#include "latticeworld/language/remote/prompts.h"
#include "latticeworld/language/remote/rule_tables.h"
#include "latticeworld/language/sentences/sentence_guide.h"

namespace latticeworld {

std::string_view InterpretedPromptFile(std::string_view file_name);  // compiled in from prompts/

namespace {

std::string Fill(std::string_view file_name, const std::vector<PromptValue>& values) {
  return FillPromptFile(InterpretedPromptFile(file_name), values);
}

std::string LanguageInWords(SentenceKind kind) {
  return Fill("language.txt", {{"forms", FormsInWords(kind)}, {"slots", SlotsInWords(kind)}});
}

std::vector<ChatMessage> Messages(std::string system, const std::string& instruction) {
  return {{ChatRole::kSystem, std::move(system), ""},
          {ChatRole::kUser, Fill("words_user.txt", {{"instruction", instruction}}), ""}};
}

}  // namespace

std::vector<ChatMessage> LayoutWordsMessages(const LayoutRequest& request) {
  return Messages(
      Fill("layout_words_system.txt", {{"classes", ClassLines(request.vocabulary)},
                                       {"language", LanguageInWords(SentenceKind::kLayout)},
                                       {"form", Fill("form.txt", {})}}),
      request.instruction);
}

std::vector<ChatMessage> EnvironmentWordsMessages(const EnvironmentRequest& request) {
  return Messages(Fill("environment_words_system.txt",
                       {{"states", StateTable()},
                        {"language", LanguageInWords(SentenceKind::kEnvironment)},
                        {"form", Fill("form.txt", {})}}),
                  request.instruction);
}

std::string SentencesRepairText(const std::vector<Violation>& violations) {
  return Fill("words_repair.txt",
              {{"violations", ViolationLines(violations)}, {"form", Fill("form.txt", {})}});
}

}  // namespace latticeworld
