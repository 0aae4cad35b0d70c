#ifndef LATTICEWORLD_TESTS_EXPORTING_GLB_READER_H_
#define LATTICEWORLD_TESTS_EXPORTING_GLB_READER_H_

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace latticeworld {

// A GLB taken apart again, by the format's specification alone.
class GlbReader {
 public:
  // Expects a whole file: chunks that fill it, every view in the buffer and every accessor in its
  // view.
  explicit GlbReader(const std::string& glb);

  const nlohmann::json& json() const { return json_; }
  // The node of that name; null: there is none.
  const nlohmann::json* Node(const std::string& name) const;
  // The nodes below the one of that name; empty: it is not there.
  std::vector<const nlohmann::json*> Children(const std::string& name) const;
  // Numbers of an accessor, components of a prop side by side; normalized ones in [-1, 1].
  std::vector<double> Read(int accessor) const;
  std::vector<Eigen::Vector3d> ReadVectors(int accessor) const;

 private:
  nlohmann::json json_;
  std::string binary_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_TESTS_EXPORTING_GLB_READER_H_
