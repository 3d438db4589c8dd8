// Values at the corners of triangles that differ where triangles share a vertex.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace carom::pipeline {

namespace detail {

template <class Item>
void repeat_item(std::vector<Item>& items, std::size_t i) {
    if (!items.empty()) {
        const Item item = items[i];  // before the list grows
        items.push_back(item);
    }
}

}  // namespace detail

/// Gives the vertices of `mesh` (MeshShape or TriangleMesh) the values that its triangles have at
/// their corners. A vertex at which they differ is divided into several. Triangles keep their
/// order. Returns one value per vertex; those of vertices that no triangle uses are Value{}.
template <class Mesh, class Value>
std::vector<Value> split_vertices(Mesh& mesh, const std::vector<std::array<Value, 3>>& corners) {
    constexpr std::uint32_t kNone = 0xffff'ffff;
    std::vector<Value> values(mesh.vertices.size());
    std::vector<char> is_set(mesh.vertices.size(), 0);
    std::vector<std::uint32_t> next(mesh.vertices.size(), kNone);  // the next copy of the vertex
    const auto copy_of = [&](std::uint32_t vertex, const Value& value) {
        detail::repeat_item(mesh.vertices, vertex);
        detail::repeat_item(mesh.normals, vertex);
        detail::repeat_item(mesh.uv, vertex);
        values.push_back(value);
        next.push_back(kNone);
        return static_cast<std::uint32_t>(values.size() - 1);
    };
    const auto vertex_with = [&](std::uint32_t vertex, const Value& value) {
        if (is_set[vertex] == 0) {
            is_set[vertex] = 1;
            values[vertex] = value;
        }
        while (!(values[vertex] == value)) {
            if (next[vertex] == kNone) {
                const std::uint32_t made =
                    copy_of(vertex, value);  // before `next` is looked at: it grows
                next[vertex] = made;
            }
            vertex = next[vertex];
        }
        return vertex;
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            mesh.triangles[i][k] = vertex_with(mesh.triangles[i][k], corners[i][k]);
        }
    }
    return values;
}

}  // namespace carom::pipeline
