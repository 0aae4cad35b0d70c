#include "latticeworld/dataset/writing/part_maker.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "latticeworld/common/digest.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/dataset/sources/laid_out_anew.h"
#include "latticeworld/dataset/writing/instance_images.h"
#include "latticeworld/language/remote/answer_in_form.h"
#include "latticeworld/layout/claims/claims_json.h"

namespace latticeworld {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostIdBytes = 120;
constexpr std::size_t kLengthStep = 100;  // [bytes] of a tally of lengths
constexpr char kReliefQuestion[] =
    "Describe the land that this height map shows: where it is high, where it is low, and how "
    "the heights change from one to the other. Black is the lowest, white the highest.";

bool IsIdentifier(const std::string& id) {
  const auto legal = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  return !id.empty() && id.size() <= kMostIdBytes && std::all_of(id.begin(), id.end(), legal);
}

// Whether it is about the annotator, and so would be the same for every other instance too.
bool EndsAll(const Status& status) {
  switch (status.code()) {
    case StatusCode::kCancelled:
    case StatusCode::kUnavailable:
    case StatusCode::kUnauthenticated:
    case StatusCode::kPermissionDenied:
    case StatusCode::kNotFound:
    case StatusCode::kDeadlineExceeded:
    case StatusCode::kFailedPrecondition:
      return true;
    default:
      return false;
  }
}

const char* NameOfRole(ChatRole role) {
  return role == ChatRole::kSystem ? "system" : role == ChatRole::kUser ? "user" : "assistant";
}

// All that there is of one instance until its records are written.
struct Described {
  const Instance* instance = nullptr;
  DatasetSplit split = DatasetSplit::kTrain;
  LayoutCaption layout;
  EnvironmentCaption environment;
  InstanceImages images;
  std::vector<std::string> image_paths;  // height map, sketch; empty: none
};

class PartInTheMaking {
 public:
  PartInTheMaking(const PartMaker& maker, const std::string& image_folder,
                  const PartMaker::ImageSink& sink, const Progress& progress)
      : maker_(maker), image_folder_(image_folder), sink_(sink), progress_(progress) {}

  Status AddGroup(std::size_t index) {
    LW_RETURN_IF_ERROR(progress_.CheckCancelled());
    const std::string group = maker_.source->GroupName(index);
    auto instances = maker_.source->ReadGroup(index);
    if (!instances.ok()) {
      if (instances.status().code() == StatusCode::kCancelled) return instances.status();
      part_.failed.push_back({group, "", instances.status().ToString()});
      return Status();
    }
    const DatasetSplit split = SplitOf(group, *maker_.options);
    std::size_t made = 0;
    for (Instance& instance : *instances) {
      Described described;
      described.instance = &instance;
      described.split = split;
      const Status status = instance.group == group && IsIdentifier(instance.id)
                                ? Describe(&instance, &described)
                                : Internal("the source gave the instance " + Quote(instance.id) +
                                           " of the group " + Quote(instance.group));
      if (!status.ok()) {
        if (EndsAll(status)) return status.WithContext(instance.id);
        part_.failed.push_back({group, instance.id, status.ToString()});
        continue;
      }
      LW_RETURN_IF_ERROR(KeepImages(&described));
      LW_RETURN_IF_ERROR(AddRecords(described));
      Count(described);
      ++made;
    }
    if (made > 0) Tally("groups", split);
    return Status();
  }

  DatasetPart Take() { return std::move(part_); }

 private:
  const DatasetOptions& options() const { return *maker_.options; }

  Status Describe(Instance* place, Described* described) {
    const Instance& instance = *place;
    const std::uint64_t seed = StreamSeed(options().seed, "dataset/" + instance.id);
    LW_ASSIGN_OR_RETURN(described->layout,
                        maker_.annotator->DescribeLayout(instance, seed, progress_));
    if (options().layouts == LayoutsBy::kGrounded) {
      LW_ASSIGN_OR_RETURN(place->layout, LaidOutAnew(instance, described->layout, seed, progress_));
    }
    if (options().environment) {
      LW_ASSIGN_OR_RETURN(described->environment, maker_.annotator->DescribeEnvironment(
                                                      instance, described->layout,
                                                      StreamSeed(seed, "environment"), progress_));
      LW_RETURN_IF_ERROR(Status::FromViolations("the annotator's environment",
                                                Validate(described->environment.environment)));
    }
    if (options().images && instance.relief != nullptr) {
      LW_ASSIGN_OR_RETURN(described->images,
                          DrawImages(instance.relief->height_m, options().sketch_share));
    }
    return Status();
  }

  Status KeepImages(Described* described) {
    if (described->images.height_png.empty()) return Status();
    const std::string& id = described->instance->id;
    for (const auto& [suffix, bytes] :
         {std::pair<const char*, const std::string&>{"-height.png", described->images.height_png},
          {"-sketch.png", described->images.sketch_png}}) {
      LW_RETURN_IF_ERROR(sink_(id + suffix, bytes));
      described->image_paths.push_back(image_folder_ + "/" + id + suffix);
      part_.image_sums += Sha256Hex(bytes) + "  " + described->image_paths.back() + "\n";
      ++part_.tallies["images"];
    }
    return Status();
  }

  void Tally(const std::string& what, DatasetSplit split) {
    ++part_.tallies[what + "/" + std::string(NameOf(split))];
  }

