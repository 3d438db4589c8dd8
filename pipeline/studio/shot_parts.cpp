#include "pipeline/studio/shot_parts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "pipeline/config/emit_yaml.h"
#include "pipeline/config/gather.h"
#include "pipeline/config/text.h"
#include "pipeline/studio/paths.h"

namespace carom::studio {

namespace fs = std::filesystem;
namespace config = pipeline::config;
using config::Entry;
using config::Node;

namespace {

constexpr std::array<std::string_view, 5> kSections{"balls", "objects", "lights", "cameras",
                                                    "materials"};
constexpr std::size_t kLongestAbout = 90;
/// Keys whose values are names of something else than a ball or an object.
constexpr std::array<std::string_view, 8> kOtherNames{"material", "name",  "kind",    "mesh",
                                                      "image",    "noise", "physics", "texture"};

/// Balls and objects have their names together, because events and cameras refer to both.
std::string_view kind_of_name(std::string_view section) {
    return section == "balls" || section == "objects" ? "bodies" : section;
}

/// A shot with everything that it includes.
class Tree {
  public:
    Tree(const ShotText& shot, const config::OpenTexts* texts)
        : folder_(shot.folder), folders_(config::standard_config_folders()) {
        folders_.texts = texts;
        folders_.root = shot.root;
        sources_.add({"shot", shot.folder, shot.text});
        config::ProblemList problems(sources_);
        root_ = config::gather(sources_, 0, folders_, {}, problems).root;
    }

    [[nodiscard]] bool is_valid() const { return root_.has_value(); }
    [[nodiscard]] const std::string& folder() const { return folder_; }
    [[nodiscard]] const config::ConfigFolders& folders() const { return folders_; }

    /// Calls use(name, node) for all parts of a section.
    template <class Use>
    void for_parts(std::string_view section, Use use) const {
        const Entry* found = root_ && root_->is_map() ? root_->find(section) : nullptr;
        if (found == nullptr) {
            return;
        }
        for (const Entry& entry : found->value.entries) {
            use(entry.key, entry.value, entry.key_place);
        }
        for (const Node& item : found->value.items) {
            const Entry* name = item.is_map() ? item.find("name") : nullptr;
            if (name != nullptr) {
                use(name->value.text, item, item.place);
            }
        }
    }

    [[nodiscard]] const Node* find(std::string_view section, std::string_view name) const {
        const Node* result = nullptr;
        for_parts(section, [&](const std::string& key, const Node& node, const config::Place&) {
            result = key == name ? &node : result;
        });
        return result;
    }

    /// Whether a file of carom's configurations has it.
    [[nodiscard]] bool is_from_configs(const config::Place& place) const {
        if (place.source <= 0) {
            return false;
        }
        const std::string& path = sources_.at(place.source).path;
        return std::ranges::any_of(folders_.folders, [&](const std::string& folder) {
            return is_below(path, whole_path(folder));
        });
    }

    /// The folder to which a path in a value is relative.
    [[nodiscard]] const std::string& folder_of(const Node& node) const {
        return node.place.source < 0 ? folder_ : sources_.at(node.place.source).folder;
    }

  private:
    std::string folder_;
    config::ConfigFolders folders_;
    config::SourceSet sources_;
    std::optional<Node> root_;
};

Tree read_valid(const ShotText& shot, const config::OpenTexts* texts) {
    Tree tree(shot, texts);
    if (!tree.is_valid()) {
        throw Error("this file is not valid YAML");
    }
    return tree;
}

/// Gathers parts with everything that they need, and renames what the other shot has, too.
class Gatherer {
  public:
    Gatherer(const Tree& from, const Tree& to) : from_(from), to_(to) {
        for (const std::string_view section : kSections) {
            to_.for_parts(section, [&](const std::string& name, const Node&, const config::Place&) {
                taken_[kind_of_name(section)].insert(name);
            });
        }
    }

    std::vector<Addition> gather(const std::vector<PartName>& parts) {
        for (const PartName& part : parts) {
            select(part.section, part.name);
        }
        for (std::size_t i = 0; i < selected_.size(); ++i) {  // grows
            if (selected_[i].section != "materials") {
                select_materials(*selected_[i].node);
            }
        }
        std::vector<Addition> additions;
        for (const std::string_view section :
             {"materials", "balls", "objects", "lights", "cameras"}) {
            for (const Selected& one : selected_) {
                if (one.section == section) {
                    additions.push_back(addition(one));
                }
            }
        }
        return additions;
    }

  private:
    struct Selected {
        std::string section;
        std::string name;
        const Node* node = nullptr;
    };
    using Replaced = std::map<const Node*, std::string>;

