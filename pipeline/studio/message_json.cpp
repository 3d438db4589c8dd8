#include "pipeline/studio/message_json.h"

#include <cstdint>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "pipeline/studio/json_writer.h"
#include "pipeline/studio/message_fields.h"

namespace carom::studio {

namespace {

using nlohmann::json;

constexpr std::size_t kAlignment = 8;       // of the payload of a binary message
constexpr std::size_t kPrefixBytes = 8;     // its type and the length of its head
constexpr std::int64_t kExact = 1LL << 53;  // whole numbers up to this one are exact in the page

/// Reads described structs from JSON and says which member is wrong.
class JsonReader {
  public:
    explicit JsonReader(std::string message) : message_(std::move(message)) {}

    template <Described T>
    void read_members(const json& object, T& value, const std::string& path, bool is_message) {
        if (!object.is_object()) {
            fail(path, "has to be an object");
        }
        std::size_t known = is_message ? 1 : 0;  // "t"
        for_each_field(value, [&](const auto& field, auto& member) {
            const std::string name(field.name);
            const std::string where = path.empty() ? name : path + "." + name;
            const auto found = object.find(name);
            if (found != object.end()) {
                ++known;
                read(*found, member, where);
            } else if (!is_optional(member)) {
                fail(where, "is missing");
            }
        });
        if (known != object.size()) {
            fail_unknown<T>(object, path, is_message);
        }
    }

  private:
    [[noreturn]] void fail(const std::string& path, const std::string& what) const {
        throw Error("message '" + message_ +
                    "': " + (path.empty() ? "the message" : "member '" + path + "'") + " " + what);
    }

    template <class T>
    static constexpr bool is_optional(const T& /*value*/) {
        return false;
    }
    template <class T>
    static constexpr bool is_optional(const std::optional<T>& /*value*/) {
        return true;
    }

    template <Described T>
    [[noreturn]] void fail_unknown(const json& object, const std::string& path, bool is_message) {
        T value{};
        for (const auto& [name, member] : object.items()) {
            bool is_known = is_message && name == "t";
            for_each_field(value, [&, &key = name](const auto& field, const auto& /*member*/) {
                is_known = is_known || field.name == key;
            });
            if (!is_known) {
                std::string place = path.empty() ? "" : path + ".";
                fail(place += name, "is unknown");
            }
        }
        fail(path, "has unknown members");
    }

    void read(const json& source, bool& value, const std::string& path) {
        if (!source.is_boolean()) {
            fail(path, "has to be true or false");
        }
        value = source.get<bool>();
    }

    void read(const json& source, std::string& value, const std::string& path) {
        if (!source.is_string()) {
            fail(path, "has to be a text");
        }
        value = source.get<std::string>();
    }

    template <std::integral T>
    void read(const json& source, T& value, const std::string& path) {
        const bool is_whole = source.is_number_integer() &&
                              !(source.is_number_unsigned() &&
                                source.get<std::uint64_t>() > static_cast<std::uint64_t>(kExact));
        const std::int64_t number = is_whole ? source.get<std::int64_t>() : 0;
        if (!is_whole || number < -kExact || number > kExact || !std::in_range<T>(number)) {
            fail(path, "has to be a whole number");
        }
        value = static_cast<T>(number);
    }

    void read(const json& source, double& value, const std::string& path) {
        if (!source.is_number()) {
            fail(path, "has to be a number");
        }
        value = source.get<double>();
    }

    template <class T>
    void read(const json& source, std::optional<T>& value, const std::string& path) {
        value.reset();
        if (!source.is_null()) {
            read(source, value.emplace(), path);
        }
    }

    template <class T>
    void read(const json& source, std::vector<T>& values, const std::string& path) {
        if (!source.is_array()) {
            fail(path, "has to be a list");
        }
        values.clear();
        for (const json& item : source) {
            read(item, values.emplace_back(), path + "." + std::to_string(values.size() - 1));
        }
    }

    template <class T, std::size_t kSize>
    void read(const json& source, std::array<T, kSize>& values, const std::string& path) {
        if (!source.is_array() || source.size() != kSize) {
            fail(path, "has to be a list of " + std::to_string(kSize));
        }
        for (std::size_t i = 0; i < kSize; ++i) {
            read(source[i], values[i], path + "." + std::to_string(i));
        }
    }

