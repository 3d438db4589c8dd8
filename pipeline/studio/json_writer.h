// Writes described structs as JSON.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fields.h"
#include "core/json_text.h"

namespace carom::studio {

/// Appends values to a JSON text.
class JsonWriter {
  public:
    void write(bool value) { text_ += value ? "true" : "false"; }
    void write(std::string_view value) { text_ += json_string(value); }
    void write(const std::string& value) { write(std::string_view(value)); }

    template <std::integral T>
    void write(T value) {
        append_number(value);
    }

    /// null if it is not finite.
    void write(double value) {
        if (std::isfinite(value)) {
            append_number(value);
        } else {
            text_ += "null";
        }
    }

    template <class T>
    void write(const std::vector<T>& values) {
        write_list(values);
    }

    template <class T, std::size_t kSize>
    void write(const std::array<T, kSize>& values) {
        write_list(values);
    }

    template <Described T>
    void write(const T& object) {
        text_ += '{';
        write_members(object);
        text_ += '}';
    }

    /// The object with the member "t" before its fields.
    template <Described T>
    void write_message(const T& message) {
        text_ += "{\"t\":\"";
        text_ += T::kName;
        text_ += "\",";
        write_members(message);
        if (text_.back() == ',') {  // it has no members
            text_.pop_back();
        }
        text_ += '}';
    }

    [[nodiscard]] std::string take() { return std::move(text_); }

  private:
    template <class T>
    void append_number(T value) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
        text_.append(digits.data(), end.ptr);
    }

    template <class List>
    void write_list(const List& values) {
        text_ += '[';
        const char* separator = "";
        for (const auto& value : values) {
            text_ += separator;
            write(value);
            separator = ",";
        }
        text_ += ']';
    }

    template <Described T>
    void write_members(const T& object) {
        const char* separator = "";
        for_each_field(object, [&](const auto& field, const auto& value) {
            write_member(separator, field.name, value);
        });
    }

    template <class T>
    void write_member(const char*& separator, std::string_view name, const T& value) {
        text_ += separator;
        text_ += '"';
        text_ += name;
        text_ += "\":";
        write(value);
        separator = ",";
    }

    /// An empty value has no member.
    template <class T>
    void write_member(const char*& separator, std::string_view name,
                      const std::optional<T>& value) {
        if (value) {
            write_member(separator, name, *value);
        }
    }

    std::string text_;
};

}  // namespace carom::studio
