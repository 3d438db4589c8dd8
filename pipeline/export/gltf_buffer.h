// The binary data of a glTF file and its accessors.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace carom::pipeline {

/// Collects little-endian arrays; equal arrays are stored once.
class GltfBuffer {
  public:
    enum class Use { vertices, indices, keys };

    /// `type`: "SCALAR", "VEC2", "VEC3", "VEC4". Returns the index of the accessor, which always
    /// has bounds.
    [[nodiscard]] std::size_t add(std::span<const float> values, std::string_view type, Use use);
    [[nodiscard]] std::size_t add_indices(std::span<const std::uint32_t> indices);

    /// Stores a file. Returns the index of its view.
    [[nodiscard]] std::size_t add_bytes(std::span<const std::byte> file);

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    [[nodiscard]] const nlohmann::ordered_json& views() const { return views_; }
    [[nodiscard]] const nlohmann::ordered_json& accessors() const { return accessors_; }

  private:
    std::size_t add_accessor(std::string_view bytes, nlohmann::ordered_json accessor, Use use);

    std::string bytes_;
    nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
    nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
    std::map<std::string, std::size_t, std::less<>> known_;  // by use, type and bytes
};

/// Makes the container: a header, the JSON chunk and the binary chunk, each padded to four bytes
/// (Khronos Group, glTF 2.0 Specification, section 4.4).
[[nodiscard]] std::string glb_container(const nlohmann::ordered_json& document,
                                        std::string_view bytes);

}  // namespace carom::pipeline