    template <Described T>
    void read(const json& source, T& value, const std::string& path) {
        read_members(source, value, path, false);
    }

    std::string message_;
};

/// Calls use.operator()<T>() for the alternative of the variant whose kName is `name`; false if
/// there is none.
template <class Variant, class Use, std::size_t... kIndex>
bool with_named(std::string_view name, Use&& use, std::index_sequence<kIndex...> /*indices*/) {
    const auto try_one = [&]<class T>(std::type_identity<T> /*type*/) {
        if (name != T::kName) {
            return false;
        }
        use.template operator()<T>();
        return true;
    };
    return (try_one(std::type_identity<std::variant_alternative_t<kIndex, Variant>>{}) || ...);
}

template <class Variant>
Variant read_message(std::string_view text) {
    const json document = json::parse(text, nullptr, false);
    if (document.is_discarded()) {
        throw Error("the message is not valid JSON");
    }
    if (!document.is_object() || !document.contains("t") || !document["t"].is_string()) {
        throw Error("the message has no member 't' with its name");
    }
    const std::string name = document["t"].get<std::string>();
    Variant result;
    const bool is_known = with_named<Variant>(
        name,
        [&]<class T>() {
            T message{};
            JsonReader(name).read_members(document, message, {}, true);
            result = std::move(message);
        },
        std::make_index_sequence<std::variant_size_v<Variant>>{});
    if (!is_known) {
        throw Error("there is no message " + json_string(name.substr(0, 40)));
    }
    return result;
}

template <class Variant>
std::string write_message(const Variant& message) {
    JsonWriter writer;
    std::visit([&](const auto& one) { writer.write_message(one); }, message);
    return writer.take();
}

void append_number(std::string& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        out += static_cast<char>((value >> shift) & 0xFFU);
    }
}

std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= static_cast<std::uint32_t>(bytes[offset + i]) << (8 * i);
    }
    return value;
}

}  // namespace

std::string to_json(const PageMessage& message) {
    return write_message(message);
}

std::string to_json(const ServerMessage& message) {
    return write_message(message);
}

PageMessage read_page_message(std::string_view text) {
    return read_message<PageMessage>(text);
}

ServerMessage read_server_message(std::string_view text) {
    return read_message<ServerMessage>(text);
}

std::string pack(const BinaryHead& head, std::span<const std::byte> payload) {
    std::string json = write_message(head);
    const std::size_t end = kPrefixBytes + json.size();
    json.append((kAlignment - end % kAlignment) % kAlignment, ' ');
    std::string message;
    message.reserve(kPrefixBytes + json.size() + payload.size());
    append_number(message, std::visit([](const auto& one) { return one.kType; }, head));
    append_number(message, static_cast<std::uint32_t>(json.size()));
    message += json;
    message.append(reinterpret_cast<const char*>(payload.data()), payload.size());
    return message;
}

Unpacked unpack(std::span<const std::byte> bytes) {
    if (bytes.size() < kPrefixBytes) {
        throw Error("the binary message is shorter than its prefix");
    }
    const std::uint32_t type = number_at(bytes, 0);
    const std::uint32_t length = number_at(bytes, 4);
    if (length > bytes.size() - kPrefixBytes) {
        throw Error("the binary message is shorter than its head");
    }
    const std::span<const std::byte> head = bytes.subspan(kPrefixBytes, length);
    Unpacked result{
        read_message<BinaryHead>({reinterpret_cast<const char*>(head.data()), head.size()}),
        bytes.subspan(kPrefixBytes + length)};
    if (std::visit([](const auto& one) { return one.kType; }, result.head) != type) {
        throw Error("the head of the binary message is of another type");
    }
    return result;
}

std::string_view name_of(const ServerMessage& message) {
    return std::visit([](const auto& one) { return std::string_view(one.kName); }, message);
}

std::string_view name_of(const BinaryHead& head) {
    return std::visit([](const auto& one) { return std::string_view(one.kName); }, head);
}

}  // namespace carom::studio
