#include "latticeworld/language/remote/environment_reader.h"

#include <string>
#include <vector>

#include "latticeworld/common/text.h"
#include "latticeworld/environment/keep_to_rules.h"
#include "latticeworld/language/remote/json_objects.h"
#include "latticeworld/language/remote/thinking_filter.h"

namespace latticeworld {
namespace {

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
