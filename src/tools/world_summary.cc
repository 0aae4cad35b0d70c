#include "tools/world_summary.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <tuple>

#include "latticeworld/common/text.h"

namespace latticeworld::tools {
namespace {

// Longest part of an instruction that is shown [bytes].
constexpr std::size_t kShownTextBytes = 400;

std::string Fixed(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), "%.*f", decimals, value);
  return buffer;
}

// "layout       rest": one aligned line.
void PrintLine(std::string_view label, const std::string& text, std::ostream* out) {
  std::string padded(label);
  padded.resize(13, ' ');
  *out << padded << text << "\n";
}

// ", 100 m from black to white, from 0 m": what the picture's kind looks at.
std::string VisualOptions(const GenerationRequest& request) {
  const std::string scale = FormatDouble(request.height_map.height_scale_m) + " m from ";
  const std::string offset = ", from " + FormatDouble(request.height_map.height_offset_m) + " m";
  switch (request.visual_kind) {
    case VisualKind::kNone:
      break;
    case VisualKind::kHeightMap:
      return ", " + scale + "black to white" + offset;
    case VisualKind::kSketch:
      return ", " + scale + "lowest to highest" + offset + ", " + request.sketch_translator;
    case VisualKind::kElevation:
      return request.elevation.keep_altitude ? ", altitudes kept" : ", lowest point at 0 m";
  }
  return "";
}

void PrintPlace(const std::optional<GeoOrigin>& geo, std::ostream* out) {
  if (!geo) return;
  PrintLine("place",
            "latitude " + Fixed(geo->latitude_deg, 6) + ", longitude " +
                Fixed(geo->longitude_deg, 6) + ", z = 0 at " + Fixed(geo->altitude_m, 1) + " m",
            out);
}

void PrintRequest(const GenerationRequest& request, std::ostream* out) {
  PrintLine("layout", Quote(request.layout_instruction, kShownTextBytes), out);
  PrintLine("environment", Quote(request.environment_instruction, kShownTextBytes), out);
  if (request.visual_kind != VisualKind::kNone) {
    PrintLine("picture",
              std::string(NameOf(request.visual_kind)) + ", " +
                  std::to_string(request.visual.size()) + " bytes" + VisualOptions(request),
              out);
  }
  PrintLine("seed", std::to_string(request.seed), out);
  PrintLine("vocabulary", request.vocabulary, out);
  PrintLine("reader", request.reader, out);
  PrintLine("generator", request.generator, out);
}

void PrintTerrain(const Terrain& terrain, std::ostream* out) {
  const GridGeometry& geometry = terrain.geometry();
  const std::string cells = std::to_string(geometry.rows());
  PrintLine("size",
            FormatDouble(geometry.size_m()) + " m at " + FormatDouble(geometry.resolution_m()) +
                " m (" + cells + " x " + cells + " cells)",
            out);
  std::size_t wet = 0;
  for (const float level : terrain.water_level_m) wet += std::isnan(level) ? 0 : 1;
  const double water_share = static_cast<double>(wet) / terrain.water_level_m.size();
  PrintLine("ground",
            "from " + Fixed(terrain.ground.min_m(), 2) + " m to " +
                Fixed(terrain.ground.max_m(), 2) + " m, " + Fixed(100.0 * water_share, 1) +
                " % under water",
            out);
}

// What each bridge of a road is, carries and clears.
void PrintBridges(const std::vector<Bridge>& bridges, std::ostream* out) {
  constexpr std::size_t kMostShown = 8;
  for (std::size_t i = 0; i < std::min(bridges.size(), kMostShown); ++i) {
    const Bridge& bridge = bridges[i];
    PrintLine(i == 0 ? "bridges" : "",
              std::string(NameOf(bridge.kind)) + ", " + Fixed(bridge.length_m(), 1) + " m long, " +
                  Fixed(bridge.width_m, 1) + " m wide, carries " +
                  Fixed(bridge.load_kg / 1000.0, 1) + " t, clears the water by " +
                  Fixed(bridge.clearance_m(), 1) + " m",
              out);
  }
  if (bridges.size() <= kMostShown) return;
  PrintLine("", "and " + std::to_string(bridges.size() - kMostShown) + " more", out);
}

void PrintCoarse(const CoarseAttributes& coarse, std::ostream* out) {
  PrintLine("coarse",
            std::string(NameOf(coarse.terrain_type)) + ", " + std::string(NameOf(coarse.season)) +
                ", " + std::string(NameOf(coarse.artistic_style)) + ", " +
                std::string(NameOf(coarse.weather)) + ", " +
                std::string(NameOf(coarse.time_of_day)),
            out);
}

void PrintAgents(const std::vector<AgentStart>& agents, std::ostream* out) {
  std::map<std::tuple<AgentCategory, AgentState>, int> counts;
  for (const AgentStart& agent : agents) ++counts[{agent.category, agent.state}];
  std::string text = std::to_string(agents.size());
  std::string_view separator = ": ";
  for (const auto& [key, count] : counts) {
    text.append(separator).append(std::to_string(count)).append(" ");
    text.append(NameOf(std::get<0>(key))).append(" (").append(NameOf(std::get<1>(key))).append(")");
    separator = ", ";
  }
  PrintLine("agents", text, out);
}

void PrintAssets(const std::vector<Asset>& assets, std::ostream* out) {
  std::map<AssetKind, int> counts;
  for (const Asset& asset : assets) ++counts[asset.kind];
  std::string text = std::to_string(assets.size());
  std::string_view separator = ": ";
  for (const auto& [kind, count] : counts) {
    text.append(separator).append(std::to_string(count)).append(" ").append(NameOf(kind));
    separator = ", ";
  }
  PrintLine("assets", text, out);
}

void PrintProps(const std::vector<Prop>& props, std::ostream* out) {
  std::map<PropKind, int> counts;
  for (const Prop& prop : props) ++counts[prop.kind];
  std::string text = std::to_string(props.size());
  std::string_view separator = ": ";
  for (const auto& [kind, count] : counts) {
    text.append(separator).append(std::to_string(count)).append(" ").append(NameOf(kind));
    separator = ", ";
  }
  PrintLine("elements", text, out);
}

void PrintStages(const std::vector<StageTime>& stages, std::ostream* out) {
  double total = 0.0;
  std::string text;
  for (const StageTime& stage : stages) {
    total += stage.seconds;
    text += stage.name + " " + Fixed(stage.seconds, 2) + " s, ";
  }
  PrintLine("stages", text + "together " + Fixed(total, 2) + " s", out);
}

}  // namespace

void PrintSummary(const World& world, bool color, std::ostream* out) {
  *out << (color ? ToColoredText(world.layout) : ToText(world.layout)) << "\n";
  PrintLine("world", world.id, out);
  PrintRequest(world.request, out);
  PrintPlace(world.geo, out);
  PrintTerrain(*world.scene->terrain, out);
  PrintBridges(world.scene->terrain->bridges, out);
  PrintCoarse(world.environment.coarse, out);
  PrintAgents(world.scene->agents, out);
  PrintAssets(world.scene->assets, out);
  PrintProps(world.scene->props, out);
  PrintStages(world.stages, out);
  for (const std::string& warning : world.warnings) PrintLine("warning", warning, out);
}

bool StandardOutputIsTerminal() { return ::isatty(STDOUT_FILENO) == 1; }

}  // namespace latticeworld::tools
