// Loads SDF files with libsdformat: check_sdf FILE... Prints each error, and "FILE: N models, M
// lights, E errors"; ends with 1 where there was one.

#include <iostream>
#include <sdf/sdf.hh>

int main(int argc, char** argv) {
  bool failed = argc < 2;
  for (int i = 1; i < argc; ++i) {
    sdf::Root root;
    const sdf::Errors errors = root.Load(argv[i]);
    for (const sdf::Error& error : errors) std::cout << error << "\n";
    const sdf::World* world = root.WorldCount() > 0 ? root.WorldByIndex(0) : nullptr;
    const auto models = world != nullptr ? world->ModelCount() : (root.Model() != nullptr ? 1 : 0);
    std::cout << argv[i] << ": " << models << " models, "
              << (world != nullptr ? world->LightCount() : 0) << " lights, " << errors.size()
              << " errors\n";
    failed = failed || !errors.empty() || models == 0;
  }
  return failed ? 1 : 0;
}
