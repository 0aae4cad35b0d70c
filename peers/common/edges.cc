// What ODE, Embree and OpenCV's networks do at the edges of what is asked of them: one line a
// question, "name: figures". Argument: a folder with float.onnx, half.onnx and relu.onnx.
#include <embree3/rtcore.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <opencv2/dnn.hpp>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr int kSide = 9;  // samples a side, a metre apart

struct Contacts {
  int count = 0;
  double least_up = 1.0, deepest = 0.0;
};

// Contacts of a ball, or of a ray that begins at z and points down, with a level field of z = 1,
// one of whose samples can be NaN.
Contacts BallOn(double x, double z, bool nan, bool ray = false) {
  std::vector<float> heights(kSide * kSide, 1.0f);
  if (nan) heights[4 * kSide + 4] = std::numeric_limits<float>::quiet_NaN();
  dHeightfieldDataID data = dGeomHeightfieldDataCreate();
  dGeomHeightfieldDataBuildSingle(data, heights.data(), 1, kSide - 1, kSide - 1, kSide, kSide, 1, 0,
                                  1, 0);
  dGeomHeightfieldDataSetBounds(data, 0.0, 2.0);
  dGeomID field = dCreateHeightfield(nullptr, data, 1);
  dMatrix3 up;  // ODE's fields have y up
  dRFromAxisAndAngle(up, 1, 0, 0, M_PI / 2);
  dGeomSetRotation(field, up);
  dGeomID ball = ray ? dCreateRay(nullptr, 5.0) : dCreateSphere(nullptr, 0.3);
  if (ray) {
    dGeomRaySet(ball, x, 0.0, z, 0.0, 0.0, -1.0);
  } else {
    dGeomSetPosition(ball, x, 0.0, z);
  }
  dContactGeom found[32];
  Contacts contacts;
  contacts.count = dCollide(ball, field, 32, found, sizeof(dContactGeom));
  for (int i = 0; i < contacts.count; ++i) {
    contacts.least_up = std::min(contacts.least_up, static_cast<double>(found[i].normal[2]));
    contacts.deepest = std::max(contacts.deepest, static_cast<double>(found[i].depth));
  }
  dGeomDestroy(ball);
  dGeomDestroy(field);
  dGeomHeightfieldDataDestroy(data);
  return contacts;
}

void Say(const char* name, const Contacts& contacts) {
  std::printf("%s: %d contacts, normals' z at least %.3f, depth %.3f\n", name, contacts.count,
              contacts.least_up, contacts.deepest);
}

void AskOde() {
  dInitODE();
  Say("ode ball on level ground", BallOn(0.5, 1.25, false));
  Say("ode ball over a NaN", BallOn(0.0, 1.25, true));
  Say("ode ball beside a NaN", BallOn(0.8, 1.25, true));
  Contacts border;
  for (int i = 0; i < 200; ++i) {  // along and across borders of cells and their diagonals
    const Contacts one = BallOn(i * 0.01, 1.25, false);
    border.count = i == 0 ? one.count : std::min(border.count, one.count);
    border.least_up = std::min(border.least_up, one.least_up);
    border.deepest = std::max(border.deepest, one.deepest);
  }
  Say("ode ball at borders of cells", border);
  Say("ode ray from exactly the ground", BallOn(0.3, 1.0, false, true));
  Say("ode ray from 0.1 m above", BallOn(0.3, 1.1, false, true));
  Say("ode ball with its centre 0.1 m below", BallOn(0.5, 0.9, false));
  Say("ode ball with its centre 0.5 m below", BallOn(0.5, 0.5, false));
  dCloseODE();
}

struct Triangle {
  float corners[3][3];
};

// The first meeting of a ray straight along `way` from `begin`.
float Meets(RTCScene scene, const float (&begin)[3], const float (&way)[3],
            unsigned* id = nullptr) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray = {};
  ray.ray.org_x = begin[0], ray.ray.org_y = begin[1], ray.ray.org_z = begin[2];
  ray.ray.dir_x = way[0], ray.ray.dir_y = way[1], ray.ray.dir_z = way[2];
  ray.ray.tfar = std::numeric_limits<float>::infinity();
  ray.ray.mask = ~0u;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &ray);
  if (id != nullptr) *id = ray.hit.primID;
  return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1.0f : ray.ray.tfar;
}

RTCScene SceneOf(RTCDevice device, const std::vector<Triangle>& triangles, bool robust) {
  RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* corners = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
      mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) corners[i] = triangles[i];
  for (unsigned i = 0; i < 3 * triangles.size(); ++i) indices[i] = i;
  rtcCommitGeometry(mesh);
  RTCScene scene = rtcNewScene(device);
  if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(scene);
  return scene;
}

