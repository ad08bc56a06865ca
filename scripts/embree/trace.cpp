// Traces the rays that `ray_rates --export` wrote with Embree 3 and compares rates and hits with those of ENDLESS.
//
//   trace TOWN.scene TOWN.rays [--fast] [--flat]
//
// --fast leaves out RTC_SCENE_FLAG_ROBUST: rays may then slip through edges, which ENDLESS never lets them.
// --flat lays all instances out as triangles of one mesh: no second level, and many times the memory.
//
// The layout of the files is told in crates/endless_city/examples/ray_rates/export.rs.

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr unsigned THREADS = 2;
constexpr unsigned ROUNDS = 7;
constexpr size_t CHUNK = 512;
// Share of the rays that may hit in one program and miss in the other: those that graze an edge.
constexpr double TOLERANCE = 1e-3;

[[noreturn]] void fail(const std::string &reason) {
  std::fprintf(stderr, "error: %s\n", reason.c_str());
  std::exit(1);
}

class Reader {
 public:
  explicit Reader(const char *path) : file_(std::fopen(path, "rb")), path_(path) {
    if (!file_) fail("cannot open " + path_);
  }
  ~Reader() { std::fclose(file_); }
  Reader(const Reader &) = delete;
  Reader &operator=(const Reader &) = delete;

  template <typename T>
  void into(T *to, size_t count) {
    if (std::fread(to, sizeof(T), count, file_) != count) fail(path_ + " is too short");
  }
  template <typename T>
  T one() {
    T value;
    into(&value, 1);
    return value;
  }

 private:
  std::FILE *file_;
  std::string path_;
};

struct Mesh {
  std::vector<float> vertices;
  std::vector<uint32_t> indices;
};

struct Instance {
  uint32_t mesh;
  float world_from_object[12];
};

struct Town {
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
};

// As it lies in the file: what Embree calls RTCRay8, without what is the same for all.
struct Packet {
  uint32_t mask;
  float origin[3][8], direction[3][8], tfar[8];
};

struct RaySet {
  char name[17];
  bool any_hit;
  uint32_t hits;
  float rates[3];
  std::vector<Packet> packets;
  size_t rays;
};

Town read_town(const char *path) {
  Reader in(path);
  Town town;
  town.meshes.resize(in.one<uint32_t>());
  for (Mesh &mesh : town.meshes) {
    const uint32_t vertices = in.one<uint32_t>(), triangles = in.one<uint32_t>();
    mesh.vertices.resize(3 * size_t(vertices));
    mesh.indices.resize(3 * size_t(triangles));
    in.into(mesh.vertices.data(), mesh.vertices.size());
    in.into(mesh.indices.data(), mesh.indices.size());
  }
  town.instances.resize(in.one<uint32_t>());
  for (Instance &instance : town.instances) {
    instance.mesh = in.one<uint32_t>();
    in.into(instance.world_from_object, 12);
  }
  return town;
}

std::vector<RaySet> read_rays(const char *path) {
  Reader in(path);
  std::vector<RaySet> sets(in.one<uint32_t>());
  for (RaySet &set : sets) {
    in.into(set.name, 16);
    set.name[16] = 0;
    set.any_hit = in.one<uint32_t>() != 0;
    set.hits = in.one<uint32_t>();
    in.into(set.rates, 3);
    set.packets.resize(in.one<uint32_t>());
    in.into(set.packets.data(), set.packets.size());
    set.rays = 0;
    for (const Packet &packet : set.packets) set.rays += __builtin_popcount(packet.mask);
  }
  return sets;
}

// The instances of a town as one mesh.
Town flattened(const Town &town) {
  Town flat;
  flat.meshes.resize(1);
  Mesh &all = flat.meshes[0];
  for (const Instance &instance : town.instances) {
    const Mesh &mesh = town.meshes[instance.mesh];
    const float *m = instance.world_from_object;
    const uint32_t base = uint32_t(all.vertices.size() / 3);
    for (size_t i = 0; i < mesh.vertices.size(); i += 3) {
      const float *v = &mesh.vertices[i];
      for (int k = 0; k < 3; ++k) all.vertices.push_back(m[k] * v[0] + m[3 + k] * v[1] + m[6 + k] * v[2] + m[9 + k]);
    }
    for (const uint32_t index : mesh.indices) all.indices.push_back(base + index);
  }
  flat.instances = {{0, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}}};
  return flat;
}

