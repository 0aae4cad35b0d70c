#include "tools/arguments.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <system_error>

#include "latticeworld/common/files.h"
#include "latticeworld/common/text.h"

namespace latticeworld::tools {
namespace {

// This is above the limit of every instruction, so that a text that is too long is named as such.
constexpr std::size_t kMaxTextFileBytes = 16u << 20;

template <typename T>
bool ParseWhole(const std::string& text, T* value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, *value);
  return result.ec == std::errc() && result.ptr == end;
}

// "--layout --out lake" has lost its text; taking "--out" for it would only confuse.
std::string RefuseOptionAsValue(const std::string& value) {
  if (value.rfind("--", 0) != 0) return "";
  return "needs a value, but is followed by the option " + value;
}

}  // namespace

void AddValueOption(CLI::App* command, const std::string& name, const std::string& value_name,
                    const std::string& description) {
  command
      ->add_option(
          name, [](const CLI::results_t&) { return true; }, description)
      ->type_name(value_name)
      ->check(CLI::Validator(RefuseOptionAsValue, ""));
}

std::optional<std::string> ValueOf(const CLI::App& command, const std::string& name) {
  const CLI::Option* option = command.get_option(name);
  if (option->empty()) return std::nullopt;
  return option->results().front();
}

double ArgumentReader::Number(const std::string& name, double absent) {
  const auto text = ValueOf(*command_, name);
  if (!text) return absent;
  double value = 0.0;
  if (ParseWhole(*text, &value) && std::isfinite(value)) return value;
  Refuse(name, *text, "a number");
  return absent;
}

std::int64_t ArgumentReader::Integer(const std::string& name, std::int64_t low, std::int64_t high,
                                     std::int64_t absent) {
  const auto text = ValueOf(*command_, name);
  if (!text) return absent;
  std::int64_t value = 0;
  if (ParseWhole(*text, &value) && value >= low && value <= high) return value;
  Refuse(name, *text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return absent;
}

int ArgumentReader::Whole(const std::string& name, int absent) {
  const auto text = ValueOf(*command_, name);
  if (!text) return absent;
  int value = 0;
  if (ParseWhole(*text, &value)) return value;
  Refuse(name, *text, "a whole number");
  return absent;
}

std::uint64_t ArgumentReader::Unsigned(const std::string& name, std::uint64_t absent) {
  const auto text = ValueOf(*command_, name);
  if (!text) return absent;
  std::uint64_t value = 0;
  if (ParseWhole(*text, &value)) return value;
  Refuse(name, *text,
         "a whole number from 0 to " + std::to_string(std::numeric_limits<std::uint64_t>::max()));
  return absent;
}

std::optional<std::pair<double, double>> ArgumentReader::NumberPair(const std::string& name) {
  const auto text = ValueOf(*command_, name);
  if (!text) return std::nullopt;
  const std::vector<std::string> parts = Split(*text, ',');
  std::pair<double, double> values;
  const bool legal = parts.size() == 2 && ParseWhole(parts[0], &values.first) &&
                     ParseWhole(parts[1], &values.second) && std::isfinite(values.first) &&
                     std::isfinite(values.second);
  if (legal) return values;
  Refuse(name, *text, "two numbers parted by a comma");
  return std::nullopt;
}

std::string ArgumentReader::Choice(const std::string& name, const std::vector<std::string>& legal,
                                   const std::string& absent) {
  const auto text = ValueOf(*command_, name);
  if (!text) return absent;
  if (std::find(legal.begin(), legal.end(), *text) != legal.end()) return *text;
  Refuse(name, *text, "one of " + Join(legal, ", "));
  return absent;
}

void ArgumentReader::RequireBeside(const std::string& option, const std::string& needed) {
  RequireBesideOneOf(option, {1, needed});
}

void ArgumentReader::RequireBesideOneOf(const std::string& option,
                                        const std::vector<std::string>& needed) {
  const auto given = [this](const std::string& name) {
    return !command_->get_option(name)->empty();
  };
  if (!given(option) || std::any_of(needed.begin(), needed.end(), given)) return;
  violations_.push_back({"missing_option", option,
                         "makes sense only beside " + Join(needed, " or ") + ", which is not given",
                         ""});
}

void ArgumentReader::AllowOneOf(const std::vector<std::string>& options) {
  std::vector<std::string> given;
  for (const std::string& option : options) {
    if (!command_->get_option(option)->empty()) given.push_back(option);
  }
  if (given.size() < 2) return;
  violations_.push_back({"conflict", given[1],
                         "given beside " + given[0] + "; legal is one of " + Join(options, ", "),
                         ""});
}

void ArgumentReader::AddIllegal(const FieldNames& options, std::vector<Violation> illegal) {
  Rename(options, &illegal);
  const std::vector<Violation> before = violations_;
  for (Violation& violation : illegal) {
    const bool told = std::any_of(before.begin(), before.end(), [&violation](const auto& one) {
      return one.pointer == violation.pointer;
    });
    if (!told) violations_.push_back(std::move(violation));
  }
}

Status ArgumentReader::status() const {
  return Status::FromViolations("unusable arguments", violations_);
}

void ArgumentReader::Refuse(const std::string& name, const std::string& given,
                            const std::string& legal) {
  violations_.push_back(
      {"illegal_value", name, "must be " + legal + ", not " + Quote(given), given});
}

Status UnderOptions(const FieldNames& options, const Status& status) {
  std::vector<Violation> violations = status.violations();
  if (violations.empty()) return status;
  Rename(options, &violations);
  return Status::FromViolations("unusable arguments", std::move(violations));
}

Result<std::string> TextOf(const CLI::App& command, const std::string& name) {
  const std::string text = ValueOf(command, name).value_or("");
  if (text.empty() || text[0] != '@') return text;
  auto content = ReadFile(text.substr(1), kMaxTextFileBytes);
  if (!content.ok()) return content.status().WithContext(name);
  return content;
}

int ReportFailure(const std::string& command, const Status& status) {
  std::cerr << "latticeworld " << command << ": ";
  if (status.violations().empty()) {
    std::cerr << status.message() << "\n";
  } else {
    // The message is a heading, then the violations in one line; here each has its own.
    const Violation& first = status.violations().front();
    const std::string heading = status.message().substr(
        0, status.message().find(first.pointer.empty() ? first.message : first.pointer + ": "));
    std::cerr << heading.substr(0, std::min(heading.find(" ("), heading.rfind(": "))) << "\n";
    for (const Violation& violation : status.violations()) {
      std::cerr << "  " << violation.pointer << (violation.pointer.empty() ? "" : ": ")
                << violation.message << "\n";
    }
  }
  return status.code() == StatusCode::kInvalidArgument ? kExitUsage : kExitFailure;
}

}  // namespace latticeworld::tools
