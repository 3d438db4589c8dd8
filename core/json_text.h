// A minimal JSON writer (RFC 8259) for one flat object per line.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace carom {

/// `text` as a JSON string with quotation marks. Bytes that are not UTF-8 become U+FFFD, so that
/// the result is always valid.
[[nodiscard]] std::string json_string(std::string_view text);

/// "name":value pairs with commas between them.
class JsonMembers {
  public:
    JsonMembers& add(std::string_view name, std::string_view value);
    JsonMembers& add(std::string_view name, const std::string& value) {
        return add(name, std::string_view(value));
    }
    JsonMembers& add(std::string_view name, const char* value) {
        return add(name, std::string_view(value));
    }
    JsonMembers& add(std::string_view name, std::int64_t value);
    JsonMembers& add(std::string_view name, int value) { return add(name, std::int64_t{value}); }
    /// Writes the shortest text that reads back as the same double; null if not finite.
    JsonMembers& add(std::string_view name, double value);

    /// Writes a list: [1,2.5]
    JsonMembers& add(std::string_view name, std::span<const double> values);
    JsonMembers& add(std::string_view name, std::initializer_list<double> values) {
        return add(name, std::span(values.begin(), values.size()));
    }

    JsonMembers& add(const JsonMembers& others);

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] std::string object() const { return "{" + text_ + "}"; }

  private:
    JsonMembers& add_raw(std::string_view name, std::string_view value);

    std::string text_;
};

}  // namespace carom