// A sheet of two triangles far from the origin, tilted, whose diagonal rays are sent along.
int Slipping(RTCDevice device, bool robust) {
  const float a[3] = {1000.1f, 2000.3f, 10.0f}, b[3] = {1004.7f, 2000.3f, 11.3f};
  const float c[3] = {1004.7f, 2004.9f, 12.9f}, d[3] = {1000.1f, 2004.9f, 10.7f};
  const auto triangle = [](const float* p, const float* q, const float* r) {
    Triangle made;
    for (int k = 0; k < 3; ++k)
      made.corners[0][k] = p[k], made.corners[1][k] = q[k], made.corners[2][k] = r[k];
    return made;
  };
  RTCScene scene = SceneOf(device, {triangle(a, b, c), triangle(a, c, d)}, robust);
  int slipped = 0;
  for (int i = 1; i < 20000; ++i) {
    const float t = static_cast<float>(i) / 20000.0f;
    const float aim[3] = {a[0] + t * (c[0] - a[0]), a[1] + t * (c[1] - a[1]),
                          a[2] + t * (c[2] - a[2])};
    const float way[3] = {0.37f, -0.21f, -1.0f};
    const float begin[3] = {aim[0] - 50 * way[0], aim[1] - 50 * way[1], aim[2] - 50 * way[2]};
    slipped += Meets(scene, begin, way) < 0.0f;
  }
  rtcReleaseScene(scene);
  return slipped;
}

void AskEmbree() {
  RTCDevice device = rtcNewDevice("threads=1");
  const Triangle level = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  RTCScene scene = SceneOf(device, {level}, false);
  std::printf("embree from exactly the surface: down %g, up %g, from 1e-7 above down %g\n",
              Meets(scene, {1, 1, 0}, {0, 0, -1}), Meets(scene, {1, 1, 0}, {0, 0, 1}),
              Meets(scene, {1, 1, 1e-7f}, {0, 0, -1}));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  RTCScene damaged = SceneOf(
      device, {level, {{{0, 0, nan}, {4, 0, 1}, {0, 4, 1}}}, {{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}}}},
      false);
  unsigned id = 0;
  const float distance = Meets(damaged, {1, 1, 5}, {0, 0, -1}, &id);
  std::printf("embree beside a triangle with a NaN: met triangle %u at %g\n", id, distance);
  std::printf("embree along an edge: %d of 19999 slip through, %d with the flag robust\n",
              Slipping(device, false), Slipping(device, true));
  rtcReleaseScene(damaged);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

cv::Mat Answer(const std::string& file, const cv::Mat& given) {
  cv::dnn::Net net = cv::dnn::readNetFromONNX(file);
  net.setInput(given);
  return net.forward().clone();
}

void AskOpenCv(const std::string& folder) {
  const int shape[] = {1, 1, 16, 16};
  cv::Mat given(4, shape, CV_32F);
  cv::randu(given, -1.0, 1.0);
  const cv::Mat whole = Answer(folder + "/float.onnx", given);
  try {
    const cv::Mat half = Answer(folder + "/half.onnx", given);
    std::printf("opencv half floats: off by %.2g at most of values to %.2g\n",
                cv::norm(whole, half, cv::NORM_INF), cv::norm(whole, cv::NORM_INF));
  } catch (const cv::Exception& error) {
    std::printf("opencv half floats: refused: %s\n", error.err.c_str());
  }
  cv::Mat with_nan = given.clone();
  with_nan.ptr<float>()[8 * 16 + 8] = std::numeric_limits<float>::quiet_NaN();
  const auto nans = [](const cv::Mat& values) {
    int count = 0;
    for (std::size_t i = 0; i < values.total(); ++i) count += std::isnan(values.ptr<float>()[i]);
    return count;
  };
  std::printf("opencv one NaN in: %d NaN out of a convolution, %d out of one with a ReLU\n",
              nans(Answer(folder + "/float.onnx", with_nan)),
              nans(Answer(folder + "/relu.onnx", with_nan)));
  bool same = true;
  const auto work = [&](bool* agreed) {
    for (int i = 0; i < 50; ++i) {
      *agreed =
          *agreed && cv::norm(Answer(folder + "/float.onnx", given), whole, cv::NORM_INF) == 0.0;
    }
  };
  bool first = true, second = true;
  std::thread other(work, &second);
  work(&first);
  other.join();
  same = first && second;
  std::printf("opencv two threads with a network each: %s\n", same ? "the same" : "others");
}

}  // namespace

int main(int argc, char** argv) {
  AskOde();
  AskEmbree();
  if (argc > 1) AskOpenCv(argv[1]);
  return 0;
}
