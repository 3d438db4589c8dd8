#include "pipeline/studio/lighter_meshes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <meshoptimizer.h>

#include "render/threads/thread_arena.h"

namespace carom::studio {
namespace {

using pipeline::ExportPart;
using pipeline::ExportPatch;

constexpr float kFirstError = 0.001F;       // of the part's size
constexpr float kFirstDeviation = 0.0002F;  // m, at most, of large parts; grows as the error does
constexpr float kLastError = 0.05F;
constexpr float kErrorStep = 2;
constexpr std::size_t kFewTriangles = 64;  // a part with so few is not worth the work

std::size_t triangles_of(const pipeline::ExportScene& scene) {
    std::size_t sum = 0;
    for (const auto* parts : {&scene.parts, &scene.lamps}) {
        for (const ExportPart& part : *parts) {
            sum += part.mesh.triangles.size();
        }
    }
    return sum;
}

/// Whether triangles share vertices as in a surface. Where thousands meet at one (or lie in the
/// same place), meshopt_simplify compares each with each: 3 million equal triangles took it
/// minutes.
bool is_surface(const render::TriangleMesh& mesh, const ExportPatch& patch) {
    constexpr double kFew = 5e7;          // comparisons in a moment
    constexpr double kOfATriangle = 100;  // about 18 in a regular mesh
    std::vector<std::uint32_t> uses(mesh.vertices.size());
    double comparisons = 0;
    for (std::size_t i = patch.first; i < patch.first + patch.count; ++i) {
        for (const std::uint32_t corner : mesh.triangles[i]) {
            comparisons += 2.0 * uses[corner]++;
        }
    }
    return comparisons <= kFew + kOfATriangle * static_cast<double>(patch.count);
}

/// The triangles of a patch after simplification. `error` is relative to the size of the mesh.
std::vector<std::array<std::uint32_t, 3>> simplified(const render::TriangleMesh& mesh,
                                                     const ExportPatch& patch, float error) {
    const float size = meshopt_simplifyScale(&mesh.vertices.front().x, mesh.vertices.size(),
                                             sizeof(mesh.vertices.front()));
    const float largest = error / kFirstError * kFirstDeviation;
    const auto* corners = mesh.triangles[patch.first].data();
    const std::size_t count = 3 * patch.count;
    std::vector<std::array<std::uint32_t, 3>> result(patch.count);
    const float wanted = std::min(error, largest / size);
    const std::size_t left =
        is_surface(mesh, patch)
            ? meshopt_simplify(result.front().data(), corners, count, &mesh.vertices.front().x,
                               mesh.vertices.size(), sizeof(mesh.vertices.front()), 0, wanted,
                               meshopt_SimplifyLockBorder, nullptr)
            : meshopt_simplifySloppy(result.front().data(), corners, count,
                                     &mesh.vertices.front().x, mesh.vertices.size(),
                                     sizeof(mesh.vertices.front()), 0, wanted, nullptr);
    result.resize(left / 3);
    return result;
}

/// Removes the vertices that no triangle uses.
void compact(ExportPart& part) {
    constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
    render::TriangleMesh& mesh = part.mesh;
    std::vector<std::uint32_t> place(mesh.vertices.size(), kUnused);
    render::TriangleMesh result;
    std::vector<std::vector<Imath::V2f>> coordinates(part.coordinates.size());
    for (std::array<std::uint32_t, 3> triangle : mesh.triangles) {
        for (std::uint32_t& corner : triangle) {
            if (place[corner] == kUnused) {
                place[corner] = static_cast<std::uint32_t>(result.vertices.size());
                result.vertices.push_back(mesh.vertices[corner]);
                if (!mesh.normals.empty()) {
                    result.normals.push_back(mesh.normals[corner]);
                }
                for (std::size_t i = 0; i < coordinates.size(); ++i) {
                    coordinates[i].push_back(part.coordinates[i][corner]);
                }
            }
            corner = place[corner];
        }
        result.triangles.push_back(triangle);
    }
    mesh = std::move(result);
    part.coordinates = std::move(coordinates);
}

void simplify(ExportPart& part, float error) {
    if (part.mesh.triangles.size() <= kFewTriangles) {
        return;
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (ExportPatch& patch : part.patches) {
        const auto fewer = patch.count > 0 ? simplified(part.mesh, patch, error)
                                           : std::vector<std::array<std::uint32_t, 3>>{};
        patch.first = triangles.size();
        patch.count = fewer.size();
        triangles.insert(triangles.end(), fewer.begin(), fewer.end());
    }
    if (triangles.empty()) {
        return;
    }
    part.mesh.triangles = std::move(triangles);
    std::erase_if(part.patches, [](const ExportPatch& patch) { return patch.count == 0; });
    compact(part);
}

}  // namespace

void lighten(pipeline::ExportScene& scene, std::size_t most) {
    for (float error = kFirstError; error <= kLastError && triangles_of(scene) > most;
         error *= kErrorStep) {
        for (auto* parts : {&scene.parts, &scene.lamps}) {
            render::parallel_for(parts->size(),
                                 [&](std::size_t i) { simplify((*parts)[i], error); });
        }
    }
}

}  // namespace carom::studio
