#include "latticeworld/campaign/stacks/program_stack.h"

#include <optional>
#include <utility>

#include "latticeworld/campaign/stacks/line_program.h"
#include "latticeworld/campaign/stacks/program_messages.h"

namespace latticeworld {
namespace {

class ProgramStack final : public RobotStack {
 public:
  explicit ProgramStack(const StackProgram& options) : options_(options) {}

  bool UsesScans() const override { return options_.scans; }

  Status Begin(const StackTask& task, const StackInput& start) override {
    LW_ASSIGN_OR_RETURN(LineProgram program, LineProgram::Start(options_.command, options_.folder));
    program_.emplace(std::move(program));
    LW_ASSIGN_OR_RETURN(
        const std::string answer,
        program_->Ask(EncodeBegin(task, start, task.control_hz), options_.answer_time_s));
    return DecodeReady(answer);
  }

  StackOutput Update(const StackInput& input) override {
    const auto output = Ask(input);
    if (output.ok()) return *output;
    StackOutput failed;
    failed.state = StackState::kFailed;
    failed.why = output.status().ToString();
    return failed;
  }

 private:
  Result<StackOutput> Ask(const StackInput& input) {
    LW_ASSIGN_OR_RETURN(const std::string answer,
                        program_->Ask(EncodeUpdate(input, options_.scans), options_.answer_time_s));
    return DecodeOutput(answer);
  }

  const StackProgram options_;
  std::optional<LineProgram> program_;
};

}  // namespace

std::unique_ptr<RobotStack> MakeProgramStack(const StackProgram& program) {
  return std::make_unique<ProgramStack>(program);
}

}  // namespace latticeworld
