#include "lab/comparison/curves.h"

#include <fmt/core.h>

#include "lab/comparison/text_table.h"

namespace carom::pipeline {

std::string table_of(const Curves& curves, const std::string& title, const CurveValue& value) {
    std::vector<std::size_t> columns;
    std::vector<std::string> header{title};
    for (std::size_t curve = 0; curve < curves.names.size(); ++curve) {
        for (std::size_t place = 0; place < curves.across.size(); ++place) {
            if (value(curve, place)) {
                columns.push_back(curve);
                header.push_back(curves.names[curve]);
                break;
            }
        }
    }
    if (columns.empty()) {
        return "";
    }
    TextTable table(std::move(header));
    for (std::size_t place = 0; place < curves.across.size(); ++place) {
        std::vector<std::string> row{fmt::format("{:.8g}", curves.across[place])};
        for (const std::size_t curve : columns) {
            const auto known = value(curve, place);
            row.push_back(known ? short_number(*known) : "-");
        }
        table.add(std::move(row));
    }
    return "\n" + table.text();
}

LinePanel panel_of(const Curves& curves, const std::string& title, bool is_logarithmic,
                   const CurveValue& value) {
    LinePanel panel{title, is_logarithmic, {}};
    for (std::size_t curve = 0; curve < curves.names.size(); ++curve) {
        ChartLine line{curves.names[curve], {}};
        for (std::size_t place = 0; place < curves.across.size(); ++place) {
            const auto known = value(curve, place);
            if (known && *known > 0 && curves.across[place] > 0) {
                line.points.emplace_back(curves.across[place], *known);
            }
        }
        if (!line.points.empty()) {
            panel.lines.push_back(std::move(line));
        }
    }
    return panel;
}

}  // namespace carom::pipeline
