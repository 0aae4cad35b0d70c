#include "latticeworld/language/generator.h"

#include <algorithm>

#include "latticeworld/common/text.h"
#include "latticeworld/language/class_words.h"
#include "latticeworld/language/tokens.h"
#include "latticeworld/layout/thing_kinds.h"

namespace latticeworld {
namespace {

bool HasWords(std::string_view text) {
  const std::vector<Token> tokens = Tokenize(text);
  return std::any_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.kind == TokenKind::kWord || token.kind == TokenKind::kNumber;
  });
}

Status ValidateRelief(const Relief* relief) {
  if (relief == nullptr || (relief->summary.rows() == kReliefSummarySize &&
                            relief->summary.cols() == kReliefSummarySize)) {
    return Status();
  }
  return InvalidArgument("the relief's summary has " + std::to_string(relief->summary.rows()) +
                         " x " + std::to_string(relief->summary.cols()) +
                         " cells; 32 x 32 are needed");
}

}  // namespace

Status ValidateLayoutInstruction(std::string_view instruction, bool has_relief) {
  LW_RETURN_IF_ERROR(ValidateText("layout instruction", instruction, kMaxInstructionBytes));
  if (!has_relief && !HasWords(instruction)) {
    return InvalidArgument(
        "layout instruction is empty (no words) and there is no relief; give a text, a relief, or "
        "both");
  }
  return Status();
}

Status ValidateEnvironmentInstruction(std::string_view instruction) {
  return ValidateText("environment instruction", instruction, kMaxInstructionBytes);
}

Status Validate(const LayoutRequest& request) {
  LW_RETURN_IF_ERROR(ValidateLayoutInstruction(request.instruction, request.relief != nullptr));
  return ValidateRelief(request.relief);
}

Status Validate(const EnvironmentRequest& request) {
  LW_RETURN_IF_ERROR(ValidateEnvironmentInstruction(request.instruction));
  LW_RETURN_IF_ERROR(ValidateRelief(request.relief));
  if (request.layout == nullptr) {
    return InvalidArgument("an environment needs a layout; none was given");
  }
  if (request.catalogue == nullptr) {
    return InvalidArgument("an environment needs a catalogue; none was given");
  }
  if (request.layout->cells.rows() != kLayoutSize || request.layout->cells.cols() != kLayoutSize) {
    return InvalidArgument("the layout has " + std::to_string(request.layout->cells.rows()) +
                           " x " + std::to_string(request.layout->cells.cols()) +
                           " cells; 32 x 32 are needed");
  }
  return Status();
}

Vocabulary ChooseVocabulary(std::string_view layout_instruction) {
  const std::vector<Token> tokens = Tokenize(layout_instruction);
  int suburb = 0;
  int wild = 0;
  bool land = false;  // of the suburb is spoken of
  for (std::size_t i = 0; i < tokens.size();) {
    if (tokens[i].text == "wild" || tokens[i].text == "wilderness") wild += 2;
    const ClassWordMatch match = MatchClassWord(tokens, i);
    i += match.word != nullptr ? match.tokens : 1;
    if (match.word == nullptr) continue;
    // Only a word that one vocabulary has and the other has not tells them apart.
    const bool of_suburb = match.word->suburb_exact && !match.word->wild_exact;
    suburb += of_suburb ? 1 : 0;
    wild += match.word->wild_exact && !match.word->suburb_exact ? 1 : 0;
    const bool single = !match.plural && FindThingKind(match.word->phrase) != nullptr;
    land = land || (of_suburb && !single);
  }
  return wild > (land ? suburb : 0) ? Vocabulary::kWild : Vocabulary::kSuburb;
}

}  // namespace latticeworld
