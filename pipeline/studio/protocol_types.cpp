#include "pipeline/studio/protocol_types.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <variant>
#include <vector>

#include "pipeline/studio/longest_message.h"
#include "pipeline/studio/message_fields.h"
#include "pipeline/studio/message_lists.h"

namespace carom::studio {

namespace {

/// The name of the struct without its namespace.
template <class T>
std::string struct_name() {
    const std::string_view function = __PRETTY_FUNCTION__;  // "… [with T = carom::studio::Hello; …"
    constexpr std::string_view kBefore = "T = carom::studio::";
    const std::size_t start = function.find(kBefore) + kBefore.size();
    return std::string(function.substr(start, function.find_first_of(";]", start) - start));
}

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// "timeline" as a part of another name: "Timeline".
std::string capitalised(std::string name) {
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    return name;
}

class TypeWriter {
  public:
    /// An interface that leads from the kName of each message to its type.
    template <class... Message>
    void add_map(const std::string& name, const std::string& comment,
                 std::type_identity<std::variant<Message...>> /*type*/) {
        (add_struct<Message>(), ...);
        text_ += "\n/// " + comment + "\nexport interface " + name + " {\n";
        ((text_ += "    " + std::string(Message::kName) + ": " + struct_name<Message>() + ";\n"),
         ...);
        text_ += "}\n";
    }

    /// The names of the binary messages by their type.
    template <class... Message>
    void add_types(std::type_identity<std::variant<Message...>> /*type*/) {
        text_ +=
            "\n/// The names of the binary messages by their type.\n"
            "export const kBinaryTypes: Record<number, keyof BinaryToPage> = {\n";
        ((text_ += "    [k" + capitalised(Message::kName) + "Type]: '" + Message::kName + "',\n"),
         ...);
        text_ += "};\n";
    }

    [[nodiscard]] std::string take() { return std::move(text_); }

  private:
    /// The TypeScript type of a member; structs are added before the struct that holds them.
    template <class T>
    std::string type_of() {
        if constexpr (std::same_as<T, Triple>) {
            return "Triple";
        } else if constexpr (std::same_as<T, Turn>) {
            return "Turn";
        } else if constexpr (std::same_as<T, std::array<double, 2>>) {
            return "[number, number]";
        } else if constexpr (std::same_as<T, bool>) {
            return "boolean";
        } else if constexpr (std::same_as<T, std::string>) {
            return "string";
        } else if constexpr (std::is_arithmetic_v<T>) {
            return "number";
        } else if constexpr (IsVector<T>::value) {
            return type_of<typename T::value_type>() + "[]";
        } else if constexpr (IsOptional<T>::value) {
            return type_of<typename T::value_type>();
        } else {
            add_struct<T>();
            return struct_name<T>();
        }
    }

    template <class T>
    void add_struct() {
        const std::string name = struct_name<T>();
        if (!known_.insert(name).second) {
            return;
        }
        std::string body = "\nexport interface " + name + " {\n";
        const T example{};
        for_each_field(example, [&]<class Value>(const auto& field, const Value& /*value*/) {
            const bool is_path = std::same_as<Value, KeyPath> && field.name == "path";
            body += "    " + std::string(field.name) + (IsOptional<Value>::value ? "?: " : ": ") +
                    (is_path ? "KeyPath" : type_of<Value>()) + ";\n";
        });
        text_ += body + "}\n";
        if constexpr (requires { T::kType; }) {
            add_constant<T>("Type", T::kType);
        }
        if constexpr (requires { T::kNumbersPerKey; }) {
            add_constant<T>("NumbersPerKey", T::kNumbersPerKey);
        }
        if constexpr (requires { T::kNumbersPerPoint; }) {
            add_constant<T>("NumbersPerPoint", T::kNumbersPerPoint);
        }
        if constexpr (requires { T::kNumbersPerFrame; }) {
            add_constant<T>("NumbersPerFrame", T::kNumbersPerFrame);
        }
    }

    template <class T, class Number>
    void add_constant(const std::string& what, Number value) {
        text_ +=
            "export const k" + capitalised(T::kName) + what + " = " + std::to_string(value) + ";\n";
    }

    std::string text_;
    std::set<std::string> known_;
};

}  // namespace

std::string protocol_types() {
    TypeWriter writer;
    writer.add_map("ToServer", "What the page sends, by the member \"t\".",
                   std::type_identity<PageMessage>{});
    writer.add_map("ToPage", "The texts that the server sends, by the member \"t\".",
                   std::type_identity<ServerMessage>{});
    writer.add_map("BinaryToPage", "The heads of the binary messages.",
                   std::type_identity<BinaryHead>{});
    writer.add_types(std::type_identity<BinaryHead>{});
    return "/// The messages between the studio and its page. Lengths are in metres, times in "
           "seconds, angles in\n"
           "/// radians; world axes have Z up. pipeline/studio/messages.h says what the fields "
           "mean. Generated\n"
           "/// from pipeline/studio/message_fields.h by write_protocol.\n\n"
           "export const kProtocol = '" +
           std::string(kProtocol) +
           "';\n"
           "/// Bytes of the longest message that the page may send.\n"
           "export const kLongestMessage = " +
           std::to_string(kLongestMessage) +
           ";\n\n"
           "export type Triple = [number, number, number];\n"
           "/// A unit quaternion, w first.\n"
           "export type Turn = [number, number, number, number];\n"
           "/// Keys from the top of the shot to a value; elements of lists by their index.\n"
           "export type KeyPath = string[];\n" +
           writer.take();
}

}  // namespace carom::studio
