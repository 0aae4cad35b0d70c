#include <cstdint>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/language/reading/instruction_reader.h"

namespace latticeworld {
namespace {

enum class FallsBackOf : std::uint8_t { kAnyFailure, kLongTexts };

class FallbackReader final : public InstructionReader {
 public:
  FallbackReader(std::shared_ptr<InstructionReader> first,
                 std::shared_ptr<InstructionReader> second, FallsBackOf of)
      : first_(std::move(first)), second_(std::move(second)), of_(of) {
    LW_CHECK(first_ != nullptr && second_ != nullptr, "a fallback needs two readers");
  }

  std::string_view name() const override { return first_->name(); }
  bool reads_by_kind() const override { return first_->reads_by_kind(); }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                   std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(RefuseWrong(request));
    Result<LayoutReading> reading = first_->ReadLayout(request, progress, replies);
    if (!Failed(reading.status())) return reading;
    const std::string warning = Record(kLayoutWords, reading.status(), replies);
    reading = second_->ReadLayout(request, progress, replies);
    if (reading.ok()) reading->plan.warnings.insert(reading->plan.warnings.begin(), warning);
    return reading;
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& progress,
                                             std::vector<ModelReply>* replies) override {
    LW_RETURN_IF_ERROR(RefuseWrong(request));
    Result<EnvironmentReading> reading = first_->ReadEnvironment(request, progress, replies);
    if (!Failed(reading.status())) return reading;
    const std::string warning = Record(kEnvironmentWords, reading.status(), replies);
    reading = second_->ReadEnvironment(request, progress, replies);
    if (reading.ok()) reading->heard.warnings.insert(reading->heard.warnings.begin(), warning);
    return reading;
  }

 private:
  // A request that is wrong itself gets no second reading; it is never too long.
  template <typename Request>
  Status RefuseWrong(const Request& request) const {
    return of_ == FallsBackOf::kAnyFailure ? latticeworld::Validate(request) : Status();
  }

  bool Failed(const Status& status) const {
    if (of_ == FallsBackOf::kLongTexts) return status.code() == StatusCode::kResourceExhausted;
    return !status.ok() && status.code() != StatusCode::kCancelled;
  }

  // Keeps what the first reader failed of, and gives the warning of it.
  std::string Record(std::string_view purpose, const Status& failure,
                     std::vector<ModelReply>* replies) const {
    ModelReply failed;
    failed.purpose = purpose;
    failed.failure = failure;
    replies->push_back(std::move(failed));
    return "the reader " + std::string(second_->name()) + " read the text, because the reader " +
           std::string(first_->name()) + " failed (" + failure.ToString() + ")";
  }

  const std::shared_ptr<InstructionReader> first_;
  const std::shared_ptr<InstructionReader> second_;
  const FallsBackOf of_;
};

class FailedReader final : public InstructionReader {
 public:
  FailedReader(std::shared_ptr<InstructionReader> reader, std::vector<ModelReply> layout,
               std::vector<ModelReply> environment)
      : reader_(std::move(reader)),
        layout_(std::move(layout)),
        environment_(std::move(environment)) {
    LW_CHECK(reader_ != nullptr, "a reader is there");
  }

  std::string_view name() const override { return reader_->name(); }
  bool reads_by_kind() const override { return reader_->reads_by_kind(); }

  Result<LayoutReading> ReadLayout(const LayoutRequest& request, const Progress& progress,
                                   std::vector<ModelReply>* replies) override {
    if (layout_.empty()) return reader_->ReadLayout(request, progress, replies);
    return Fail(layout_, replies);
  }

  Result<EnvironmentReading> ReadEnvironment(const EnvironmentRequest& request,
                                             const Progress& progress,
                                             std::vector<ModelReply>* replies) override {
    if (environment_.empty()) return reader_->ReadEnvironment(request, progress, replies);
    return Fail(environment_, replies);
  }

 private:
  static Status Fail(const std::vector<ModelReply>& recorded, std::vector<ModelReply>* replies) {
    replies->insert(replies->end(), recorded.begin(), recorded.end() - 1);
    return recorded.back().failure;
  }

  const std::shared_ptr<InstructionReader> reader_;
  const std::vector<ModelReply> layout_;
  const std::vector<ModelReply> environment_;
};

}  // namespace

std::shared_ptr<InstructionReader> MakeFallbackReader(std::shared_ptr<InstructionReader> first,
                                                      std::shared_ptr<InstructionReader> second) {
  return std::make_shared<FallbackReader>(std::move(first), std::move(second),
                                          FallsBackOf::kAnyFailure);
}

std::shared_ptr<InstructionReader> MakeLongTextReader(std::shared_ptr<InstructionReader> first,
                                                      std::shared_ptr<InstructionReader> second) {
  return std::make_shared<FallbackReader>(std::move(first), std::move(second),
                                          FallsBackOf::kLongTexts);
}

std::shared_ptr<InstructionReader> MakeFailedReader(std::shared_ptr<InstructionReader> reader,
                                                    std::vector<ModelReply> layout,
                                                    std::vector<ModelReply> environment) {
  return std::make_shared<FailedReader>(std::move(reader), std::move(layout),
                                        std::move(environment));
}

}  // namespace latticeworld