    void select(const std::string& section, const std::string& name) {
        if (std::ranges::find(kSections, section) == kSections.end()) {
            throw Error("there is no section " + config::quote(section) + " to add from");
        }
        const Node* node = from_.find(section, name);
        if (node == nullptr) {
            throw Error("the other shot has no " + config::quote(name) + " in its " + section);
        }
        if (std::ranges::none_of(selected_,
                                 [&](const Selected& one) { return one.node == node; })) {
            std::string& other = names_[{std::string(kind_of_name(section)), name}];
            other = free_name(kind_of_name(section), name);
            selected_.push_back({section, name, node});
        }
    }

    std::string free_name(std::string_view kind, const std::string& name) {
        std::set<std::string>& taken = taken_[kind];
        std::string free = name;
        for (int i = 2; !taken.insert(free).second; ++i) {
            free = name + "_" + std::to_string(i);
        }
        return free;
    }

    /// The materials that a part names, unless the other shot has the same one.
    void select_materials(const Node& part) {
        for (const Entry& entry : part.entries) {
            if (entry.key == "physics") {
                continue;
            }
            const Node* material = entry.key == "material" && entry.value.is_scalar()
                                       ? from_.find("materials", entry.value.text)
                                       : nullptr;
            const Node* there =
                material != nullptr ? to_.find("materials", entry.value.text) : nullptr;
            const bool is_same =
                there != nullptr && config::emit_flow(*there) == config::emit_flow(*material);
            if (material != nullptr && !is_same) {
                select("materials", entry.value.text);
            }
            select_materials(entry.value);
        }
        for (const Node& item : part.items) {
            select_materials(item);
        }
    }

    Addition addition(const Selected& one) {
        Replaced replaced;
        find_names(*one.node, replaced);
        find_files(*one.node, replaced);
        const std::string& name = names_.at({std::string(kind_of_name(one.section)), one.name});
        if (const Entry* own = one.node->find("name"); one.section == "cameras" && own != nullptr) {
            replaced[&own->value] = name;
        }
        return {one.section, name, config::emit_flow(*one.node, replaced), one.name};
    }

    /// Names of other parts that were renamed, too.
    void find_names(const Node& node, Replaced& replaced) const {
        for (const Entry& entry : node.entries) {
            if (entry.value.is_scalar()) {
                const bool is_other =
                    std::ranges::find(kOtherNames, entry.key) != kOtherNames.end();
                const auto renamed = names_.find(
                    {entry.key == "material" ? "materials" : "bodies", entry.value.text});
                if (renamed != names_.end() && renamed->second != renamed->first.second &&
                    (entry.key == "material" || !is_other)) {
                    replaced[&entry.value] = renamed->second;
                }
            } else if (entry.key != "physics") {
                find_names(entry.value, replaced);
            }
        }
        for (const Node& item : node.items) {
            find_names(item, replaced);
        }
    }

    /// Paths that lead elsewhere from the other shot's folder.
    void find_files(const Node& node, Replaced& replaced) const {
        if (node.is_scalar() && node.text.find('.') != std::string::npos) {
            const std::string file =
                config::find_config_file(node.text, from_.folder_of(node), from_.folders()).path;
            if (!file.empty() &&
                config::find_config_file(node.text, to_.folder(), to_.folders()).path != file) {
                replaced[&node] = fs::path(file).lexically_relative(to_.folder()).string();
            }
        }
        for (const Entry& entry : node.entries) {
            find_files(entry.value, replaced);
        }
        for (const Node& item : node.items) {
            find_files(item, replaced);
        }
    }

    const Tree& from_;
    const Tree& to_;
    std::map<std::string_view, std::set<std::string>> taken_;           // names, by their kinds
    std::map<std::pair<std::string, std::string>, std::string> names_;  // new ones
    std::vector<Selected> selected_;
};

}  // namespace

std::vector<Part> read_parts(const ShotText& from, const ShotText& to,
                             const config::OpenTexts* texts) {
    const Tree tree = read_valid(from, texts);
    const Tree target(to, texts);
    std::vector<Part> parts;
    for (const std::string_view section : kSections) {
        tree.for_parts(
            section, [&](const std::string& name, const Node& node, const config::Place& place) {
                if (tree.is_from_configs(place)) {
                    return;
                }
                std::string about = config::emit_flow(node);
                if (about.size() > kLongestAbout) {
                    std::size_t end = kLongestAbout;
                    while (end > 0 && (static_cast<unsigned char>(about[end]) & 0xC0U) == 0x80U) {
                        --end;
                    }
                    about = about.substr(0, end) + "…";
                }
                parts.push_back({std::string(section), name, std::move(about),
                                 target.find(section, name) != nullptr});
            });
    }
    return parts;
}

std::vector<Addition> parts_to_add(const ShotText& from, const ShotText& to,
                                   const std::vector<PartName>& parts,
                                   const config::OpenTexts* texts) {
    const Tree tree = read_valid(from, texts);
    const Tree target(to, texts);
    return Gatherer(tree, target).gather(parts);
}

}  // namespace carom::studio
