#include "latticeworld/language/interpreted/prompts.h"

#include <string_view>
#include <utility>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/attributes.h"
#include "latticeworld/language/remote/prompt_template.h"
#include "latticeworld/language/remote/prompts.h"
#include "latticeworld/language/remote/rule_tables.h"

namespace latticeworld {

std::string_view InterpretedPromptFile(std::string_view file_name);  // compiled in from prompts/

namespace {

std::string Fill(std::string_view file_name, const std::vector<PromptValue>& values) {
  return FillPromptFile(InterpretedPromptFile(file_name), values);
}

std::vector<ChatMessage> Messages(std::string system, const std::string& instruction) {
  return {{ChatRole::kSystem, std::move(system), ""},
          {ChatRole::kUser, Fill("words_user.txt", {{"instruction", instruction}}), ""}};
}

template <typename Enum>
std::string NameList() {
  std::vector<std::string> names;
  for (const auto& entry : EnumNames(Enum{})) names.emplace_back(entry.name);
  return Join(names, ", ");
}

}  // namespace

std::vector<ChatMessage> LayoutWordsMessages(const LayoutRequest& request) {
  const std::string things = std::string("things_") + std::string(NameOf(request.vocabulary));
  return Messages(Fill("layout_words_system.txt", {{"classes", ClassLines(request.vocabulary)},
                                                   {"things", Fill(things + ".txt", {})},
                                                   {"form", Fill("words_form.txt", {})}}),
                  request.instruction);
}

std::vector<ChatMessage> EnvironmentWordsMessages(const EnvironmentRequest& request) {
  return Messages(Fill("environment_words_system.txt", {{"seasons", NameList<Season>()},
                                                        {"weathers", NameList<Weather>()},
                                                        {"times", NameList<TimeOfDay>()},
                                                        {"styles", NameList<ArtisticStyle>()},
                                                        {"terrains", NameList<TerrainType>()},
                                                        {"states", StateTable()},
                                                        {"form", Fill("words_form.txt", {})}}),
                  request.instruction);
}

std::string ReadBackText(const std::string& reading) {
  return Fill("read_back.txt", {{"reading", reading}, {"form", Fill("words_form.txt", {})}});
}

std::string SentencesRepairText(const std::vector<Violation>& violations) {
  return Fill("words_repair.txt",
              {{"violations", ViolationLines(violations)}, {"form", Fill("words_form.txt", {})}});
}

}  // namespace latticeworld
