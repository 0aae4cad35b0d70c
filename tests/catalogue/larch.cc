#include "catalogue/larch.h"

#include <gtest/gtest.h>

namespace latticeworld {

std::string LarchFile() {
  return R"({
  "type": "forest",
  "sources": ["Wood Handbook, western larch, green"],
  "season_variants": [
    {"name": "green larch", "seasons": ["spring", "summer"], "models": ["larch"],
     "color": {"spring": ["#8fae5a", "#a2bd6b"], "summer": ["#6c8c45", "#7f9c55"]},
     "foliage": 0.9, "growth": 1.0, "snow": 0.0, "lidar_reflectance": 0.45,
     "radar_sigma0_db": -9, "source": "estimate",
     "ground": {"friction": 1.0, "rolling_resistance": 1.0, "cone_index": 1.0}},
    {"name": "golden larch", "seasons": ["autumn"], "models": ["larch"],
     "color": {"autumn": ["#c49a35", "#d6ae4c"]},
     "foliage": 0.8, "growth": 1.0, "snow": 0.0, "lidar_reflectance": 0.45,
     "radar_sigma0_db": -9},
    {"name": "bare larch", "seasons": ["winter"], "models": ["larch"],
     "color": {"winter": ["#7a6248", "#8c7355"]},
     "foliage": 0.0, "growth": 1.0, "snow": 0.2, "lidar_reflectance": 0.35,
     "radar_sigma0_db": -12}
  ],
  "materials": [
    {"name": "larch bark", "models": ["larch"], "color": ["#7d5a48", "#94705c"],
     "density_kgpm3": 780, "elastic_modulus_pa": 1.01e10, "bending_strength_pa": 5.3e7,
     "lidar_reflectance": 0.36, "radar_sigma0_db": -10, "source": "estimate",
     "ground": {"friction": 1.0, "rolling_resistance": 1.0, "cone_index": 1.0}}
  ],
  "models": [
    {"name": "larch", "kind": "tree", "shape": "conifer_tree", "collision": "trunk",
     "height_m": {"mean": 24, "deviation": 4, "low": 14, "high": 36},
     "crown_per_trunk": 18.5, "crown_base": 0.3, "crown_widest": 0.2, "droop": 0.3,
     "share": 0.7,
     "habitat": {"altitude": {"low": 0.5, "high": 1.0, "fade": 0.2},
                 "slope_deg": {"low": 0, "high": 40, "fade": 10},
                 "wetness": {"low": 0.2, "high": 0.7, "fade": 0.2},
                 "northness": {"low": -1, "high": 1, "fade": 0.5},
                 "shade_tolerance": 0.1, "clumping": 0.5},
     "letters": {"suburb": "FG", "wild": "F"},
     "wood": {"density_kgpm3": 780, "elastic_modulus_pa": 1.01e10, "bending_strength_pa": 5.3e7},
     "source": "estimate"}
  ],
  "density": [{"kind": "tree", "suburb": {"G": 8}, "wild": {"F": 900}}]
})";
}

std::vector<std::string> FaultsOf(const std::vector<CatalogueFile>& files) {
  const auto catalogue = Catalogue::Extended(files);
  std::vector<std::string> faults;
  if (catalogue.ok()) return faults;
  EXPECT_EQ(catalogue.status().code(), StatusCode::kInvalidArgument);
  for (const Violation& violation : catalogue.status().violations()) {
    EXPECT_NE(violation.message, "");
    faults.push_back(violation.code + " " + violation.pointer);
  }
  EXPECT_FALSE(faults.empty());
  return faults;
}

std::vector<std::string> FaultsOf(const std::string& text) {
  return FaultsOf(std::vector<CatalogueFile>{{"user.json", text}});
}

}  // namespace latticeworld