RTCGeometry triangles(RTCDevice device, const Mesh &mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void *vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                           mesh.vertices.size() / 3);
  void *indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t),
                                          mesh.indices.size() / 3);
  std::memcpy(vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof(float));
  std::memcpy(indices, mesh.indices.data(), mesh.indices.size() * sizeof(uint32_t));
  rtcCommitGeometry(geometry);
  return geometry;
}

RTCScene new_scene(RTCDevice device, bool robust) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  return scene;
}

void attach(RTCScene scene, RTCGeometry geometry) {
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

// One level where there is but one instance, else two.
RTCScene build(RTCDevice device, const Town &town, bool robust) {
  RTCScene top = new_scene(device, robust);
  if (town.instances.size() == 1) {
    attach(top, triangles(device, town.meshes[0]));
    rtcCommitScene(top);
    return top;
  }
  std::vector<RTCScene> scenes;
  for (const Mesh &mesh : town.meshes) {
    scenes.push_back(new_scene(device, robust));
    if (!mesh.indices.empty()) attach(scenes.back(), triangles(device, mesh));
    rtcCommitScene(scenes.back());
  }
  for (const Instance &instance : town.instances) {
    RTCGeometry placed = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(placed, scenes[instance.mesh]);
    rtcSetGeometryTransform(placed, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, instance.world_from_object);
    rtcCommitGeometry(placed);
    attach(top, placed);
  }
  rtcCommitScene(top);
  return top;
}

bool hits1(RTCScene scene, const Packet &packet, unsigned lane, bool any_hit) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit hit;
  hit.ray.org_x = packet.origin[0][lane];
  hit.ray.org_y = packet.origin[1][lane];
  hit.ray.org_z = packet.origin[2][lane];
  hit.ray.dir_x = packet.direction[0][lane];
  hit.ray.dir_y = packet.direction[1][lane];
  hit.ray.dir_z = packet.direction[2][lane];
  hit.ray.tnear = 0;
  hit.ray.tfar = packet.tfar[lane];
  hit.ray.time = 0;
  hit.ray.mask = ~0u;
  hit.ray.id = 0;
  hit.ray.flags = 0;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  if (any_hit) {
    rtcOccluded1(scene, &context, &hit.ray);
    return hit.ray.tfar < 0;
  }
  rtcIntersect1(scene, &context, &hit);
  return hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

unsigned trace1(RTCScene scene, const RaySet &set, const Packet &packet) {
  unsigned found = 0;
  for (unsigned lane = 0; lane < 8; ++lane)
    if (packet.mask >> lane & 1) found += hits1(scene, packet, lane, set.any_hit);
  return found;
}

unsigned trace8(RTCScene scene, const RaySet &set, const Packet &packet) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  // Rays of one bake pattern leave from points side by side in directions that are alike; scattered ones do not.
  const bool coherent = std::strcmp(set.name, "scattered") != 0;
  context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  alignas(32) int valid[8];
  RTCRayHit8 hit;
  std::memcpy(hit.ray.org_x, packet.origin[0], sizeof hit.ray.org_x);
  std::memcpy(hit.ray.org_y, packet.origin[1], sizeof hit.ray.org_y);
  std::memcpy(hit.ray.org_z, packet.origin[2], sizeof hit.ray.org_z);
  std::memcpy(hit.ray.dir_x, packet.direction[0], sizeof hit.ray.dir_x);
  std::memcpy(hit.ray.dir_y, packet.direction[1], sizeof hit.ray.dir_y);
  std::memcpy(hit.ray.dir_z, packet.direction[2], sizeof hit.ray.dir_z);
  std::memcpy(hit.ray.tfar, packet.tfar, sizeof hit.ray.tfar);
  for (unsigned lane = 0; lane < 8; ++lane) {
    valid[lane] = packet.mask >> lane & 1 ? -1 : 0;
    hit.ray.tnear[lane] = 0;
    hit.ray.time[lane] = 0;
    hit.ray.mask[lane] = ~0u;
    hit.ray.id[lane] = lane;
    hit.ray.flags[lane] = 0;
    hit.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
  }
  unsigned found = 0;
  if (set.any_hit) {
    rtcOccluded8(valid, scene, &context, &hit.ray);
    for (unsigned lane = 0; lane < 8; ++lane) found += valid[lane] && hit.ray.tfar[lane] < 0;
  } else {
    rtcIntersect8(valid, scene, &context, &hit);
    for (unsigned lane = 0; lane < 8; ++lane) found += valid[lane] && hit.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
  }
  return found;
}

