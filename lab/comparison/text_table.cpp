#include "lab/comparison/text_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace carom::pipeline {

namespace {

/// The display width: a micro sign has two bytes and one column.
std::size_t columns_of(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
}

}  // namespace

std::string TextTable::text() const {
    std::vector<std::size_t> widths;
    for (const std::vector<std::string>& row : rows_) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], columns_of(row[i]));
        }
    }
    std::string text;
    for (const std::vector<std::string>& row : rows_) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - columns_of(row[i]), ' ');
            line += i == 0 ? row[i] + blanks : "  " + blanks + row[i];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string short_number(double value) {
    const double size = std::abs(value);
    if (size >= 99.95 || size == 0) {
        return fmt::format("{:.0f}", value);
    }
    if (size < 1e-3) {
        return fmt::format("{:.2g}", value);
    }
    return size >= 9.995     ? fmt::format("{:.1f}", value)
           : size >= 0.9995  ? fmt::format("{:.2f}", value)
           : size >= 0.09995 ? fmt::format("{:.3f}", value)
                             : fmt::format("{:.4f}", value);
}

std::string large_number(double value) {
    if (std::abs(value) >= 1e10) {
        return fmt::format("{:.0f}M", value * 1e-6);
    }
    if (std::abs(value) >= 9.9995e5) {
        return fmt::format("{:.4g}M", value * 1e-6);
    }
    return std::abs(value) >= 9999.5 ? fmt::format("{:.4g}k", value * 1e-3)
                                     : fmt::format("{:.0f}", value);
}

}  // namespace carom::pipeline
