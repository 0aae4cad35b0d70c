#include "latticeworld/language/sentences/sentence_guide.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

void AddSlots(const Pattern& pattern, std::vector<std::string>* slots) {
  if (pattern.kind == Pattern::Kind::kSlot) {
    const bool known = std::find(slots->begin(), slots->end(), pattern.name) != slots->end();
    if (!known) slots->push_back(pattern.name);
  }
  for (const Pattern& part : pattern.parts) AddSlots(part, slots);
}

// The slots of the forms and of what they take, each once.
std::vector<std::string> SlotsOf(SentenceKind kind) {
  std::vector<std::string> slots;
  for (const SentenceForm& form : SentenceForms(kind)) AddSlots(form.pattern, &slots);
  for (std::size_t i = 0; i < slots.size(); ++i) {  // grows while slots are looked into
    const Pattern* const pattern = SlotPattern(slots[i]);
    if (pattern != nullptr) AddSlots(*pattern, &slots);
  }
  return slots;
}

}  // namespace

std::string FormsInWords(SentenceKind kind) {
  std::vector<std::string> lines;
  for (const SentenceForm& form : SentenceForms(kind)) {
    lines.push_back("- " + form.written + " (" + Quote(form.example) + ")");
  }
  return Join(lines, "\n");
}

std::string SlotsInWords(SentenceKind kind) {
  std::vector<std::string> lines = {"- {n}: a number", "- {label}: a capital letter"};
  for (const std::string& slot : SlotsOf(kind)) {
    if (const std::string written(SlotText(slot)); !written.empty()) {
      lines.push_back("- {" + slot + "}: " + written);
    } else if (EndsWith(slot, "_s")) {
      lines.push_back("- {" + slot + "}: a plural of {" + slot.substr(0, slot.size() - 2) + "}");
    } else if (const std::vector<std::string>& words = SentenceWords(slot); !words.empty()) {
      lines.push_back("- {" + slot + "}: " + Join(words, ", "));
    }
  }
  return Join(lines, "\n");
}

}  // namespace latticeworld
