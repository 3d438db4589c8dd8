#include "pipeline/import/read_scene.h"

#include <fmt/core.h>

#include "core/limits.h"
#include "pipeline/config/text.h"
#include "pipeline/import/scene_reader.h"

namespace carom::pipeline::scene_text {

using config::quote;

namespace {

constexpr std::size_t kMostElements = 20000;
constexpr double kLongest = 3600;  // s, of a film or a scene

/// A number of rays; 0 disables an effect.
constexpr Limits kCount{0, 1024, true, false, true};
/// The side of the matrix of rays in a pixel.
constexpr Limits kSide{0, 32, true, false, true};
constexpr Limits kTime{0, kLongest, false, false, true};

}  // namespace

std::string SceneReader::owner(const char* type, const Name& name) {
    return std::string(type) + " " + quote(name.text);
}

const std::vector<SceneReader::Element>& SceneReader::elements() {
    static const std::vector<Element> all{
        {"settings", &SceneReader::settings},
        {"camera", &SceneReader::camera},
        {"phong_info", &SceneReader::phong_info},
        {"texture", &SceneReader::texture},
        {"material_phong", &SceneReader::material_phong},
        {"material_texture", &SceneReader::material_texture},
        {"plane", &SceneReader::plane},
        {"sphere", &SceneReader::sphere},
        {"triangle", &SceneReader::triangle},
        {"rectangle", &SceneReader::rectangle},
        {"box", &SceneReader::box},
        {"light_point", &SceneReader::light_point},
        {"light_rect", &SceneReader::light_rect},
        {"light_bulb", &SceneReader::light_bulb},
    };
    return all;
}

SceneModel SceneReader::read(const std::vector<Item>& items) {
    std::vector<Item> words;  // before the next block
    std::size_t count = 0;
    for (const Item& item : items) {
        count += item.is_group ? 1 : 0;
        if (count > input_limit(kMostElements)) {
            problems_.error(item.place, beyond_limit(input_limit(kMostElements), "elements"));
            return std::move(model_);
        }
        if (!item.is_group) {
            words.push_back(item);
            continue;
        }
        if (words.empty()) {
            problems_.error(item.place, "this block has no type and no name before it");
        } else {
            element(words, item);
        }
        words.clear();
    }
    if (!words.empty()) {
        problems_.error(words.front().place,
                        quote(words.front().word) + " is not followed by a block in braces");
    }
    return std::move(model_);
}

void SceneReader::element(const std::vector<Item>& words, const Item& block) {
    // The last two words are the type and name of this block; any words before them have no block.
    for (std::size_t i = 0; i + 2 < words.size(); ++i) {
        problems_.error(words[i].place, quote(words[i].word) + " is not part of any element");
    }
    const Item& type = words[words.size() < 2 ? 0 : words.size() - 2];
    std::vector<std::string> known;
    for (const Element& element : elements()) {
        known.emplace_back(element.type);
        if (type.word != element.type) {
            continue;
        }
        if (words.size() < 2) {
            problems_.error(type.place, quote(type.word) + " needs a name before its block");
            return;
        }
        const Name name{words.back().word, words.back().place};
        (this->*element.read)(name, block);
        return;
    }
    problems_.error(type.place,
                    "unknown element " + quote(type.word) + config::hint(type.word, known));
}

void SceneReader::claim(const char* space, const Name& name, std::size_t index) {
    const auto [known, is_new] =
        names_.emplace(std::pair(std::string(space), name.text), Known{name.place, index});
    if (!is_new) {
        problems_.error(name.place, fmt::format("{} {} is already defined in line {}", space,
                                                quote(name.text), known->second.place.line));
    }
}

std::optional<std::size_t> SceneReader::refer(const char* space, const std::optional<Name>& given) {
    if (!given) {
        return std::nullopt;
    }
    const auto found = names_.find(std::pair(std::string(space), given->text));
    if (found != names_.end()) {
        return found->second.index;
    }
    std::vector<std::string> known;
    for (auto it = names_.lower_bound(std::pair(std::string(space), std::string()));
         it != names_.end() && it->first.first == space && known.size() < 1000; ++it) {
        known.push_back(it->first.second);
    }
    problems_.error(given->place, std::string(space) + " " + quote(given->text) +
                                      " is not defined above this line" +
                                      config::hint(given->text, known));
    return std::nullopt;
}

void SceneReader::settings(const Name& name, const Item& block) {
    Settings s{name, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}};
    constexpr Limits kPixels{16, 16384, true, false, true};
    attributes("settings", name)
        .real("width", s.width, kPixels)
        .real("height", s.height, kPixels)
        .real("fps", s.fps, {0, 1000, false, true, true})
        .real("interpolate_samples", s.interpolate_samples, kSide)
        .real("blur_samples", s.blur_samples, kCount)
        .real("blur_duration", s.blur_duration, kTime)
        .real("blur_switch_ratio", s.blur_switch_ratio, {0, 1, false, false, true})
        .real("dof_samples", s.dof_samples, kCount)
        .real("dof_c", s.dof_c, {0, 1e9, false, false, true})
        .real("soft_shadow_samples", s.soft_shadow_samples, kCount)
        .real("diffuse_reflection_samples", s.diffuse_reflection_samples, kCount)
        .real("diffuse_refraction_samples", s.diffuse_refraction_samples, kCount)
        .real("recursion", s.recursion, {0, 32, true, false, true})
        .read(block.group, name.place);
    if (model_.settings) {
        problems_.error(name.place, fmt::format("the settings are already defined in line {}",
                                                model_.settings->name.place.line));
        return;
    }
    model_.settings = s;
}

void SceneReader::camera(const Name& name, const Item& block) {
    Camera c;
    c.name = name;
    constexpr Limits kDistance{0, 1e9, false, true, true};
    attributes("camera", name)
        .real("video_start", c.video_start, kTime)
        .real("video_end", c.video_end, kTime)
        .real("time_start", c.time_start, kTime)
        .real("time_end", c.time_end, kTime)
        .real("DOF_start", c.dof_start, kDistance)
        .real("DOF_end", c.dof_end, kDistance)
        .real("FOV_start", c.fov_start, kDistance)
        .real("FOV_end", c.fov_end, kDistance)
        .points("add_position", c.positions)
        .required()
        .points("add_target", c.targets)
        .required()
        .vector("sky_start", c.sky_start)
        .vector("sky_end", c.sky_end)
        .read(block.group, name.place);
    for (const std::vector<Vec3>* points : {&c.positions, &c.targets}) {
        if (points->size() > 64) {
            problems_.error(name.place,
                            fmt::format("{} has a path of {} points; at most 64 are allowed",
                                        owner("camera", name), points->size()));
        }
    }
    claim("camera", name, model_.cameras.size());
    model_.cameras.push_back(std::move(c));
}

SceneModel read_scene(const std::vector<Item>& items, config::ProblemList& problems) {
    return SceneReader(problems).read(items);
}

}  // namespace carom::pipeline::scene_text
