#include "latticeworld/generation/world_generator.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <string_view>
#include <utility>

#include "latticeworld/common/check.h"
#include "latticeworld/common/random.h"
#include "latticeworld/common/text.h"
#include "latticeworld/generation/bundle/things_json.h"
#include "latticeworld/generation/bundle/world_id.h"
#include "latticeworld/generation/fidelity/crossing_words.h"
#include "latticeworld/generation/fidelity/reading_difference.h"
#include "latticeworld/generation/visual.h"
#include "latticeworld/language/reading/relief/relief_reading.h"
#include "latticeworld/language/reading/words/subjects.h"
#include "latticeworld/terrain/forms/relief_claims.h"

namespace latticeworld {
namespace {

// What `status` says, as violations: its own, or itself as one about `pointer`.
void Append(const Status& status, std::string_view pointer, std::vector<Violation>* violations) {
  if (status.ok()) return;
  if (status.violations().empty()) {
    violations->push_back({"illegal_value", std::string(pointer), status.message(), ""});
    return;
  }
  violations->insert(violations->end(), status.violations().begin(), status.violations().end());
}

void CheckTexts(const GenerationRequest& request, std::vector<Violation>* violations) {
  const bool has_relief = request.visual_kind != VisualKind::kNone;
  Append(ValidateLayoutInstruction(request.layout_instruction, has_relief), "layout_instruction",
         violations);
  Append(ValidateEnvironmentInstruction(request.environment_instruction), "environment_instruction",
         violations);
}

template <typename Value>
std::vector<std::string> NamesOf(const std::map<std::string, Value>& by_name) {
  std::vector<std::string> names;
  for (const auto& [name, value] : by_name) names.push_back(name);
  return names;
}

// A violation where a name is given that is not among the legal ones.
void CheckName(const char* member, const std::string& name, const std::vector<std::string>& legal,
               const std::string& otherwise, std::vector<Violation>* violations) {
  if (name.empty() || std::find(legal.begin(), legal.end(), name) != legal.end()) return;
  violations->push_back(
      {"unknown_value", member,
       "is " + Quote(name) + "; legal are " + Join(legal, ", ") + ", or none for " + otherwise,
       name});
}

Vocabulary ResolveVocabulary(const GenerationRequest& request) {
  if (!request.vocabulary.empty()) return *FromName<Vocabulary>(request.vocabulary);
  // The method's suburban scenes have no relief, so a relief without words is a wild one.
  if (request.layout_instruction.empty()) return Vocabulary::kWild;
  return ChooseVocabulary(request.layout_instruction);
}

// Runs the stages of one generation: reports, times and names the failure of each, and stops
// between two of them once the caller cancels.
class StageRunner {
 public:
  explicit StageRunner(const Progress& progress) : progress_(progress) {}

  template <typename Function>  // a function that gives a Result
  auto Run(std::string_view name, Function&& function) -> decltype(function()) {
    LW_RETURN_IF_ERROR(progress_.CheckCancelled());
    progress_.Report(name, 0.0);
    const auto start = std::chrono::steady_clock::now();
    auto result = function();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (!result.ok()) return result.status().WithContext(name);
    stages_.push_back({std::string(name), elapsed.count()});
    progress_.Report(name, 1.0);
    return result;
  }

  std::vector<StageTime> TakeStages() { return std::move(stages_); }

 private:
  const Progress& progress_;
  std::vector<StageTime> stages_;
};

// The way of one request: each stage makes a part of the world from those before it.
class WorldStages {
 public:
  WorldStages(GenerationRequest request, std::shared_ptr<const Catalogue> catalogue,
              const Progress& progress)
      : request_(std::move(request)),
        catalogue_(std::move(catalogue)),
        progress_(progress),
        stages_(progress) {}

  // What is given of the land's form: nothing, a height map, a sketch or real elevation.
  Status ReadLand(const SketchTranslator& sketches) {
    LW_ASSIGN_OR_RETURN(geometry_, GridGeometry::Create(request_.size_m, request_.resolution_m));
    LW_ASSIGN_OR_RETURN(relief_, stages_.Run("relief", [&] {
      return ReadVisual(request_, sketches, geometry_, progress_);
    }));
    if (!relief_) return Status();
    world_->geo = relief_->geo;
    Warn(relief_->warnings);
    return Status();
  }

  Status MakeLayout(InstructionReader* reader, LanguageGenerator* generator) {
    const auto make = [&]() -> Result<LayoutAnswer> {
      LayoutRequest request;
      request.instruction = request_.layout_instruction;
      request.vocabulary = *FromName<Vocabulary>(request_.vocabulary);
      request.relief = relief();
      request.seed = StreamSeed(request_.seed, "layout");
      LW_ASSIGN_OR_RETURN(layout_reading_,
                          reader->ReadLayout(request, progress_, &world_->replies));
      ReadRelief(request_.layout_instruction, &layout_reading_);
      request.reading = &layout_reading_;
      return generator->layout->Generate(request, progress_, &world_->replies);
    };
    LW_ASSIGN_OR_RETURN(LayoutAnswer layout, stages_.Run("layout", make));
    world_->layout = std::move(layout.layout);
    Warn(std::move(layout.warnings));
    return Status();
  }

