#include "latticeworld/language/remote/prompts.h"

#include <algorithm>
#include <string_view>

#include "latticeworld/common/text.h"
#include "latticeworld/language/remote/forms.h"
#include "latticeworld/language/remote/prompt_template.h"
#include "latticeworld/language/remote/relief_picture.h"
#include "latticeworld/language/remote/rule_tables.h"

namespace latticeworld {

std::string_view RemotePromptFile(std::string_view file_name);  // compiled in from prompts/

namespace {

// At most this many violations are told: more would fill a small model's context and tell it
// nothing new.
constexpr std::size_t kMostViolationsSaid = 100;

std::string Fill(std::string_view file_name, const std::vector<PromptValue>& values) {
  return FillPromptFile(RemotePromptFile(file_name), values);
}

std::string InstructionText(std::string_view instruction) {
  if (instruction.find_first_not_of(" \t\r\n") != std::string_view::npos) {
    return std::string(instruction);
  }
  return Fill("nothing_said.txt", {});
}

// Caption and picture of a relief, or nothing.
Status AddRelief(const Relief* relief, bool sees, std::string* words, std::string* png) {
  if (relief == nullptr) return Status();
  *words = "\n" + Fill("relief.txt", {{"caption", relief->caption}}) + "\n";
  if (!sees) return Status();
  LW_ASSIGN_OR_RETURN(*png, ReliefPicture(relief->height_m));
  *words += Fill("relief_image.txt", {}) + "\n";
  return Status();
}

std::string RepairText(const std::vector<Violation>& violations, std::string form) {
  return Fill("repair.txt",
              {{"violations", ViolationLines(violations)}, {"form", std::move(form)}});
}

}  // namespace

std::string ClassLines(Vocabulary vocabulary) {
  std::string text;
  for (const LayoutClass& entry : ClassesOf(vocabulary)) {
    if (!text.empty()) text += '\n';
    text += entry.letter;
    text += " = ";
    text += entry.meaning;
  }
  return text;
}

std::string ViolationLines(const std::vector<Violation>& violations) {
  std::string lines;
  const std::size_t said = std::min(violations.size(), kMostViolationsSaid);
  for (std::size_t i = 0; i < said; ++i) {
    if (i > 0) lines += '\n';
    lines += "- ";
    if (!violations[i].pointer.empty()) lines += violations[i].pointer + ": ";
    lines += violations[i].message;
  }
  if (said < violations.size()) {
    lines += "\n- and " + std::to_string(violations.size() - said) + " further such things";
  }
  return lines;
}

Result<std::vector<ChatMessage>> LayoutMessages(const LayoutRequest& request, bool sees) {
  std::string relief;
  std::string png;
  LW_RETURN_IF_ERROR(AddRelief(request.relief, sees, &relief, &png));
  const std::string high_class =
      request.vocabulary == Vocabulary::kWild ? "rock and snow" : "barren land";
  std::string system = Fill("layout_system.txt", {{"classes", ClassLines(request.vocabulary)},
                                                  {"high_class", high_class}});
  std::string user =
      Fill("layout_user.txt", {{"instruction", InstructionText(request.instruction)},
                               {"relief", relief},
                               {"letters", std::string(LegalLetters(request.vocabulary))}});
  return std::vector<ChatMessage>{{ChatRole::kSystem, std::move(system), ""},
                                  {ChatRole::kUser, std::move(user), std::move(png)}};
}

Result<std::vector<ChatMessage>> EnvironmentMessages(const EnvironmentRequest& request, bool sees) {
  std::string relief;
  std::string png;
  LW_RETURN_IF_ERROR(AddRelief(request.relief, sees, &relief, &png));
  std::string layout = ToText(*request.layout);
  layout.pop_back();  // the template ends the line
  std::string system =
      Fill("environment_system.txt", {{"schema", EnvironmentForm(*request.catalogue).json_schema},
                                      {"seasons", SeasonTable(*request.catalogue)},
                                      {"limits", LimitTable(*request.catalogue)},
                                      {"states", StateTable()},
                                      {"most_in_group", std::to_string(kMaxGroupQuantity)},
                                      {"most_agents", std::to_string(kMaxAgents)}});
  std::string user =
      Fill("environment_user.txt", {{"cells", std::to_string(kLayoutSize)},
                                    {"cell_size", FormatDouble(request.size_m / kLayoutSize)},
                                    {"layout", layout},
                                    {"classes", ClassLines(request.layout->vocabulary)},
                                    {"relief", relief},
                                    {"instruction", InstructionText(request.instruction)}});
  return std::vector<ChatMessage>{{ChatRole::kSystem, std::move(system), ""},
                                  {ChatRole::kUser, std::move(user), std::move(png)}};
}

std::string LayoutRepairText(const std::vector<Violation>& violations, Vocabulary vocabulary) {
  return RepairText(violations,
                    Fill("layout_form.txt", {{"letters", std::string(LegalLetters(vocabulary))}}));
}

std::string EnvironmentRepairText(const std::vector<Violation>& violations) {
  return RepairText(violations, Fill("environment_form.txt", {}));
}

}  // namespace latticeworld
