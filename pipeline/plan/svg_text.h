// Writes well-formed SVG, whatever characters the names contain.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/vectors.h"

namespace carom::pipeline {

/// A number with at most two decimals (hundredths of a millimetre on paper), without trailing
/// zeros, never "-0".
[[nodiscard]] std::string svg_number(double value);

/// "x,y"
[[nodiscard]] std::string svg_point(const Vec2& point);

/// "M x,y L x,y ... " and, if closed, "Z".
[[nodiscard]] std::string svg_path(const std::vector<Vec2>& points, bool is_closed);

/// Builds one document, element by element. Text and attribute values are escaped; characters that
/// XML does not allow and bytes that are not UTF-8 become U+FFFD.
class SvgText {
  public:
    using Attributes = std::vector<std::pair<std::string_view, std::string>>;

    enum class Kind {
        document,
        fragment,  // without the XML declaration, for raw()
    };

    explicit SvgText(Kind kind = Kind::document);

    SvgText& open(std::string_view tag, const Attributes& attributes = {});
    SvgText& close();
    SvgText& leaf(std::string_view tag, const Attributes& attributes);
    /// An element that contains only text.
    SvgText& text(std::string_view tag, std::string_view content,
                  const Attributes& attributes = {});

    /// Appends a finished fragment.
    SvgText& raw(const std::string& fragment);

    /// Returns the text. All elements must be closed. The object must not be used afterwards.
    [[nodiscard]] std::string finish();

  private:
    void begin(std::string_view tag, const Attributes& attributes);

    std::string text_;
    std::vector<std::string> open_;
};

}  // namespace carom::pipeline
