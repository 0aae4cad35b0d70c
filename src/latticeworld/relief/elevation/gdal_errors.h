#ifndef LATTICEWORLD_RELIEF_ELEVATION_GDAL_ERRORS_H_
#define LATTICEWORLD_RELIEF_ELEVATION_GDAL_ERRORS_H_

#include <string>
#include <string_view>

namespace latticeworld::internal {

// Makes GDAL ready: the formats that elevation is read from and no others, no network. Any number
// of calls from any threads.
void PrepareGdal();

// While it lives, this thread's GDAL and PROJ say nothing on stderr; the last thing that they
// complained of is kept. To be destroyed by the thread that made it.
class GdalErrors {
 public:
  GdalErrors();
  ~GdalErrors();
  GdalErrors(const GdalErrors&) = delete;
  GdalErrors& operator=(const GdalErrors&) = delete;

  // Keeps a complaint, for the handler.
  void Add(std::string_view message) { last_ = message; }
  // ": <the last complaint>" without `hidden` (the name of a file in memory); "" when there is
  // none.
  std::string Last(std::string_view hidden) const;

 private:
  std::string last_;
};

}  // namespace latticeworld::internal

#endif  // LATTICEWORLD_RELIEF_ELEVATION_GDAL_ERRORS_H_
