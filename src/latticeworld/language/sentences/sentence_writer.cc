#include "latticeworld/language/sentences/sentence_writer.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

constexpr std::string_view kPluralLists[] = {"countable_s", "relief_s", "object_s"};

// Whether the last noun of a thing is a plural: "the lakes", "2 small ponds". Labels do not count.
bool IsPlural(std::string_view thing) {
  return std::any_of(std::begin(kPluralLists), std::end(kPluralLists), [&](std::string_view list) {
    const std::vector<std::string>& nouns = SentenceWords(list);
    return std::any_of(nouns.begin(), nouns.end(), [&](const std::string& noun) {
      return thing == noun || EndsWith(thing, " " + noun);
    });
  });
}

// The words of a pattern that are two forms of one verb: "covers|cover", "is|are".
bool IsVerb(const std::vector<std::string>& words) {
  if (words.size() != 2) return false;
  return words[0] == "is" || words[0] == words[1] + "s" || words[0] == words[1] + "es";
}

class Writer {
 public:
  explicit Writer(const std::vector<Filling>& fillings) : left_(fillings) {
    const auto subject = std::find_if(fillings.begin(), fillings.end(),
                                      [](const Filling& filling) { return filling.first == "x"; });
    plural_ = subject != fillings.end() && IsPlural(subject->second);
  }

  void Write(const Pattern& pattern) {
    switch (pattern.kind) {
      case Pattern::Kind::kWords:
        Say(pattern.words[IsVerb(pattern.words) && plural_ ? 1 : 0]);
        return;
      case Pattern::Kind::kSlot:
        Say(Take(pattern.name));
        return;
      case Pattern::Kind::kSequence:
        for (const Pattern& part : pattern.parts) Write(part);
        return;
      case Pattern::Kind::kChoice:
        Write(pattern.parts.front());
        return;
      case Pattern::Kind::kOptional:
        if (CanFill(pattern.parts.front())) Write(pattern.parts.front());
        return;
      case Pattern::Kind::kRepeat:
        return;
    }
  }

  std::string Finish() {
    LW_CHECK(left_.empty(), "every filling has a slot");
    text_.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text_.front())));
    return std::move(text_);
  }

 private:
  void Say(const std::string& words) {
    const bool joined = text_.empty() || words == ":" || words == ",";
    text_ += (joined ? "" : " ") + words;
  }

  std::vector<Filling>::iterator Find(std::string_view slot) {
    return std::find_if(left_.begin(), left_.end(),
                        [&](const Filling& filling) { return filling.first == slot; });
  }

  std::string Take(std::string_view slot) {
    const auto found = Find(slot);
    LW_CHECK(found != left_.end(), "every slot of a sentence has a filling");
    std::string text = std::move(found->second);
    left_.erase(found);
    return text;
  }

  // Whether the first slot of what may be missing has a filling left.
  bool CanFill(const Pattern& pattern) {
    if (pattern.kind == Pattern::Kind::kSlot) return Find(pattern.name) != left_.end();
    return std::any_of(pattern.parts.begin(), pattern.parts.end(),
                       [this](const Pattern& part) { return CanFill(part); });
  }

  std::vector<Filling> left_;
  bool plural_ = false;
  std::string text_;
};

}  // namespace

std::string WriteSentence(SentenceKind kind, std::string_view form,
                          const std::vector<Filling>& fillings) {
  const std::vector<SentenceForm>& forms = SentenceForms(kind);
  const auto found = std::find_if(forms.begin(), forms.end(),
                                  [&](const SentenceForm& entry) { return entry.name == form; });
  LW_CHECK(found != forms.end(), "a sentence has a form of the tables");
  Writer writer(fillings);
  writer.Write(found->pattern);
  return writer.Finish();
}

}  // namespace latticeworld
