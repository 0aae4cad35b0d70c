// What SketchModel makes of a sketch. sketch_answers MODEL SKETCH STROKES HEIGHTS writes the
// strokes as read (uint8: none, valley, ridge), of a sketch of N x N, and the heights (float32, N x
// N).
#include <cstdio>
#include <string_view>

#include "latticeworld/common/files.h"
#include "latticeworld/relief/sketch/sketch_model.h"

namespace {

latticeworld::Status Answer(const char* model_file, const char* sketch_file,
                            const char* strokes_file, const char* out) {
  LW_ASSIGN_OR_RETURN(const latticeworld::SketchModel model,
                      latticeworld::SketchModel::Load(model_file));
  LW_ASSIGN_OR_RETURN(const std::string bytes, latticeworld::ReadFile(sketch_file, 1 << 24));
  LW_ASSIGN_OR_RETURN(const latticeworld::Sketch sketch, latticeworld::ReadSketch(bytes));
  LW_RETURN_IF_ERROR(latticeworld::WriteFile(
      strokes_file, std::string_view(reinterpret_cast<const char*>(sketch.data()), sketch.size())));
  LW_ASSIGN_OR_RETURN(const latticeworld::Grid<float> height, model.Run(sketch));
  return latticeworld::WriteFile(out, std::string_view(reinterpret_cast<const char*>(height.data()),
                                                       height.size() * sizeof(float)));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const latticeworld::Status status = Answer(argv[1], argv[2], argv[3], argv[4]);
  if (!status.ok()) std::fprintf(stderr, "%s\n", status.ToString().c_str());
  return status.ok() ? 0 : 1;
}
