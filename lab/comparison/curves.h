// Quantities of several structures over common places, as tables and as panels of charts.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "lab/comparison/chart.h"
#include "lab/comparison/text_table.h"

namespace carom::pipeline {

template <class Point>
struct Curves {
    /// Empty if it is unknown.
    using Quantity = std::function<std::optional<double>(const Point&)>;
    struct Titled {
        std::string title;
        Quantity quantity;
    };

    std::vector<std::string> names;
    std::vector<double> across;  // the places at which the curves have points, ascending
    /// By index; null if it was not measured.
    std::function<const Point*(std::size_t curve, std::size_t place)> point;

    [[nodiscard]] std::optional<double> value(const Quantity& quantity, std::size_t curve,
                                              std::size_t place) const {
        const Point* const found = point(curve, place);
        return found != nullptr ? quantity(*found) : std::nullopt;
    }

    /// A table for each quantity, with a row for each place and a column for each curve that has a
    /// value; none of a quantity without values.
    [[nodiscard]] std::string tables(const std::vector<Titled>& quantities) const {
        std::string text;
        for (const Titled& titled : quantities) {
            text += table(titled);
        }
        return text;
    }

    [[nodiscard]] ChartPanel panel(const std::string& title, bool is_logarithmic,
                                   const Quantity& quantity) const {
        ChartPanel panel{title, is_logarithmic, {}};
        for (std::size_t place = 0; place < across.size(); ++place) {
            std::vector<double>& values = panel.values.emplace_back();
            for (std::size_t curve = 0; curve < names.size(); ++curve) {
                values.push_back(value(quantity, curve, place).value_or(0));
            }
        }
        return panel;
    }

  private:
    [[nodiscard]] std::string table(const Titled& titled) const {
        std::vector<std::string> header{titled.title};
        std::vector<std::vector<std::string>> rows;
        for (const double place : across) {
            rows.push_back({fmt::format("{:.8g}", place)});
        }
        for (std::size_t curve = 0; curve < names.size(); ++curve) {
            std::vector<std::string> column;
            bool is_known = false;
            for (std::size_t place = 0; place < across.size(); ++place) {
                const auto known = value(titled.quantity, curve, place);
                is_known = is_known || known;
                column.push_back(known ? short_number(*known) : "-");
            }
            if (!is_known) {
                continue;
            }
            header.push_back(names[curve]);
            for (std::size_t place = 0; place < across.size(); ++place) {
                rows[place].push_back(column[place]);
            }
        }
        if (header.size() == 1) {
            return "";
        }
        TextTable table(std::move(header));
        for (std::vector<std::string>& row : rows) {
            table.add(std::move(row));
        }
        return "\n" + table.text();
    }
};

}  // namespace carom::pipeline
