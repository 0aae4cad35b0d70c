#include "latticeworld/exporting/simulators/obj_mesh.h"

#include <cstdio>

#include "latticeworld/exporting/ground_mesh.h"
#include "latticeworld/rendering/ray/ray_sky.h"

namespace latticeworld {
namespace {

void AppendLine(const char* keyword, const Eigen::Vector3f& v, std::string* text) {
  char line[96];
  std::snprintf(line, sizeof line, "%s %.6g %.6g %.6g\n", keyword, static_cast<double>(v.x()),
                static_cast<double>(v.y()), static_cast<double>(v.z()));
  *text += line;
}

// Vertices, then normals and faces part by part; palette: parts are columns of a picture instead of
// materials.
std::string MeshText(const Mesh& mesh, bool palette) {
  std::string text;
  for (const Eigen::Vector3f& vertex : mesh.vertices) AppendLine("v", vertex, &text);
  std::string faces;
  std::size_t normals = 0, columns = 0;
  for (int part = 0; part < kMeshPartCount; ++part) {
    bool named = false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (mesh.parts[i] != static_cast<MeshPart>(part)) continue;
      if (!named && palette) {
        AppendLine("vt", {(static_cast<float>(part) + 0.5f) / kMeshPartCount, 0.5f, 0.0f}, &text);
        ++columns;
      } else if (!named) {
        faces += std::string("usemtl ") + NameOf(mesh.parts[i]) + "\n";
      }
      named = true;
      const auto& triangle = mesh.triangles[i];
      const Eigen::Vector3f& a = mesh.vertices[triangle[0]];
      const Eigen::Vector3f normal =
          (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a).normalized();
      AppendLine("vn", normal, &text);
      ++normals;
      const std::string column = palette ? std::to_string(columns) : "";
      faces += "f";
      for (const std::uint32_t corner : triangle)
        faces += " " + std::to_string(corner + 1) + "/" + column + "/" + std::to_string(normals);
      faces += "\n";
    }
  }
  return text + faces;
}

}  // namespace

std::string ToObj(const Mesh& mesh, const std::string& material_file) {
  return "mtllib " + material_file + "\n" + MeshText(mesh, /*palette=*/false);
}

std::string ToPaletteObj(const Mesh& mesh) { return MeshText(mesh, /*palette=*/true); }

std::string ToMtl(const ModelColors& colors) {
  std::string text;
  for (int part = 0; part < kMeshPartCount; ++part) {
    text += std::string("newmtl ") + NameOf(static_cast<MeshPart>(part)) + "\n";
    const Eigen::Vector3f shown = colors[part].unaryExpr([](float c) { return FromLinear(c); });
    AppendLine("Ka", shown, &text);
    AppendLine("Kd", shown, &text);
    AppendLine("Ks", Eigen::Vector3f::Zero(), &text);
    text += "d 1\n";
  }
  return text;
}

std::string ToObj(const SurfaceMesh& mesh, const Eigen::Vector3f& offset_m) {
  std::string text;
  for (const Eigen::Vector3f& position : mesh.positions_m) {
    const Eigen::Vector3f moved = position + offset_m;
    AppendLine("v", moved, &text);
  }
  for (const Eigen::Vector3f& normal : mesh.normals) AppendLine("vn", normal, &text);
  for (std::size_t i = 0; i < mesh.corners.size(); i += 3) {
    text += "f";
    for (std::size_t k = i; k < i + 3; ++k) {
      const std::string number = std::to_string(mesh.corners[k] + 1);
      text += " " + number + "//" + number;
    }
    text += "\n";
  }
  return text;
}

}  // namespace latticeworld