using Trace = unsigned (*)(RTCScene, const RaySet &, const Packet &);

// Processor time of this thread, so that other work on the machine does not count.
double busy_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

struct Pass {
  double seconds;
  size_t hits;
};

// Traces a set with all threads, as `ray_rates` does.
Pass pass(RTCScene scene, const RaySet &set, Trace trace) {
  std::atomic<size_t> next{0}, hits{0};
  std::vector<double> busy(THREADS);
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < THREADS; ++t)
    threads.emplace_back([&, t] {
      // As Embree's manual asks of every thread that traces.
      _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
      _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
      const double start = busy_seconds();
      size_t sum = 0;
      for (size_t first; (first = CHUNK * next++) < set.packets.size();)
        for (size_t i = first; i < std::min(first + CHUNK, set.packets.size()); ++i)
          sum += trace(scene, set, set.packets[i]);
      hits += sum;
      busy[t] = busy_seconds() - start;
    });
  for (std::thread &thread : threads) thread.join();
  double seconds = 0;
  for (const double b : busy) seconds += b / THREADS;
  return {seconds, hits};
}

}  // namespace

int main(int count, char **arguments) {
  if (count < 3) fail("usage: trace TOWN.scene TOWN.rays [--fast] [--flat]");
  bool robust = true, flat = false;
  for (int i = 3; i < count; ++i) {
    if (!std::strcmp(arguments[i], "--fast")) robust = false;
    if (!std::strcmp(arguments[i], "--flat")) flat = true;
  }
  Town town = read_town(arguments[1]);
  if (flat) town = flattened(town);
  const std::vector<RaySet> sets = read_rays(arguments[2]);
  RTCDevice device = rtcNewDevice(nullptr);
  timespec before, after;
  clock_gettime(CLOCK_MONOTONIC, &before);
  RTCScene scene = build(device, town, robust);
  clock_gettime(CLOCK_MONOTONIC, &after);
  std::printf("Embree %ld.%ld.%ld, %s, %s, built in %.1f s\n",
              long(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION_MAJOR)),
              long(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION_MINOR)),
              long(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION_PATCH)), robust ? "robust" : "fast",
              flat ? "flat" : "instances",
              double(after.tv_sec - before.tv_sec) + 1e-9 * double(after.tv_nsec - before.tv_nsec));
  std::printf("%-10s %9s %9s | %8s %8s %8s | %7s %7s %7s   Mrays/s of %u threads; ours / Embree\n", "rays",
              "Embree 1", "Embree 8", "single", "packets", "bundles", "1 : 1", "8 : 8", "best", THREADS);
  bool agree = true;
  for (const RaySet &set : sets) {
    const Trace ways[2] = {trace1, trace8};
    double best[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    size_t hits[2] = {0, 0};
    for (unsigned round = 0; round < ROUNDS; ++round)
      for (unsigned way = 0; way < 2; ++way) {
        const Pass found = pass(scene, set, ways[way]);
        best[way] = std::min(best[way], found.seconds);
        hits[way] = found.hits;
      }
    const double one = double(set.rays) / best[0] / 1e6, eight = double(set.rays) / best[1] / 1e6;
    const float *ours = set.rates;
    std::printf("%-10s %9.2f %9.2f | %8.2f %8.2f %8.2f | %7.2f %7.2f %7.2f\n", set.name, one, eight, ours[0], ours[1],
                ours[2], ours[0] / one, ours[1] / eight, double(std::max(ours[1], ours[2])) / std::max(one, eight));
    for (const size_t found : hits) {
      const double apart = std::fabs(double(found) - double(set.hits)) / double(set.rays);
      if (apart > TOLERANCE) {
        std::printf("%-10s %zu rays hit, %u in ENDLESS: %.4f %% of %zu apart\n", "", found, set.hits, 100 * apart,
                    set.rays);
        agree = false;
      }
    }
  }
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  std::printf(agree ? "hits agree\n" : "hits do NOT agree\n");
  return agree ? 0 : 1;
}