  Status MakeEnvironment(InstructionReader* reader, LanguageGenerator* generator) {
    const auto make = [&]() -> Result<EnvironmentAnswer> {
      EnvironmentRequest request;
      request.instruction =
          EnvironmentText(request_.layout_instruction, request_.environment_instruction);
      request.relief = relief();
      request.layout = &world_->layout;
      request.size_m = request_.size_m;
      request.catalogue = catalogue_;
      request.seed = StreamSeed(request_.seed, "environment");
      LW_ASSIGN_OR_RETURN(environment_reading_,
                          reader->ReadEnvironment(request, progress_, &world_->replies));
      request.reading = &environment_reading_;
      return generator->environment->Generate(request, progress_, &world_->replies);
    };
    LW_ASSIGN_OR_RETURN(EnvironmentAnswer environment, stages_.Run("environment", make));
    world_->environment = std::move(environment.environment);
    Warn(std::move(environment.warnings));
    if (reader->reads_by_kind()) {
      Warn(WarningsOfUnread(request_.layout_instruction, request_.environment_instruction));
    }
    return Status();
  }

  // Measures what was said of layout and environment, and leaves what was said of the land's form
  // and of single things to the stages after.
  Status AssessWords() {
    world_->fidelity =
        AssessFidelity(layout_reading_, environment_reading_, world_->layout, world_->environment);
    AddTerrainType(environment_reading_, &layout_reading_);
    if (relief_) Warn(ReliefLeftAlone(layout_reading_.plan.reliefs));
    LW_ASSIGN_OR_RETURN(things_, WishedThings(request_.things, layout_reading_.plan, *catalogue_,
                                              world_->layout.vocabulary));
    return Status();
  }

  Status MakeTerrain() {
    LW_ASSIGN_OR_RETURN(Terrain terrain, stages_.Run("terrain", [&] {
      TerrainRequest request;
      request.geometry = geometry_;
      request.layout = &world_->layout;
      request.relief = relief();
      if (!relief_) request.reliefs = layout_reading_.plan.reliefs;
      request.covers = layout_reading_.plan.covers;
      request.seed = StreamSeed(request_.seed, "terrain");
      request.options.fords = FordsRivers(request_.layout_instruction, request_.size_m);
      request.options.bridge_kind = BridgeKindAskedFor(request_.layout_instruction);
      return BuildTerrain(request, progress_);
    }));
    AssessReliefFidelity(layout_reading_, world_->layout, terrain, &world_->fidelity);
    terrain_ = std::make_shared<const Terrain>(std::move(terrain));
    return Status();
  }

  Status MakeScene() {
    LW_ASSIGN_OR_RETURN(SceneAnswer scene, stages_.Run("scene", [&] {
      SceneRequest request;
      request.terrain = terrain_;
      request.catalogue = catalogue_;
      request.environment = world_->environment;
      request.things = things_;
      if (world_->geo) request.latitude_deg = world_->geo->latitude_deg;
      request.seed = StreamSeed(request_.seed, "scene");
      return BuildScene(request, progress_);
    }));
    world_->scene = std::move(scene.scene);
    Warn(std::move(scene.warnings));
    Warn(CrossingWarnings(request_.layout_instruction, world_->layout, *world_->scene));
    AddThings(MeasureThings(*world_->scene, things_), &world_->fidelity);
    Warn(WarningsOf(world_->fidelity, world_->warnings));
    Warn(DifferenceWarnings(layout_reading_, environment_reading_, world_->layout,
                            world_->environment, world_->warnings));
    return Status();
  }

  std::shared_ptr<const World> TakeWorld() {
    world_->request = std::move(request_);
    world_->stages = stages_.TakeStages();
    world_->id = ContentId(world_->layout, *world_->scene, world_->geo);
    return std::move(world_);
  }

 private:
  const Relief* relief() const { return relief_ ? &*relief_ : nullptr; }
  void Warn(std::vector<std::string> warnings) {
    for (std::string& warning : warnings) world_->warnings.push_back(std::move(warning));
  }

