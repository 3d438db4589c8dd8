#include "pipeline/config/layers.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "pipeline/config/merge.h"

namespace carom::pipeline::config {

namespace {

constexpr const char* kShortSide = "short_side";

const Node* render_value(const Node& root, std::string_view key) {
    const Entry* render = root.find("render");
    const Entry* entry = render != nullptr ? render->value.find(key) : nullptr;
    return entry != nullptr && !entry->value.is_null() ? &entry->value : nullptr;
}

void remove_short_side(Node& root) {
    if (Entry* render = root.find("render")) {
        std::erase_if(render->value.entries,
                      [](const Entry& entry) { return entry.key == kShortSide; });
    }
}

/// Whether a part of the value comes from that text.
bool came_from(const Node& node, int source) {
    return node.place.source == source ||
           std::ranges::any_of(node.items,
                               [source](const Node& item) { return came_from(item, source); });
}

}  // namespace

void merge_layer(Node& base, Node layer) {
    if (render_value(layer, "size") != nullptr && render_value(layer, kShortSide) == nullptr) {
        remove_short_side(base);
    }
    merge(base, std::move(layer));
}

void merge_override(Node& root, SourceSet& sources, int source, ProblemList& problems) {
    apply_override(root, sources, source, problems);
    const Node* size = render_value(root, "size");
    const Node* short_side = render_value(root, kShortSide);
    if (size != nullptr && short_side != nullptr && came_from(*size, source) &&
        !came_from(*short_side, source)) {
        remove_short_side(root);
    }
}

}  // namespace carom::pipeline::config
