#include "latticeworld/dataset/captions/prompt_texts.h"

#include <string_view>
#include <utility>

#include "latticeworld/language/remote/prompts.h"

namespace latticeworld {
namespace {

// Stand for what differs; no prompt holds control characters.
constexpr std::string_view kCaptionMark =
    "\x02"
    "caption\x03";
constexpr std::string_view kInstructionMark =
    "\x02"
    "instruction\x03";

// Cuts the text before the only `mark`, and both from `rest`.
Status CutBefore(std::string_view mark, std::string_view* rest, std::string* before) {
  const std::size_t at = rest->find(mark);
  if (at == std::string_view::npos || rest->find(mark, at + 1) != std::string_view::npos)
    return Internal("the environment's prompt cannot be taken apart");
  *before = std::string(rest->substr(0, at));
  rest->remove_prefix(at + mark.size());
  return Status();
}

bool IsBlank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

std::string LinesOf(const SymbolicLayout& layout) {
  std::string lines = ToText(layout);
  lines.pop_back();
  return lines;
}

}  // namespace

Result<PromptTexts> PromptTexts::Make(double size_m) {
  PromptTexts texts;
  for (std::size_t v = 0; v < kVocabularies; ++v) {
    SymbolicLayout layout;
    layout.vocabulary = static_cast<Vocabulary>(v);
    layout.cells =
        Grid<char>(kLayoutSize, kLayoutSize, ClassesOf(layout.vocabulary).front().letter);
    Relief relief;
    relief.caption = std::string(kCaptionMark);
    for (const bool with_relief : {false, true}) {
      EnvironmentRequest request;
      request.instruction = std::string(kInstructionMark);
      request.layout = &layout;
      request.relief = with_relief ? &relief : nullptr;
      request.size_m = size_m;
      LW_ASSIGN_OR_RETURN(std::vector<ChatMessage> messages,
                          EnvironmentMessages(request, /*sees=*/false));
      texts.system_ = std::move(messages[0].text);
      std::string_view rest = messages[1].text;
      Frame& frame = texts.frames_[v][with_relief ? 1 : 0];
      LW_RETURN_IF_ERROR(CutBefore(LinesOf(layout), &rest, &frame.before_layout));
      if (with_relief) LW_RETURN_IF_ERROR(CutBefore(kCaptionMark, &rest, &frame.before_caption));
      LW_RETURN_IF_ERROR(CutBefore(kInstructionMark, &rest, &frame.before_instruction));
      frame.after_instruction = std::string(rest);
    }
  }
  return texts;
}

Result<std::vector<ChatMessage>> PromptTexts::Layout(const LayoutRequest& request) const {
  return LayoutMessages(request, /*sees=*/false);
}

Result<std::vector<ChatMessage>> PromptTexts::Environment(const EnvironmentRequest& request) const {
  // Words of their own stand in the place of an instruction that says nothing.
  if (IsBlank(request.instruction)) return EnvironmentMessages(request, /*sees=*/false);
  const bool with_relief = request.relief != nullptr;
  const Frame& frame =
      frames_[static_cast<std::size_t>(request.layout->vocabulary)][with_relief ? 1 : 0];
  std::string user = frame.before_layout + LinesOf(*request.layout);
  if (with_relief) user += frame.before_caption + request.relief->caption;
  user += frame.before_instruction + request.instruction + frame.after_instruction;
  return std::vector<ChatMessage>{{ChatRole::kSystem, system_, ""},
                                  {ChatRole::kUser, std::move(user), ""}};
}

}  // namespace latticeworld
