#include "pipeline/config/combined_types.h"

namespace carom::pipeline::config {

TypeInfo any_of_info(const std::vector<AnyAlternative>& alternatives) {
    TypeInfo info;
    info.kind = TypeInfo::Kind::any_of;
    for (const AnyAlternative& alternative : alternatives) {
        info.elements.push_back(alternative.info);
    }
    return info;
}

ReadFunction read_any_of(std::vector<AnyAlternative> alternatives) {
    return [alternatives = std::move(alternatives)](Reader& reader, const Node& node, void* value) {
        for (const AnyAlternative& alternative : alternatives) {
            if (alternative.accepts(node)) {
                return alternative.read_into(reader, node, value);
            }
        }
        reader.wrong_type(node, describe(any_of_info(alternatives)));
        return false;
    };
}

}  // namespace carom::pipeline::config
