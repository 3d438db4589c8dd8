#include "pipeline/study/plot_data.h"

#include <algorithm>
#include <cmath>

namespace carom::pipeline::study {

PlotKeys plot_keys(const Sweep& sweep) {
    PlotKeys keys;
    std::vector<std::size_t> sampled;
    for (std::size_t i = 0; i < sweep.keys.size(); ++i) {
        const VariedKey& key = sweep.keys[i];
        (key.is_sampled() ? sampled : key.is_numeric() ? keys.axes : keys.words).push_back(i);
    }
    keys.averages = !sampled.empty() && !keys.axes.empty();
    if (keys.axes.empty()) {
        keys.axes = sampled;
    }
    return keys;
}

std::optional<double> PlotCell::mean() const {
    if (numbers.empty()) {
        return std::nullopt;
    }
    double sum = 0;
    for (const double number : numbers) {
        sum += number;
    }
    return sum / static_cast<double>(numbers.size());
}

std::optional<double> PlotCell::standard_error() const {
    const auto count = static_cast<double>(numbers.size());
    if (count < 2) {
        return std::nullopt;
    }
    double squares = 0;
    for (const double number : numbers) {
        squares += (number - *mean()) * (number - *mean());
    }
    return std::sqrt(squares / (count - 1) / count);
}

std::string PlotCell::name() const {
    std::map<std::string, int> counts;
    for (const std::string& name : names) {
        ++counts[name];
    }
    const auto most = std::ranges::max_element(
        counts, [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? "" : most->first;
}

std::vector<PlotSeries> plot_series(const Sweep& sweep, const SweepTable& table) {
    const PlotKeys keys = plot_keys(sweep);
    std::vector<PlotSeries> all;
    for (const std::vector<Value>& row : table.rows) {
        std::string name;
        for (const std::size_t i : keys.words) {
            name += (name.empty() ? "" : ", ") + std::get<std::string>(row[i]);
        }
        auto series = std::ranges::find(all, name, &PlotSeries::name);
        if (series == all.end()) {
            all.push_back({name, std::vector<PlotCells>(sweep.measures.size())});
            series = all.end() - 1;
        }
        const double x = std::get<double>(row[keys.axes[0]]);
        const double y = keys.axes.size() > 1 ? std::get<double>(row[keys.axes[1]]) : 0;
        for (std::size_t m = 0; m < sweep.measures.size(); ++m) {
            PlotCell& cell = series->cells[m][{x, y}];
            const Value& value = row[sweep.keys.size() + m];
            if (const auto* number = std::get_if<double>(&value)) {
                cell.numbers.push_back(*number);
            } else if (const auto* text = std::get_if<std::string>(&value)) {
                cell.names.push_back(*text);
            }
        }
    }
    return all;
}

}  // namespace carom::pipeline::study
