#include "bench/line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace carom::bench {

namespace {

constexpr double kLeft = 70, kRight = 560, kTop = 40, kBottom = 340;
constexpr double kWidth = 720, kHeight = 400;
constexpr std::array<const char*, 6> kColours = {"#1b6ca8", "#c0392b", "#2e8b57",
                                                 "#8e44ad", "#d68910", "#555555"};

/// Whole powers of ten around all values.
struct LogAxis {
    double low = 1e300, high = 0;  // exponents once closed
    double from, to;               // on the page

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void close() {
        low = std::floor(std::log10(low));
        high = std::max(low + 1, std::ceil(std::log10(high)));
    }
    [[nodiscard]] double place(double value) const {
        return from + (to - from) * (std::log10(value) - low) / (high - low);
    }
};

std::string power_text(int exponent) {
    if (exponent >= 6) {
        return exponent == 6 ? "1 M" : (exponent == 7 ? "10 M" : "100 M");
    }
    if (exponent >= 0) {
        std::string digits = "1" + std::string(static_cast<std::size_t>(exponent), '0');
        if (digits.size() > 3) {
            digits.insert(digits.size() - 3, " ");
        }
        return digits;
    }
    return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + "1";
}

void add_text(std::ostream& out, double x, double y, const char* anchor, const std::string& text) {
    out << "<text x='" << x << "' y='" << y << "' text-anchor='" << anchor << "'>" << text
        << "</text>\n";
}

void add_grid(std::ostream& out, const LogAxis& x, const LogAxis& y) {
    for (int i = static_cast<int>(x.low); i <= static_cast<int>(x.high); ++i) {
        const double at = x.place(std::pow(10, i));
        out << "<path class='grid' d='M" << at << ' ' << kTop << 'V' << kBottom << "'/>\n";
        add_text(out, at, kBottom + 18, "middle", power_text(i));
    }
    for (int i = static_cast<int>(y.low); i <= static_cast<int>(y.high); ++i) {
        const double at = y.place(std::pow(10, i));
        out << "<path class='grid' d='M" << kLeft << ' ' << at << 'H' << kRight << "'/>\n";
        add_text(out, kLeft - 8, at + 4, "end", power_text(i));
    }
}

void add_line(std::ostream& out, const ChartLine& line, const char* colour, const LogAxis& x,
              const LogAxis& y) {
    out << "<path fill='none' stroke-width='2' stroke='" << colour << "' d='";
    const char* command = "M";
    for (const auto& point : line.points) {
        out << command << x.place(point.first) << ' ' << y.place(point.second) << ' ';
        command = "L";
    }
    out << "'/>\n";
    for (const auto& point : line.points) {
        out << "<circle r='3' fill='" << colour << "' cx='" << x.place(point.first) << "' cy='"
            << y.place(point.second) << "'/>\n";
    }
}

}  // namespace

void write_chart(const Chart& chart, const std::string& path) {
    LogAxis x{.from = kLeft, .to = kRight};
    LogAxis y{.from = kBottom, .to = kTop};
    for (const ChartLine& line : chart.lines) {
        for (const auto& point : line.points) {
            x.add(point.first);
            y.add(point.second);
        }
    }
    x.close();
    y.close();
    std::ostringstream out;
    out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << kWidth << ' ' << kHeight
        << "' font-family='sans-serif' font-size='12'>\n"
        << "<style>.grid{stroke:#ccc;stroke-width:1}</style>\n"
        << "<rect width='100%' height='100%' fill='white'/>\n";
    add_text(out, 0.5 * (kLeft + kRight), 22, "middle", chart.title);
    add_text(out, 0.5 * (kLeft + kRight), kHeight - 16, "middle", chart.x_label);
    out << "<text transform='translate(18 " << 0.5 * (kTop + kBottom)
        << ") rotate(-90)' text-anchor='middle'>" << chart.y_label << "</text>\n";
    add_grid(out, x, y);
    for (std::size_t i = 0; i < chart.lines.size(); ++i) {
        const char* colour = kColours[i % kColours.size()];
        add_line(out, chart.lines[i], colour, x, y);
        const double at = kTop + 20 + 20 * static_cast<double>(i);
        out << "<path stroke-width='2' stroke='" << colour << "' d='M" << kRight + 15 << ' '
            << at - 4 << "h18'/>\n";
        add_text(out, kRight + 38, at, "start", chart.lines[i].name);
    }
    out << "</svg>\n";
    std::ofstream file(path, std::ios::binary);
    file << out.str();
    if (!file.flush()) {
        throw std::runtime_error("'" + path + "' cannot be written");
    }
}

}  // namespace carom::bench
