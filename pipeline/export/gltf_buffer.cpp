#include "pipeline/export/gltf_buffer.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include <fmt/core.h>

#include "core/error.h"

namespace carom::pipeline {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr int kFloat = 5126;  // constants of the glTF specification for types and uses
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

template <class T>
std::string_view bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void append_number(std::string& text, std::uint32_t value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::size_t padding(std::size_t size) {
    return (4 - size % 4) % 4;
}

std::size_t components_of(std::string_view type) {
    return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : 4;
}

}  // namespace

std::size_t GltfBuffer::add(std::span<const float> values, std::string_view type, Use use) {
    const std::size_t components = components_of(type);
    std::vector<float> low(values.begin(), values.begin() + static_cast<long>(components));
    std::vector<float> high = low;
    for (std::size_t i = 0; i < values.size(); ++i) {
        low[i % components] = std::min(low[i % components], values[i]);
        high[i % components] = std::max(high[i % components], values[i]);
    }
    return add_accessor(bytes_of(values),
                        {{"componentType", kFloat},
                         {"count", values.size() / components},
                         {"type", type},
                         {"min", low},
                         {"max", high}},
                        use);
}

std::size_t GltfBuffer::add_indices(std::span<const std::uint32_t> indices) {
    return add_accessor(
        bytes_of(indices),
        {{"componentType", kUnsignedInt}, {"count", indices.size()}, {"type", "SCALAR"}},
        Use::indices);
}

std::size_t GltfBuffer::add_bytes(std::span<const std::byte> file) {
    views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", file.size()}});
    bytes_ += bytes_of(file);
    bytes_.append(padding(bytes_.size()), '\0');  // numbers that follow are at multiples of four
    return views_.size() - 1;
}

std::size_t GltfBuffer::add_accessor(std::string_view bytes, nlohmann::ordered_json accessor,
                                     Use use) {
    std::string key = fmt::format("{}{}{}", static_cast<int>(use),
                                  accessor["type"].get_ref<const std::string&>(), bytes);
    const auto known = known_.find(key);
    if (known != known_.end()) {
        return known->second;
    }
    nlohmann::ordered_json view{
        {"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
    if (use != Use::keys) {
        view["target"] = use == Use::vertices ? kArrayBuffer : kElementArrayBuffer;
    }
    bytes_ += bytes;
    accessor["bufferView"] = views_.size();
    views_.push_back(std::move(view));
    accessors_.push_back(std::move(accessor));
    known_.emplace(std::move(key), accessors_.size() - 1);
    return accessors_.size() - 1;
}

std::string glb_container(const nlohmann::ordered_json& document, std::string_view bytes) {
    std::string json = document.dump();
    json.append(padding(json.size()), ' ');
    const std::size_t size = 12 + 8 + json.size() + 8 + bytes.size() + padding(bytes.size());
    if (size > 0xffff'ffffU) {
        throw Error("the scene does not fit into a .glb file, which can have at most 4 GiB");
    }
    std::string file = "glTF";
    append_number(file, 2);
    append_number(file, static_cast<std::uint32_t>(size));
    append_number(file, static_cast<std::uint32_t>(json.size()));
    file += "JSON" + json;
    append_number(file, static_cast<std::uint32_t>(bytes.size() + padding(bytes.size())));
    file += std::string_view("BIN\0", 4);
    file += bytes;
    file.append(padding(bytes.size()), '\0');
    return file;
}

}  // namespace carom::pipeline
