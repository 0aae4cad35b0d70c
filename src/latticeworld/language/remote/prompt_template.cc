#include "latticeworld/language/remote/prompt_template.h"

#include <algorithm>
#include <utility>

#include "latticeworld/common/text.h"

namespace latticeworld {

Result<std::string> FillTemplate(std::string_view text, const std::vector<PromptValue>& values) {
  std::string filled;
  std::vector<bool> used(values.size(), false);
  std::vector<Violation> violations;
  while (true) {
    const std::size_t open = text.find("{{");
    filled += text.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find("}}", open);
    if (close == std::string_view::npos) {
      const std::string rest = Quote(text.substr(open), 40);
      violations.push_back({"open_brace", "", "{{ without }}: " + rest, rest});
      break;
    }
    const std::string_view name = text.substr(open + 2, close - open - 2);
    const auto value = std::find_if(values.begin(), values.end(),
                                    [&](const PromptValue& one) { return one.name == name; });
    if (value == values.end()) {
      violations.push_back(
          {"unknown_name", std::string(name), "no value is given for it", Quote(name)});
    } else {
      used[static_cast<std::size_t>(value - values.begin())] = true;
      filled += value->text;
    }
    text.remove_prefix(close + 2);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (used[i]) continue;
    violations.push_back(
        {"unused_value", std::string(values[i].name), "is not in the text", Quote(values[i].text)});
  }
  if (violations.empty()) return filled;
  const Status status = Status::FromViolations("prompt template", std::move(violations));
  return Status(StatusCode::kInternal, status.message(), status.violations());
}

std::string FillPromptFile(std::string_view text, const std::vector<PromptValue>& values) {
  std::string filled = FillTemplate(text, values).value();
  while (!filled.empty() && filled.back() == '\n') filled.pop_back();
  return filled;
}

}  // namespace latticeworld
