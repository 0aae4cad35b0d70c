#include "latticeworld/relief/elevation/gdal_errors.h"

#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>

#include <mutex>

#include "latticeworld/common/text.h"

namespace latticeworld::internal {
namespace {

constexpr std::size_t kShownBytes = 300;

void CPL_STDCALL Keep(CPLErr severity, CPLErrorNum, const char* message) {
  if (severity < CE_Failure) return;
  static_cast<GdalErrors*>(CPLGetErrorHandlerUserData())->Add(message);
}

}  // namespace

void PrepareGdal() {
  static std::once_flag once;
  std::call_once(once, [] {
    GDALRegister_GTiff();
    GDALRegister_AAIGrid();
    GDALRegister_MEM();
    OSRSetPROJEnableNetwork(0);
  });
}

GdalErrors::GdalErrors() { CPLPushErrorHandlerEx(Keep, this); }
GdalErrors::~GdalErrors() { CPLPopErrorHandler(); }

std::string GdalErrors::Last(std::string_view hidden) const {
  if (last_.empty()) return "";
  std::string text = last_;
  for (std::size_t at = text.find(hidden); !hidden.empty() && at != std::string::npos;
       at = text.find(hidden)) {
    text.replace(at, hidden.size(), "it");
  }
  text = Quote(text, kShownBytes);
  return ": " + text.substr(1, text.size() - 2);
}

}  // namespace latticeworld::internal
