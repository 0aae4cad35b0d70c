#include "latticeworld/language/sentences/sentence_tables.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/text.h"

namespace latticeworld {

std::string_view SentenceFile(std::string_view file_name);

namespace {

using Lists = std::map<std::string, std::vector<std::string>, std::less<>>;

// The fields of each line of an embedded table that is neither blank nor a comment.
std::vector<std::vector<std::string>> LinesOf(std::string_view file_name) {
  std::vector<std::vector<std::string>> lines;
  for (const std::string& line : Split(SentenceFile(file_name), '\n')) {
    if (!line.empty() && line.front() != '#') lines.push_back(Split(line, '\t'));
  }
  return lines;
}

// The tables are part of the program: what is wrong in one of them is a bug.
Pattern PatternOf(const std::string& text) {
  Result<Pattern> pattern = ParsePattern(text);
  LW_CHECK(pattern.ok(), "the tables of sentences are well formed");
  return std::move(*pattern);
}

const Lists& AllLists() {
  static const Lists lists = [] {
    Lists all;
    for (std::vector<std::string>& line : LinesOf("words.txt")) {
      std::vector<std::string>& words = all[line.front()];
      words.assign(line.begin() + 1, line.end());
    }
    for (const std::string_view name : {"countable", "relief", "object", "who", "feature"}) {
      std::vector<std::string> plurals;
      for (const std::string& noun : all.find(name)->second) plurals.push_back(PluralNoun(noun));
      all.emplace(std::string(name) + "_s", std::move(plurals));
    }
    return all;
  }();
  return lists;
}

std::vector<SentenceForm> ReadForms(std::string_view file_name) {
  std::vector<SentenceForm> forms;
  for (const std::vector<std::string>& line : LinesOf(file_name)) {
    LW_CHECK(line.size() == 3, "a form has a name, a pattern and an example");
    forms.push_back({line[0], PatternOf(line[1]), line[1], line[2]});
  }
  return forms;
}

}  // namespace

const std::vector<SentenceForm>& SentenceForms(SentenceKind kind) {
  static const std::vector<SentenceForm> layout = ReadForms("layout_forms.txt");
  static const std::vector<SentenceForm> environment = ReadForms("environment_forms.txt");
  return kind == SentenceKind::kLayout ? layout : environment;
}

namespace {

struct Slot {
  Pattern pattern;
  std::string written;
};

const Slot* FindSlot(std::string_view name) {
  static const std::map<std::string, Slot, std::less<>> slots = [] {
    std::map<std::string, Slot, std::less<>> all;
    for (const std::vector<std::string>& line : LinesOf("slots.txt")) {
      LW_CHECK(line.size() == 2, "a slot has a name and a pattern");
      all.emplace(line[0], Slot{PatternOf(line[1]), line[1]});
    }
    return all;
  }();
  const auto found = slots.find(name);
  return found == slots.end() ? nullptr : &found->second;
}

}  // namespace

const Pattern* SlotPattern(std::string_view slot) {
  const Slot* const found = FindSlot(slot);
  return found == nullptr ? nullptr : &found->pattern;
}

std::string_view SlotText(std::string_view slot) {
  const Slot* const found = FindSlot(slot);
  return found == nullptr ? std::string_view() : std::string_view(found->written);
}

const std::vector<std::string>& SentenceWords(std::string_view list) {
  static const std::vector<std::string> none;
  const auto found = AllLists().find(list);
  return found == AllLists().end() ? none : found->second;
}

std::string PluralNoun(std::string_view noun) {
  if (noun == "sheep") return "sheep";
  std::string plural(noun);
  const std::string_view vowels = "aeiou";
  if (EndsWith(noun, "sis")) return plural.replace(plural.size() - 2, 2, "es");
  if (EndsWith(noun, "s") || EndsWith(noun, "sh") || EndsWith(noun, "ch") || EndsWith(noun, "x")) {
    return plural + "es";
  }
  const bool y = noun.size() > 1 && noun.back() == 'y' &&
                 vowels.find(noun[noun.size() - 2]) == std::string_view::npos;
  if (!y) return plural + "s";
  plural.pop_back();
  return plural + "ies";
}

std::string SingularNoun(std::string_view list, std::string_view noun) {
  for (const std::string& word : SentenceWords(list))
    if (noun == word || noun == PluralNoun(word)) return word;
  return std::string(noun);
}

}  // namespace latticeworld
