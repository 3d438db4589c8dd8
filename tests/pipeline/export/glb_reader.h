// Reads .glb files as another program would.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace carom::testing {

inline std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// Reads a .glb as another program would.
class Glb {
  public:
    using Json = nlohmann::json;

    explicit Glb(const std::string& bytes) {
        EXPECT_EQ(bytes.substr(0, 4), "glTF");
        EXPECT_EQ(word(bytes, 4), 2U);
        EXPECT_EQ(word(bytes, 8), bytes.size());
        const std::size_t json_size = word(bytes, 12);
        EXPECT_EQ(bytes.substr(16, 4), "JSON");
        EXPECT_EQ(json_size % 4, 0U);
        json = Json::parse(bytes.substr(20, json_size));
        const std::size_t at = 20 + json_size;
        EXPECT_EQ(bytes.substr(at + 4, 4), std::string("BIN\0", 4));
        EXPECT_EQ(at + 8 + word(bytes, at), bytes.size());
        data_ = bytes.substr(at + 8);
    }

    [[nodiscard]] std::vector<float> floats(std::size_t accessor) const {
        const Json& a = json["accessors"][accessor];
        const Json& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
        std::vector<float> values(view["byteLength"].get<std::size_t>() / sizeof(float));
        std::memcpy(values.data(), data_.data() + view["byteOffset"].get<std::size_t>(),
                    values.size() * sizeof(float));
        return values;
    }

    [[nodiscard]] std::size_t node(const std::string& name) const {
        for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
            if (json["nodes"][i]["name"] == name) {
                return i;
            }
        }
        ADD_FAILURE() << "no node " << name;
        return 0;
    }

    /// The floats of an attribute of a mesh's first primitive; empty if it does not have it.
    [[nodiscard]] std::vector<float> attribute(const std::string& mesh,
                                               const std::string& name) const {
        for (const Json& one : json["meshes"]) {
            const Json& attributes = one["primitives"][0]["attributes"];
            if (one["name"] == mesh && attributes.contains(name)) {
                return floats(attributes[name].get<std::size_t>());
            }
        }
        return {};
    }

    [[nodiscard]] const Json& material(const std::string& name) const {
        for (const Json& one : json["materials"]) {
            if (one["name"] == name) {
                return one;
            }
        }
        ADD_FAILURE() << "no material " << name;
        static const Json none;
        return none;
    }

    /// The bytes of the picture to which a texture refers.
    [[nodiscard]] std::string picture(const Json& reference) const {
        const Json& texture = json["textures"][reference["index"].get<std::size_t>()];
        const Json& image = json["images"][texture["source"].get<std::size_t>()];
        const Json& view = json["bufferViews"][image["bufferView"].get<std::size_t>()];
        return data_.substr(view["byteOffset"].get<std::size_t>(),
                            view["byteLength"].get<std::size_t>());
    }

    struct Channel {
        std::vector<float> times;
        std::vector<float> values;
    };
    /// The animation channel of a node; empty if it is not animated.
    [[nodiscard]] Channel channel(const std::string& name, const std::string& path) const {
        const std::size_t wanted = node(name);
        for (const Json& c : json["animations"][0]["channels"]) {
            if (c["target"]["node"] == wanted && c["target"]["path"] == path) {
                const Json& sampler =
                    json["animations"][0]["samplers"][c["sampler"].get<std::size_t>()];
                EXPECT_EQ(sampler["interpolation"], "LINEAR");
                return {floats(sampler["input"]), floats(sampler["output"])};
            }
        }
        return {};
    }

    Json json;

  private:
    std::string data_;
};

}  // namespace carom::testing