  GenerationRequest request_;
  const std::shared_ptr<const Catalogue> catalogue_;
  const Progress& progress_;
  StageRunner stages_;
  std::shared_ptr<World> world_ = std::make_shared<World>();
  GridGeometry geometry_;
  std::optional<Relief> relief_;
  LayoutReading layout_reading_;
  EnvironmentReading environment_reading_;
  std::vector<ThingWish> things_;
  std::shared_ptr<const Terrain> terrain_;
};

using WorldResult = Result<std::shared_ptr<const World>>;

// What `function` gives, or the Status of what it throws: a defect of a stage or of a library below
// it must not end the program that asked. The size and the resolution are those of the request.
template <typename Function>
WorldResult WithoutExceptions(double size_m, double resolution_m, Function&& function) {
  try {
    return function();
  } catch (const std::bad_alloc&) {
    return ResourceExhausted("not enough memory for a world of " + FormatDouble(size_m) + " m at " +
                             FormatDouble(resolution_m) +
                             " m; ask for a smaller size or a coarser resolution");
  } catch (const std::exception& error) {
    return Internal(std::string("generation failed: ") + error.what());
  }
}

Result<std::shared_ptr<const World>> RunStages(GenerationRequest request, InstructionReader* reader,
                                               LanguageGenerator* generator,
                                               const SketchTranslator& sketches,
                                               const std::shared_ptr<const Catalogue>& catalogue,
                                               const Progress& progress) {
  WorldStages stages(std::move(request), catalogue, progress);
  LW_RETURN_IF_ERROR(stages.ReadLand(sketches));
  LW_RETURN_IF_ERROR(stages.MakeLayout(reader, generator));
  LW_RETURN_IF_ERROR(stages.MakeEnvironment(reader, generator));
  LW_RETURN_IF_ERROR(stages.AssessWords());
  LW_RETURN_IF_ERROR(stages.MakeTerrain());
  LW_RETURN_IF_ERROR(stages.MakeScene());
  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  return stages.TakeWorld();
}

}  // namespace

WorldGenerator::WorldGenerator(LanguageStack language, SketchTranslator sketches,
                               std::shared_ptr<const Catalogue> catalogue)
    : language_(std::move(language)),
      sketches_(std::move(sketches)),
      catalogue_(std::move(catalogue)) {
  LW_CHECK(catalogue_ != nullptr, "worlds are furnished from a catalogue");
  LW_CHECK(language_.readers.count(language_.default_reader) == 1,
           "the default reader is among the readers");
  LW_CHECK(language_.generators.count(language_.default_generator) == 1,
           "the default generator is among the generators");
  for (const auto& [name, reader] : language_.readers) {
    LW_CHECK(reader != nullptr, "a reader is there");
  }
  for (const auto& [name, generator] : language_.generators) {
    LW_CHECK(generator.layout != nullptr && generator.environment != nullptr,
             "a generator answers for layout and environment");
  }
}

std::vector<std::string> WorldGenerator::reader_names() const { return NamesOf(language_.readers); }

std::vector<std::string> WorldGenerator::generator_names() const {
  return NamesOf(language_.generators);
}

Status WorldGenerator::Validate(const GenerationRequest& request) const {
  std::vector<Violation> violations;
  CheckTexts(request, &violations);
  for (Violation& violation : ValidateVisual(request, sketches_))
    violations.push_back(std::move(violation));
  if (!request.vocabulary.empty() && !FromName<Vocabulary>(request.vocabulary)) {
    violations.push_back({"unknown_value", "vocabulary",
                          "is " + Quote(request.vocabulary) + "; legal are " +
                              LegalNames<Vocabulary>() + ", or none to let the text decide",
                          request.vocabulary});
  }
  // The text of a request without a vocabulary may choose either.
  if (const auto things = ParseThings(
          request.things, *catalogue_,
          FromName<Vocabulary>(request.vocabulary).value_or(ResolveVocabulary(request)));
      !things.ok()) {
    Append(things.status(), "things", &violations);
  }
  CheckName("reader", request.reader, reader_names(), language_.default_reader, &violations);
  CheckName("generator", request.generator, generator_names(), language_.default_generator,
            &violations);
  if (request.seed == 0) {
    violations.push_back({"out_of_range", "seed", "is 0; draw one from 1 to 2^64 - 1", "0"});
  }
  if (const auto geometry = GridGeometry::Create(request.size_m, request.resolution_m);
      !geometry.ok()) {
    Append(geometry.status(), "size", &violations);
  }
  return Status::FromViolations("unusable request", std::move(violations));
}

Result<AcceptedRequest> WorldGenerator::Accept(GenerationRequest request) const {
  LW_RETURN_IF_ERROR(Validate(request));
  return AcceptedRequest(std::move(request));
}

Result<std::shared_ptr<const World>> WorldGenerator::Generate(const GenerationRequest& request,
                                                              const Progress& progress) {
  return WithoutExceptions(request.size_m, request.resolution_m, [&]() -> WorldResult {
    LW_ASSIGN_OR_RETURN(AcceptedRequest accepted, Accept(request));
    return Make(std::move(accepted), progress);
  });
}

Result<std::shared_ptr<const World>> WorldGenerator::Generate(AcceptedRequest request,
                                                              const Progress& progress) {
  return WithoutExceptions(request->size_m, request->resolution_m,
                           [&] { return Make(std::move(request), progress); });
}

Result<std::shared_ptr<const World>> WorldGenerator::Make(AcceptedRequest request,
                                                          const Progress& progress) {
  GenerationRequest resolved = std::move(request).Take();
  resolved.vocabulary = std::string(NameOf(ResolveVocabulary(resolved)));
  if (resolved.reader.empty()) resolved.reader = language_.default_reader;
  if (resolved.generator.empty()) resolved.generator = language_.default_generator;
  ResolveVisual(sketches_, &resolved);
  InstructionReader* reader = language_.readers.at(resolved.reader).get();
  LanguageGenerator* generator = &language_.generators.at(resolved.generator);
  return RunStages(std::move(resolved), reader, generator, sketches_, catalogue_, progress);
}

}  // namespace latticeworld
