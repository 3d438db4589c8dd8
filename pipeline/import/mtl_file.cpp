#include "pipeline/import/mtl_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/core.h>

namespace carom::pipeline {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view kBlanks = " \t\r\f\v";

Words words_of(std::string_view line) {
    Words words;
    for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(kBlanks, end);
    }
    return words;
}

std::optional<double> number(std::string_view word) {
    word.remove_prefix(word.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_read = error == std::errc() && stop == word.data() + word.size();
    return is_read && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// One number stands for three.
std::optional<Vec3> colour(const Words& words) {
    const auto red = words.size() > 1 ? number(words[1]) : std::nullopt;
    const auto green = words.size() > 3 ? number(words[2]) : red;
    const auto blue = words.size() > 3 ? number(words[3]) : red;
    return red && green && blue ? std::optional(Vec3(*red, *green, *blue)) : std::nullopt;
}

/// "" for channels that a shot does not have.
std::string channel_of(std::string_view letter) {
    static const std::map<std::string_view, std::string> kChannels{
        {"r", "red"}, {"g", "green"}, {"b", "blue"}, {"m", "alpha"}, {"l", "luminance"}};
    const auto known = kChannels.find(letter);
    return known == kChannels.end() ? std::string() : known->second;
}

/// `word`: the last value as it was written.
void set_option(std::string_view option, std::string_view word, const std::array<double, 2>& values,
                MtlPicture& result) {
    if (option == "-s") {
        result.scale = {values[0], values[1]};
    } else if (option == "-o") {
        result.offset = {values[0], values[1]};
    } else if (option == "-bm") {
        result.bump = values[0];
    } else if (option == "-mm") {
        result.range = {values[0], values[0] + values[1]};
    } else if (option == "-imfchan") {
        result.channel = channel_of(word);
    }
}

/// The file is the rest of the line after the options, because names may have blanks.
std::optional<MtlPicture> picture(const Words& words) {
    /// How many values an option has; -o, -s and -t have up to three.
    static const std::map<std::string_view, std::size_t> kValues{
        {"-blendu", 1}, {"-blendv", 1},  {"-bm", 1},  {"-boost", 1}, {"-cc", 1},
        {"-clamp", 1},  {"-imfchan", 1}, {"-mm", 2},  {"-o", 3},     {"-s", 3},
        {"-t", 3},      {"-texres", 1},  {"-type", 1}};
    MtlPicture result;
    std::size_t at = 1;
    while (at < words.size()) {
        const auto option = kValues.find(words[at]);
        if (option == kValues.end()) {
            break;
        }
        std::array<double, 2> values{option->first == "-s" ? 1.0 : 0.0,
                                     option->first == "-s" ? 1.0 : 0.0};
        ++at;
        for (std::size_t i = 0; i < option->second && at < words.size(); ++i, ++at) {
            const auto value = number(words[at]);
            if (option->second == 3 && !value) {
                break;
            }
            if (i < 2) {
                values[i] = value.value_or(0);
            }
        }
        set_option(option->first, words[at - 1], values, result);
    }
    if (at == words.size()) {
        return std::nullopt;
    }
    result.file.assign(words[at].data(), words.back().data() + words.back().size());
    return result;
}

class MtlReader {
  public:
    /// Whether the line could be read.
    bool read_line(const Words& words, MtlFile& file) {
        const std::string_view key = words[0];
        if (key == "newmtl") {
            const bool has_name = words.size() > 1;
            const std::string name =
                has_name ? std::string(words[1].data(), words.back().data() + words.back().size())
                         : std::string();
            material_ = &(file.materials[name] = MtlMaterial{});
            return has_name;
        }
        return material_ != nullptr && read_value(words, key, *material_);
    }

  private:
    static bool read_value(const Words& words, std::string_view key, MtlMaterial& m) {
        const std::map<std::string_view, std::optional<Vec3>*> colours{
            {"Kd", &m.diffuse}, {"Ks", &m.specular}, {"Ke", &m.emission}};
        const std::map<std::string_view, std::optional<double>*> numbers{
            {"Ns", &m.shininess}, {"Pr", &m.roughness}, {"Pm", &m.metal},
            {"Ps", &m.sheen},     {"d", &m.opacity},    {"Tr", &m.opacity},
            {"Ni", &m.ior},       {"Pc", &m.coat},      {"Pcr", &m.coat_roughness}};
        if (const auto known = colours.find(key); known != colours.end()) {
            *known->second = colour(words);
            return known->second->has_value();
        }
        if (const auto known = numbers.find(key); known != numbers.end()) {
            *known->second = words.size() > 1 ? number(words.back()) : std::nullopt;
            if (key == "Tr" && m.opacity) {
                m.opacity = 1 - *m.opacity;
            }
            return known->second->has_value();
        }
        if (key == "illum") {
            const auto model = words.size() > 1 ? number(words[1]) : std::nullopt;
            m.illumination = model ? std::optional(static_cast<int>(std::clamp(*model, 0.0, 10.0)))
                                   : std::nullopt;
            return model.has_value();
        }
        static const std::map<std::string_view, std::string> kPictures{
            {"map_Kd", "map_Kd"},     {"map_Ke", "map_Ke"},     {"map_Pr", "map_Pr"},
            {"map_Pm", "map_Pm"},     {"map_Ps", "map_Ps"},     {"map_d", "map_d"},
            {"map_Bump", "map_Bump"}, {"map_bump", "map_Bump"}, {"bump", "map_Bump"},
            {"Bump", "map_Bump"},     {"norm", "norm"},         {"map_Kn", "norm"}};
        if (const auto known = kPictures.find(key); known != kPictures.end()) {
            const std::optional<MtlPicture> read = picture(words);
            if (read) {
                m.pictures[known->second] = *read;
            }
            return read.has_value();
        }
        if (key != "Ka") {  // ambient light is not of the material
            m.ignored.emplace(key.substr(0, 40));
        }
        return true;
    }

    MtlMaterial* material_ = nullptr;
};

}  // namespace

MtlFile read_mtl(std::string_view text) {
    MtlFile file;
    MtlReader reader;
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);
    }
    int line = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        const Words words = words_of(text.substr(at, end - at));
        at = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
        ++line;
        const bool has_statement = !words.empty() && !words[0].starts_with('#');
        if (has_statement && !reader.read_line(words, file) && file.problem.empty()) {
            file.problem = fmt::format("line {} cannot be read and is ignored", line);
        }
    }
    return file;
}

}  // namespace carom::pipeline
