#include "latticeworld/language/remote/answer_in_form.h"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "latticeworld/environment/fine_parameter.h"
#include "latticeworld/environment/rules.h"
#include "latticeworld/language/remote/number_steps.h"

namespace latticeworld {
namespace {

const NumberSteps& StepsOf(FineParameter parameter) {
  static const std::array<NumberSteps, kFineParameterCount> steps = {
      NumberSteps(RangeOf(FineParameter::kDensity)), NumberSteps(RangeOf(FineParameter::kRoll)),
      NumberSteps(RangeOf(FineParameter::kPitch)),   NumberSteps(RangeOf(FineParameter::kYaw)),
      NumberSteps(RangeOf(FineParameter::kScale)),   NumberSteps(RangeOf(FineParameter::kHeight)),
      NumberSteps(RangeOf(FineParameter::kWind)),    NumberSteps(RangeOf(FineParameter::kSlope))};
  return steps[static_cast<std::size_t>(parameter)];
}

double Rounded(double value, const NumberSteps& steps, const NumberBound& bound) {
  double nearest = value;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < steps.count(); ++i) {
    const double distance = std::abs(steps.At(i) - value);
    if (distance < least && BreachOf(bound, steps.At(i)).empty()) {
      least = distance;
      nearest = steps.At(i);
    }
  }
  return nearest;
}

}  // namespace

void RoundToForm(EnvironmentConfig* environment, const Catalogue& catalogue) {
  for (const auto& type : EnumNames(AssetType{})) {
    const FineBounds bounds = BoundsOf(environment->coarse, type.value, catalogue);
    FineAttribute& fine = environment->fine_of(type.value);
    for (const auto& entry : EnumNames(FineParameter{})) {
      const FineParameter parameter = entry.value;
      if (const std::optional<NumberBound>& bound = bounds.number(parameter))
        SetValue(parameter, Rounded(ValueOf(fine, parameter), StepsOf(parameter), *bound), &fine);
    }
  }
}

std::string AnswerInForm(const EnvironmentConfig& environment, const Catalogue& catalogue) {
  using Json = nlohmann::ordered_json;
  Json answer = Json::parse(ToJson(environment, catalogue));
  for (const auto& type : EnumNames(AssetType{})) {
    for (const auto& entry : EnumNames(FineParameter{})) {
      if (!StepsOf(entry.value).whole() ||
          !HasParameter(catalogue.ValuesOf(type.value), entry.value))
        continue;
      Json& number =
          answer["fine"][std::string(type.name)][Json::json_pointer(PointerOf(entry.value))];
      const double value = number.get<double>();
      if (value == std::floor(value)) number = static_cast<int>(value);
    }
  }
  return answer.dump();
}

}  // namespace latticeworld
