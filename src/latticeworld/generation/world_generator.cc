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
#include "latticeworld/generation/visual.h"
#include "latticeworld/language/reading/relief/relief_reading.h"
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
  auto world = std::make_shared<World>();
  StageRunner stages(progress);
  const auto add_warnings = [&world](std::vector<std::string> warnings) {
    for (std::string& warning : warnings) world->warnings.push_back(std::move(warning));
  };

  LW_ASSIGN_OR_RETURN(const GridGeometry geometry,
                      GridGeometry::Create(request.size_m, request.resolution_m));
  LW_ASSIGN_OR_RETURN(const std::optional<Relief> relief, stages.Run("relief", [&] {
    return ReadVisual(request, sketches, geometry, progress);
  }));
  const Relief* relief_pointer = relief ? &*relief : nullptr;
  if (relief) {
    world->geo = relief->geo;
    add_warnings(relief->warnings);
  }

  LayoutReading layout_reading;
  LW_ASSIGN_OR_RETURN(LayoutAnswer layout, stages.Run("layout", [&]() -> Result<LayoutAnswer> {
    LayoutRequest layout_request;
    layout_request.instruction = request.layout_instruction;
    layout_request.vocabulary = *FromName<Vocabulary>(request.vocabulary);
    layout_request.relief = relief_pointer;
    layout_request.seed = StreamSeed(request.seed, "layout");
    LW_ASSIGN_OR_RETURN(layout_reading,
                        reader->ReadLayout(layout_request, progress, &world->replies));
    ReadRelief(request.layout_instruction, &layout_reading);
    layout_request.reading = &layout_reading;
    return generator->layout->Generate(layout_request, progress, &world->replies);
  }));
  world->layout = std::move(layout.layout);
  add_warnings(std::move(layout.warnings));

  EnvironmentReading environment_reading;
  LW_ASSIGN_OR_RETURN(
      EnvironmentAnswer environment, stages.Run("environment", [&]() -> Result<EnvironmentAnswer> {
        EnvironmentRequest environment_request;
        environment_request.instruction = request.environment_instruction;
        environment_request.relief = relief_pointer;
        environment_request.layout = &world->layout;
        environment_request.size_m = request.size_m;
        environment_request.catalogue = catalogue;
        environment_request.seed = StreamSeed(request.seed, "environment");
        LW_ASSIGN_OR_RETURN(
            environment_reading,
            reader->ReadEnvironment(environment_request, progress, &world->replies));
        environment_request.reading = &environment_reading;
        return generator->environment->Generate(environment_request, progress, &world->replies);
      }));
  world->environment = std::move(environment.environment);
  add_warnings(std::move(environment.warnings));
  world->fidelity =
      AssessFidelity(layout_reading, environment_reading, world->layout, world->environment);
  AddTerrainType(environment_reading, &layout_reading);
  if (relief) add_warnings(ReliefLeftAlone(layout_reading.plan.reliefs));
  LW_ASSIGN_OR_RETURN(
      const std::vector<ThingWish> things,
      WishedThings(request.things, layout_reading.plan, *catalogue, world->layout.vocabulary));

  LW_ASSIGN_OR_RETURN(Terrain terrain, stages.Run("terrain", [&] {
    TerrainRequest terrain_request;
    terrain_request.geometry = geometry;
    terrain_request.layout = &world->layout;
    terrain_request.relief = relief_pointer;
    if (!relief) terrain_request.reliefs = layout_reading.plan.reliefs;
    terrain_request.covers = layout_reading.plan.covers;
    terrain_request.seed = StreamSeed(request.seed, "terrain");
    terrain_request.options.fords = FordsRivers(request.layout_instruction, request.size_m);
    return BuildTerrain(terrain_request, progress);
  }));

  AssessReliefFidelity(layout_reading, world->layout, terrain, &world->fidelity);

  LW_ASSIGN_OR_RETURN(SceneAnswer scene, stages.Run("scene", [&] {
    SceneRequest scene_request;
    scene_request.terrain = std::make_shared<const Terrain>(std::move(terrain));
    scene_request.catalogue = catalogue;
    scene_request.environment = world->environment;
    scene_request.things = things;
    if (world->geo) scene_request.latitude_deg = world->geo->latitude_deg;
    scene_request.seed = StreamSeed(request.seed, "scene");
    return BuildScene(scene_request, progress);
  }));
  world->scene = std::move(scene.scene);
  add_warnings(std::move(scene.warnings));
  add_warnings(CrossingWarnings(request.layout_instruction, world->layout, *world->scene));
  AddThings(MeasureThings(*world->scene, things), &world->fidelity);
  add_warnings(WarningsOf(world->fidelity, world->warnings));

  LW_RETURN_IF_ERROR(progress.CheckCancelled());
  world->request = std::move(request);
  world->stages = stages.TakeStages();
  world->id = ContentId(world->layout, *world->scene, world->geo);
  return std::shared_ptr<const World>(std::move(world));
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
