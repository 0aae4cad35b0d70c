#include "latticeworld/language/grounded/environment/inflection.h"

#include <array>
#include <cstddef>

#include "latticeworld/common/text.h"

namespace latticeworld {
namespace {

struct Irregular {
  std::string_view verb;
  std::string_view past;
};
constexpr std::array<Irregular, 44> kIrregular = {{
    {"stand", "stood"}, {"sleep", "slept"},   {"sit", "sat"},      {"lie", "lay"},
    {"keep", "kept"},   {"hold", "held"},     {"run", "ran"},      {"drive", "drove"},
    {"make", "made"},   {"do", "did"},        {"sneak", "snuck"},  {"creep", "crept"},
    {"leap", "leapt"},  {"go", "went"},       {"be", "been"},      {"feed", "fed"},
    {"eat", "ate"},     {"swim", "swam"},     {"dive", "dove"},    {"break", "broke"},
    {"cut", "cut"},     {"fly", "flew"},      {"ride", "rode"},    {"wing", "winged"},
    {"give", "gave"},   {"come", "came"},     {"fight", "fought"}, {"wage", "waged"},
    {"lay", "laid"},    {"strike", "struck"}, {"shoot", "shot"},   {"set", "set"},
    {"fall", "fell"},   {"burn", "burnt"},    {"lean", "leant"},   {"kneel", "knelt"},
    {"take", "took"},   {"catch", "caught"},  {"have", "had"},     {"seek", "sought"},
    {"bear", "bore"},   {"slink", "slunk"},   {"hang", "hung"},    {"draw", "drew"},
}};

bool IsVowel(char c) { return c == 'a' || c == 'e' || c == 'i' || c == 'o' || c == 'u'; }

// "swim", "patrol": the last consonant doubles before -ing and -ed.
bool Doubles(std::string_view word) {
  if (word == "patrol") return true;
  const std::size_t n = word.size();
  if (n < 3) return false;
  const char last = word[n - 1];
  if (IsVowel(last) || last == 'w' || last == 'x' || last == 'y') return false;
  if (!IsVowel(word[n - 2]) || IsVowel(word[n - 3])) return false;
  int vowels = 0;
  for (const char c : word) vowels += IsVowel(c) ? 1 : 0;
  return vowels == 1;
}

std::string WithS(std::string_view word) {
  const std::size_t n = word.size();
  if (n > 1 && word[n - 1] == 'y' && !IsVowel(word[n - 2])) {
    return std::string(word.substr(0, n - 1)) + "ies";
  }
  for (const std::string_view end : {"s", "x", "z", "ch", "sh"}) {
    if (EndsWith(word, end)) return std::string(word) + "es";
  }
  if (word == "go" || word == "do") return std::string(word) + "es";
  return std::string(word) + "s";
}

std::string WithIng(std::string_view word) {
  if (word == "be") return "being";
  if (word == "lie") return "lying";
  if (EndsWith(word, "e") && !EndsWith(word, "ee")) {
    return std::string(word.substr(0, word.size() - 1)) + "ing";
  }
  if (Doubles(word)) return std::string(word) + word.back() + "ing";
  return std::string(word) + "ing";
}

std::string WithEd(std::string_view word) {
  for (const Irregular& entry : kIrregular) {
    if (entry.verb == word) return std::string(entry.past);
  }
  const std::size_t n = word.size();
  if (EndsWith(word, "e")) return std::string(word) + "d";
  if (n > 1 && word[n - 1] == 'y' && !IsVowel(word[n - 2])) {
    return std::string(word.substr(0, n - 1)) + "ied";
  }
  if (Doubles(word)) return std::string(word) + word.back() + "ed";
  return std::string(word) + "ed";
}

}  // namespace

std::string PluralOf(std::string_view noun) {
  const std::size_t cut = noun.rfind(' ');
  if (cut == std::string_view::npos) return WithS(noun);
  return std::string(noun.substr(0, cut + 1)) + WithS(noun.substr(cut + 1));
}

std::vector<std::string> FormsOf(std::string_view verb) {
  const std::size_t cut = verb.find(' ');
  const std::string_view first = verb.substr(0, cut);
  const std::string rest(cut == std::string_view::npos ? std::string_view() : verb.substr(cut));
  if (first == "not") return {std::string(verb)};
  std::vector<std::string> forms = {std::string(verb), WithS(first) + rest, WithIng(first) + rest,
                                    WithEd(first) + rest};
  // "patroling", "swiming": often written so.
  if (first.size() > 3 && Doubles(first)) {
    forms.push_back(std::string(first) + "ing" + rest);
    if (EndsWith(WithEd(first), "ed")) forms.push_back(std::string(first) + "ed" + rest);
  }
  return forms;
}

}  // namespace latticeworld
