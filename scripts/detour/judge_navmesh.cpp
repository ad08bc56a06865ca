// Has Detour, as CARLA's client uses it, load navigation meshes and walk on them. Needs the source of Recast and Detour
// (https://github.com/recastnavigation/recastnavigation) in the folder RECAST:
//
//     NAVMESH_FOLDER=FOLDER cargo test -p endless_carla all_towns -- --ignored
//     flags="-O2 -g -fsanitize=address -I$RECAST/Detour/Include -I$RECAST/DetourCrowd/Include"
//     g++ $flags scripts/detour/judge_navmesh.cpp $RECAST/Detour{,Crowd}/Source/*.cpp -o judge_navmesh
//     ./judge_navmesh FOLDER/*.bin
//
// Prints a line a mesh; the exit status is 1 if one has a fault: it must load, places on it must be found again, most
// pairs of places on sidewalks must be joined without roads, and a crowd must get about and stay on it.

#include "DetourCrowd.h"
#include "DetourNavMesh.h"
#include "DetourNavMeshQuery.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

// CARLA's flags.
const unsigned short SIDEWALK = 2, CROSSWALK = 4;
const int PAIRS = 300, PEOPLE = 100, STEPS = 1200;
const float STEP_S = 0.05f;

struct SetHeader {
    int magic, version, tiles;
    dtNavMeshParams params;
};

struct TileHeader {
    dtTileRef ref;
    int size;
};

float draw() { return static_cast<float>(std::rand() % 100000) / 100001.0f; }

dtNavMesh *load(const char *path) {
    FILE *file = std::fopen(path, "rb");
    SetHeader head;
    if (!file || std::fread(&head, sizeof head, 1, file) != 1) return nullptr;
    if (head.magic != ('M' << 24 | 'S' << 16 | 'E' << 8 | 'T') || head.version != 1) return nullptr;
    dtNavMesh *mesh = dtAllocNavMesh();
    if (dtStatusFailed(mesh->init(&head.params))) return nullptr;
    for (int i = 0; i < head.tiles; i++) {
        TileHeader tile;
        if (std::fread(&tile, sizeof tile, 1, file) != 1) return nullptr;
        auto *data = static_cast<unsigned char *>(dtAlloc(tile.size, DT_ALLOC_PERM));
        if (std::fread(data, tile.size, 1, file) != 1) return nullptr;
        dtTileRef ref = 0;
        dtStatus status = mesh->addTile(data, tile.size, DT_TILE_FREE_DATA, tile.ref, &ref);
        if (dtStatusFailed(status) || ref != tile.ref) return nullptr;
    }
    std::fclose(file);
    return mesh;
}

bool judge(const char *path) {
    dtNavMesh *mesh = load(path);
    if (!mesh) {
        std::printf("%s: FAULT: does not load\n", path);
        return false;
    }
    dtNavMeshQuery *query = dtAllocNavMeshQuery();
    query->init(mesh, 16384);
    dtQueryFilter sidewalks, walks, all;
    sidewalks.setIncludeFlags(SIDEWALK);
    walks.setIncludeFlags(SIDEWALK | CROSSWALK);
    all.setIncludeFlags(0xffff);
    const float around[3] = {0.5f, 2.0f, 0.5f};
    int joined = 0, lost = 0;
    std::vector<dtPolyRef> way(8192);
    for (int i = 0; i < PAIRS; i++) {
        dtPolyRef from, to, nearest;
        float a[3], b[3], found[3];
        query->findRandomPoint(&sidewalks, draw, &from, a);
        query->findRandomPoint(&sidewalks, draw, &to, b);
        query->findNearestPoly(a, around, &all, &nearest, found);
        if (!nearest || std::fabs(found[0] - a[0]) + std::fabs(found[1] - a[1]) + std::fabs(found[2] - a[2]) > 0.05f) lost++;
        int count = 0;
        query->findPath(from, to, a, b, &walks, way.data(), &count, static_cast<int>(way.size()));
        if (count > 0 && way[count - 1] == to) joined++;
    }
    dtCrowd *crowd = dtAllocCrowd();
    crowd->init(500, 0.3f, mesh);
    crowd->getEditableFilter(0)->setIncludeFlags(SIDEWALK | CROSSWALK);
    dtCrowdAgentParams person;
    std::memset(&person, 0, sizeof person);
    person.radius = 0.3f;
    person.height = 1.8f;
    person.maxAcceleration = 160.0f;
    person.maxSpeed = 1.47f;
    person.collisionQueryRange = 10.0f;
    person.obstacleAvoidanceType = 3;
    person.separationWeight = 0.5f;
    person.updateFlags = DT_CROWD_ANTICIPATE_TURNS | DT_CROWD_OBSTACLE_AVOIDANCE | DT_CROWD_SEPARATION;
    float starts[PEOPLE][3];
    int people[PEOPLE];
    for (int i = 0; i < PEOPLE; i++) {
        dtPolyRef from, to;
        float target[3];
        query->findRandomPoint(&sidewalks, draw, &from, starts[i]);
        query->findRandomPoint(&sidewalks, draw, &to, target);
        people[i] = crowd->addAgent(starts[i], &person);
        crowd->requestMoveTarget(people[i], to, target);
    }
    for (int step = 0; step < STEPS; step++) crowd->update(STEP_S, nullptr);
    int still = 0, off = 0;
    double way_m = 0.0;
    for (int i = 0; i < PEOPLE; i++) {
        const float *at = crowd->getAgent(people[i])->npos;
        const double moved = std::hypot(at[0] - starts[i][0], at[2] - starts[i][2]);
        dtPolyRef nearest;
        float found[3];
        query->findNearestPoly(at, around, &walks, &nearest, found);
        way_m += moved / PEOPLE;
        still += moved < 1.0;
        off += nearest == 0;
    }
    const int polygons = static_cast<const dtNavMesh *>(mesh)->getTile(0)->header->polyCount;
    const bool good = lost == 0 && joined * 10 >= PAIRS * 8 && still * 20 <= PEOPLE && off == 0;
    std::printf("%s: %s: %d polygons, %d of %d places lost, %d pairs joined; in %.0f s %d people went %.1f m, %d stood still, %d off the mesh\n",
                path, good ? "good" : "FAULT", polygons, lost, PAIRS, joined, STEPS * STEP_S, PEOPLE, way_m, still, off);
    dtFreeCrowd(crowd);
    dtFreeNavMeshQuery(query);
    dtFreeNavMesh(mesh);
    return good;
}

}  // namespace

int main(int count, char **paths) {
    bool good = count > 1;
    for (int i = 1; i < count; i++) good = judge(paths[i]) && good;
    return good ? 0 : 1;
}