  // messages: all but the answer.
  void AddRecord(DatasetTask task, const Described& described, std::vector<ChatMessage> messages,
                 const std::string& answer, const std::vector<std::string>& images,
                 const std::string* claims) {
    messages.push_back({ChatRole::kAssistant, answer, ""});
    Json spoken = Json::array();
    for (const ChatMessage& message : messages) {
      if (message.role == ChatRole::kSystem && options().prompts == PromptForm::kShort) continue;
      spoken.push_back({{"role", NameOfRole(message.role)}, {"content", message.text}});
    }
    const Instance& instance = *described.instance;
    Json record = {{"id", instance.id},
                   {"group", instance.group},
                   {"vocabulary", NameOf(instance.layout.vocabulary)},
                   {"messages", std::move(spoken)},
                   {"images", images},
                   {"height_scale_m", described.images.height_scale_m},
                   {"height_offset_m", described.images.height_offset_m}};
    if (claims != nullptr) record["claims"] = *claims;
    std::string& lines =
        part_.lines[static_cast<std::size_t>(task)][static_cast<std::size_t>(described.split)];
    lines += record.dump(-1, ' ', false, Json::error_handler_t::replace);
    lines += '\n';
    Tally("records/" + std::string(NameOf(task)), described.split);
  }

  // How long what a person would have said is.
  void CountLength(DatasetTask task, const std::string& text) {
    char step[8];
    std::snprintf(step, sizeof(step), "%04zu",
                  std::min<std::size_t>(text.size() / kLengthStep * kLengthStep, 9900));
    const std::string name(NameOf(task));
    ++part_.tallies["length/" + name + "/" + step];
    part_.tallies["bytes/" + name] += text.size();
  }

  Status AddRecords(const Described& described) {
    const Instance& instance = *described.instance;
    const Relief* relief = instance.relief.get();
    std::string layout = ToText(instance.layout);
    layout.pop_back();  // as the grammar of answers has it
    if (options().layout) {
      LayoutRequest request;
      request.instruction = described.layout.text;
      request.vocabulary = instance.layout.vocabulary;
      request.relief = relief;
      LW_ASSIGN_OR_RETURN(auto messages, maker_.prompts->Layout(request));
      const std::string claims = EncodeClaims(described.layout.claims);
      AddRecord(DatasetTask::kLayout, described, std::move(messages), layout, described.image_paths,
                &claims);
      CountLength(DatasetTask::kLayout, described.layout.text);
    }
    if (options().environment) {
      EnvironmentRequest request;
      request.instruction = described.environment.text;
      request.layout = &instance.layout;
      request.relief = relief;
      request.size_m = options().size_m;
      LW_ASSIGN_OR_RETURN(auto messages, maker_.prompts->Environment(request));
      AddRecord(DatasetTask::kEnvironment, described, std::move(messages),
                AnswerInForm(described.environment.environment), described.image_paths, nullptr);
      CountLength(DatasetTask::kEnvironment, described.environment.text);
    }
    if (!described.image_paths.empty() && !described.layout.relief_text.empty()) {
      AddRecord(DatasetTask::kRelief, described, {{ChatRole::kUser, kReliefQuestion, ""}},
                described.layout.relief_text, {described.image_paths.front()}, nullptr);
      CountLength(DatasetTask::kRelief, described.layout.relief_text);
    }
    return Status();
  }

  void Count(const Described& described) {
    const Instance& instance = *described.instance;
    DatasetTallies& tallies = part_.tallies;
    Tally("instances", described.split);
    const std::string vocabulary(NameOf(instance.layout.vocabulary));
    ++tallies["vocabulary/" + vocabulary];
    if (instance.relief != nullptr) ++tallies["relief"];
    for (const char letter : instance.layout.cells) ++tallies["cells/" + vocabulary + "/" + letter];
    for (const Claim& claim : described.layout.claims)
      ++tallies["claims/" + std::string(NameOf(claim.kind))];
    if (!options().environment) return;
    const EnvironmentConfig& environment = described.environment.environment;
    ++tallies["season/" + std::string(NameOf(environment.coarse.season))];
    ++tallies["weather/" + std::string(NameOf(environment.coarse.weather))];
    ++tallies["time_of_day/" + std::string(NameOf(environment.coarse.time_of_day))];
    ++tallies["style/" + std::string(NameOf(environment.coarse.artistic_style))];
    for (const AgentGroup& agents : environment.agents)
      tallies["species/" + std::string(NameOf(agents.category))] +=
          static_cast<std::uint64_t>(agents.quantity);
  }

  const PartMaker& maker_;
  const std::string image_folder_;
  const PartMaker::ImageSink& sink_;
  const Progress& progress_;
  DatasetPart part_;
};

}  // namespace

Result<DatasetPart> PartMaker::Make(std::size_t first, std::size_t last,
                                    const std::string& image_folder, const ImageSink& sink,
                                    const Progress& progress,
                                    const std::function<void()>& group_done) const {
  PartInTheMaking part(*this, image_folder, sink, progress);
  for (std::size_t group = first; group < last; ++group) {
    LW_RETURN_IF_ERROR(part.AddGroup(group));
    if (group_done) group_done();
  }
  return part.Take();
}

}  // namespace latticeworld
