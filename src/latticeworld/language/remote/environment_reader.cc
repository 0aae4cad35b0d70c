#include "latticeworld/language/remote/environment_reader.h"

#include <cstddef>
#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/keep_to_rules.h"
#include "latticeworld/language/remote/thinking_filter.h"

namespace latticeworld {
namespace {

// Objects of an answer that are looked at: hostile text cannot make the search long.
constexpr int kMostObjects = 16;

// The end of the object that begins at `begin` (one past its brace), or npos where it is cut.
std::size_t EndOfObject(std::string_view text, std::size_t begin) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && --depth == 0) {
      return i + 1;
    }
  }
  return std::string_view::npos;
}

// The outermost objects, in order; the last one may be cut.
std::vector<std::string_view> ObjectsIn(std::string_view text) {
  std::vector<std::string_view> objects;
  std::size_t at = 0;
  for (int i = 0; i < kMostObjects; ++i) {
    const std::size_t begin = text.find('{', at);
    if (begin == std::string_view::npos) break;
    const std::size_t end = EndOfObject(text, begin);
    objects.push_back(text.substr(begin, end - begin));
    // A brace of prose swallows all that follows: what stands within is looked at too.
    at = end == std::string_view::npos ? begin + 1 : end;
  }
  return objects;
}

using Parser = Result<EnvironmentConfig> (*)(std::string_view, const Catalogue&);

Result<EnvironmentConfig> ReadWith(Parser parse, std::string_view text,
                                   const Catalogue& catalogue) {
  const std::string answer = WithoutThinking(text);
  const std::vector<std::string_view> objects = ObjectsIn(answer);
  if (objects.empty()) {
    return Status::FromViolations("illegal environment",
                                  {{"no_object", "",
                                    "there is no JSON object in the answer " + Quote(answer) +
                                        "; one that obeys the schema is legal",
                                    Quote(answer)}});
  }
  for (auto object = objects.rbegin(); object != objects.rend(); ++object) {
    Result<EnvironmentConfig> environment = parse(*object, catalogue);
    if (environment.ok()) return environment;
  }
  std::string_view longest;
  for (const std::string_view object : objects) {
    if (object.size() >= longest.size()) longest = object;
  }
  return parse(longest, catalogue);
}

}  // namespace

Result<EnvironmentConfig> ReadEnvironmentAnswer(std::string_view text, const Catalogue& catalogue) {
  return ReadWith(&ParseEnvironment, text, catalogue);
}

Result<EnvironmentConfig> ReadMendedEnvironmentAnswer(std::string_view text,
                                                      const Catalogue& catalogue,
                                                      std::vector<std::string>* changes) {
  LW_ASSIGN_OR_RETURN(EnvironmentConfig environment,
                      ReadWith(&ParseUncheckedEnvironment, text, catalogue));
  *changes = KeepToRules(catalogue, &environment);
  return environment;
}

}  // namespace latticeworld
