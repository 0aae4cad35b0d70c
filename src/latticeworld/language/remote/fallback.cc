#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/common/check.h"
#include "latticeworld/language/remote/remote.h"

namespace latticeworld {
namespace {

// Layout and environment fall back by the same rule.
template <typename Generator, typename Request, typename Answer>
class FallbackGenerator final : public Generator {
 public:
  FallbackGenerator(std::string part, std::unique_ptr<Generator> first,
                    std::unique_ptr<Generator> second)
      : part_(std::move(part)), first_(std::move(first)), second_(std::move(second)) {
    LW_CHECK(first_ != nullptr && second_ != nullptr, "a fallback needs two generators");
  }

  std::string_view name() const override { return first_->name(); }

  Result<Answer> Generate(const Request& request, const Progress& progress,
                          std::vector<ModelReply>* replies) override {
    // INVALID_ARGUMENT of the first may mean that its server refused what it was sent; a request
    // that is wrong itself gets no second answer.
    LW_RETURN_IF_ERROR(latticeworld::Validate(request));
    Result<Answer> answer = first_->Generate(request, progress, replies);
    if (answer.ok() || answer.status().code() == StatusCode::kCancelled) return answer;
    LW_RETURN_IF_ERROR(progress.CheckCancelled());
    ModelReply failed;
    failed.purpose = part_;
    failed.failure = answer.status();
    replies->push_back(std::move(failed));
    const std::string why =
        std::string(first_->name()) + " back end failed (" + answer.status().ToString() + ")";
    Result<Answer> other = second_->Generate(request, progress, replies);
    if (!other.ok()) return other.status().WithContext("after the " + why);
    other->warnings.insert(other->warnings.begin(), "the " + std::string(second_->name()) +
                                                        " back end answered, because the " + why);
    return other;
  }

 private:
  std::string part_;  // purpose of the record of a failure
  std::unique_ptr<Generator> first_;
  std::unique_ptr<Generator> second_;
};

}  // namespace

std::unique_ptr<LayoutGenerator> MakeFallbackLayoutGenerator(
    std::unique_ptr<LayoutGenerator> first, std::unique_ptr<LayoutGenerator> second) {
  return std::make_unique<FallbackGenerator<LayoutGenerator, LayoutRequest, LayoutAnswer>>(
      "layout", std::move(first), std::move(second));
}

std::unique_ptr<EnvironmentGenerator> MakeFallbackEnvironmentGenerator(
    std::unique_ptr<EnvironmentGenerator> first, std::unique_ptr<EnvironmentGenerator> second) {
  return std::make_unique<
      FallbackGenerator<EnvironmentGenerator, EnvironmentRequest, EnvironmentAnswer>>(
      "environment", std::move(first), std::move(second));
}

}  // namespace latticeworld
