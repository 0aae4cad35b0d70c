#ifndef LATTICEWORLD_CATALOGUE_CATALOGUE_READER_H_
#define LATTICEWORLD_CATALOGUE_CATALOGUE_READER_H_

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "latticeworld/catalogue/catalogue.h"
#include "latticeworld/catalogue/type_file.h"

namespace latticeworld {

// Puts a catalogue together from files and finds every fault on the way.
class CatalogueReader {
 public:
  // Reads the files, in order, on top of `base` (BuiltIn()), or on top of nothing. Errors:
  // INVALID_ARGUMENT with every violation of every file.
  static Result<std::shared_ptr<const Catalogue>> Read(const Catalogue* base,
                                                       const std::vector<CatalogueFile>& files);

 private:
  explicit CatalogueReader(const Catalogue* base);

  void Merge(const std::vector<TypeFile>& files);
  void MergeModel(const ModelEntry& entry);
  void MergeDensity(const DensityEntry& entry);
  template <typename Value>
  void MergeValue(AssetType type, const char* list, const ValueEntry<Value>& entry,
                  std::vector<Value>* values);
  // Indices of the models that an entry names; what is not there is a violation.
  std::vector<std::uint8_t> ModelsNamed(AssetType type, const std::vector<std::string>& names,
                                        const std::string& pointer);
  // Whether `name` is new among the files' own names; else a violation.
  bool ClaimName(const std::string& scope, const std::string& name, const std::string& pointer);
  bool HasRoom(std::size_t count, const char* what, const std::string& pointer);
  void Finish(const std::vector<CatalogueFile>& files);
  void CheckWhole();
  void CheckModelWears(std::uint8_t model);
  std::string PointerTo(const AssetModel& model) const;

  std::shared_ptr<Catalogue> catalogue_;
  bool has_base_;  // what its own files say is built in and not added
  std::vector<Violation> violations_;
  std::map<std::string, std::string> claimed_;  // scope and name to the pointer that claimed it
  // Models that have a violation of their own and so are not there.
  std::set<std::pair<AssetType, std::string>> unread_models_;
};

}  // namespace latticeworld

#endif  // LATTICEWORLD_CATALOGUE_CATALOGUE_READER_H_
